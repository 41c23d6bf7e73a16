-- Gravity and friction all but cancel here: a thousandth too much of normal force takes 8 percent off the way.
scenario {
  title = "Not quite enough friction", duration = 10,
  rate = 60, fps = 60, gravity = {0, -9.81}, method = { substeps = 4 },
  description = "A block on 30 degrees with a coefficient of 0.57: it must slide, and as far as Coulomb says.",
  view = { center = {0, 0.2}, height = 5.2 }, layers = { "bodies", "contacts" },
  golden = { frames = { 0, 599 }, size = {480, 270} },
}
include "include/gates.lua"
include "include/incline.lua"

local block, slid, acceleration = block_on_incline(0.57)
local way = acceleration * 10 * 10 / 2
expect("it slides: as far as Coulomb says to 10 percent", function() return math.abs(slid() - way) <= 0.1 * way end)
expect("quality: as far as Coulomb says to 1 percent", function() return math.abs(slid() - way) <= 0.01 * way end)
no_overlap(0.5, 0.5)
no_energy_gained({ block }, 3)
