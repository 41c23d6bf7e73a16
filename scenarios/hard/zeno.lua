-- A ball that keeps half its speed makes infinitely many impacts in finite time: with sqrt(2 h / g) for the fall all is
-- over at sqrt(2 h / g) (1 + e) / (1 - e), after a way of h (1 + e^2) / (1 - e^2).
scenario {
  title = "Zeno's ball", duration = 2, rate = 60, fps = 60, gravity = {0, -9.81},
  method = { substeps = 4, contact_solver = "event" },
  description = "Infinitely many impacts in 1.3546 s: whoever locates every impact never gets past it.",
  view = { center = {0, 0.62}, height = 1.5 }, layers = { "bodies", "trails" },
  golden = { frames = { 0, 119 }, size = {480, 270} },
}
include "include/gates.lua"

local drop, e, radius, g = 1, 0.5, 0.1, 9.81
ground { y = 0, friction = 0 }
local ball = body { name = "ball", at = {0, drop + radius}, restitution = e, friction = 0,
                    shape = circle { radius = radius } }
trail { body = ball, seconds = 2 }
local function gap() return ball:position().y - radius end
measure("gap", gap)

local impacts, last_moving, way, was = 0, 0, 0, drop
on_contact(ball, nil, function() impacts = impacts + 1 end)
every(1 / 60, function()
  if math.abs(ball:velocity().y) > 1e-3 or gap() > 1e-5 then last_moving = time() end
  way, was = way + math.abs(gap() - was), gap()
end)
local stop = math.sqrt(2 * drop / g) * (1 + e) / (1 - e)
local substep = 1 / 240
measure("last seen moving", function() return last_moving end)
measure("impacts", function() return impacts end)
measure("way seen", function() return way end)
expect("it comes to rest when the sum of all flights is over, to two substeps",
       function() return math.abs(last_moving - stop) <= 2 * substep end)
-- After the n-th impact it flies for 2 e^n sqrt(2 h / g): longer than a substep up to the seventh.
expect("it makes all impacts that a substep tells apart, at least eight, and not endlessly many",
       function() return impacts >= 8 and impacts <= 60 end)
local first_apex = math.sqrt(2 * drop / g) * (1 + e)
expect("the first apex is a quarter of the drop to a tenth of a millimetre, seen on a frame nearby", function()
  local from_apex = math.floor(first_apex * 60 + 0.5) / 60 - first_apex
  return math.abs(gap() - (e^2 * drop - g * from_apex^2 / 2)) <= 1e-4
end, { at = math.floor(first_apex * 60 + 0.5) / 60 })
expect("it lies still in the end",
       function() return math.abs(gap()) <= 1e-5 and math.abs(ball:velocity().y) <= 1e-6 end)
no_overlap(2 * radius, 0)
no_energy_gained({ ball }, drop, g)
