scenario {
  title = "Just enough friction", duration = 10, rate = 60, fps = 60, gravity = {0, -9.81}, method = { substeps = 4 },
  description = "A block on 30 degrees with a coefficient of 0.6: it must not creep, where most engines let it.",
  view = { center = {0, 0.2}, height = 5.2 }, layers = { "bodies", "contacts" },
  golden = { frames = { 599 }, size = {480, 270} },
}
include "include/gates.lua"
include "include/incline.lua"

local block, slid = block_on_incline(0.6)
expect("it stays: it creeps by less than a millimetre in ten seconds", function() return math.abs(slid()) <= 1e-3 end,
       { always = true })
no_overlap(0.5, 0.5)
no_energy_gained({ block }, 1)
