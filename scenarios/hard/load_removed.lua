-- Solver2D's WarmStartEnergy: what remembers the impulses of the step before must not pay them out to nobody.
scenario {
  title = "The load is gone", duration = 4, rate = 60, fps = 60, gravity = {0, -10}, method = { substeps = 4 },
  description = "Two discs carry one a hundred times as heavy until it vanishes: springs throw them up.",
  view = { center = {0, 1.6}, height = 4 }, layers = { "bodies", "contacts" },
  golden = { frames = { 119, 239 }, size = {480, 270} },
}
include "include/gates.lua"

ground { y = 0 }
local function disc(name, y, density)
  return body { name = name, at = {0, y}, shape = circle { radius = 0.5 }, density = density }
end
local low, middle, load = disc("low", 0.5, 1), disc("middle", 1.5, 1), disc("load", 2.5, 100)
local function sink() return 2.5 - load:position().y end
expect("quality: while it lasts the load sinks by less than 2 cm", function() return time() >= 2 or sink() <= 0.02 end,
       { always = true })
at(2, function() load:remove() end)

measure("low", function() return low:position().y - 0.5 end)
measure("middle", function() return middle:position().y - 1.5 end)
expect("nothing jumps: neither rises by more than a centimetre above where it began", function()
  return low:position().y - 0.5 <= 0.01 and middle:position().y - 1.5 <= 0.01
end, { always = true })
expect("quality: both lie where they began to a millimetre in the end", function()
  return math.abs(low:position().y - 0.5) <= 1e-3 and math.abs(middle:position().y - 1.5) <= 1e-3
end)
no_overlap(1, 1)
