-- Friction at rest: with a coefficient above tan 30 = 0.577 a block stays where it is, and does not creep.
-- C. A. Coulomb 1785.
scenario {
  title = "A block holds", duration = 10, rate = 240, view = { center = {0, 0.1}, height = 2.6 },
  description = "30 degrees, coefficient 0.6: it does not move in ten seconds.",
  layers = { "bodies", "contacts" }, golden = { frames = { 0, 599 }, size = {480, 270} },
}
include "include/incline.lua"

local slid, exact = block_on_incline(0.6, {0.4, 0.3}, 3)
measure("slid", slid)
reference("slid", exact)
expect("it does not creep by a nanometre", function() return math.abs(slid()) <= 1e-9 end, { always = true })
