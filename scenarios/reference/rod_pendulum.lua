-- A body with inertia on a hinge: the rod swings as a point at two thirds of its length would (C. Huygens 1673), by
-- Jacobi's sn. At the bottom the hinge bears 5/2 of the weight: 1 + (3 / 2) (1 - cos 90 degrees), from the energy.
scenario {
  title = "Rod on a hinge", duration = 10, view = { center = {0, -0.4}, height = 1.8 },
  description = "A uniform rod of 1 m is let go level with its hinge.",
  layers = { "bodies", "joints", "vectors" }, golden = { frames = { 0, 29, 599 }, size = {480, 270} },
}
include "include/math_reference.lua"

local g, length, mass, from = 9.81, 1, 1, math.pi / 2
local omega = math.sqrt(3 * g / (2 * length))
local rod = body { name = "rod", at = { length / 2, 0 }, mass = mass, inertia = mass * length ^ 2 / 12,
                   shape = box { width = length, height = 0.06 } }
local hinge = revolute { world, rod, at = {0, 0} }
local function angle() return rod:angle() + from end         -- from straight down

measure("angle", angle)
reference("angle", function(t) return (pendulum_at(t, from, omega)) end)
measure("spin", function() return rod:spin() end)
reference("spin", function(t)
  local _, spin = pendulum_at(t, from, omega)
  return spin
end)
measure("energy", function() return energy().total / (mass * g * length) + 0.5 end)   -- from the lowest point
reference("energy", function() return 0.5 end)

local period = pendulum_period(from, omega)
expect("its period is 1.93333485437 s", function() return math.abs(period - 1.93333485437324578) <= 1e-12 end)
expect("after 10 s its angle is 0.770957622575, to 0.001",
       function() return math.abs(angle() - 0.770957622574773133) <= 1e-3 end)
expect("upright for the first time it turns by sqrt(3 g / L), to a thousandth", function()
  return math.abs(rod:spin() / -math.sqrt(3 * g / length) - 1) <= 1e-3
end, { at = period / 4 })
expect("there the hinge bears 5/2 of its weight, to a thousandth", function()
  local force = hinge:reaction()
  return math.abs(math.sqrt(force.x ^ 2 + force.y ^ 2) / (mass * g) - 2.5) <= 2.5e-3
end, { at = period / 4 })
expect("the energy stays within 1e-4 m g L", function() return math.abs(energy().total) <= 1e-4 * mass * g * length end,
       { always = true })
vector { body = rod, of = "velocity", scale = 0.1 }
