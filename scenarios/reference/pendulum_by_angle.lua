-- The pendulum of pendulum_60 in minimal coordinates, so that integrators without constraints can be compared on it: x
-- is the angle (1 m for 1 radian), the force on 1 kg is -(g / l) sin x. Jacobi's sn (C. G. J. Jacobi 1829).
scenario {
  title = "Pendulum from 60 degrees, by its angle", duration = 10, gravity = {0, 0}, rate = 240,
  description = "The equation of the pendulum as a motion on a line: no rod, only its force.",
  view = { center = {0, 0}, height = 1.6 }, layers = { "bodies", "trails", "vectors", "grid" },
  golden = { frames = { 0, 33, 599 }, size = {480, 270} },
}
include "include/math_reference.lua"

local from, omega = math.rad(60), math.sqrt(9.81)
local angle = body { name = "angle", at = {from, 0}, mass = 1, shape = circle { radius = 0.05 } }
field(function(x) return -omega ^ 2 * math.sin(x), 0 end)

measure("angle", function() return angle:position().x end)
reference("angle", function(t) return (pendulum_at(t, from, omega)) end)
measure("spin", function() return angle:velocity().x end)
reference("spin", function(t)
  local _, spin = pendulum_at(t, from, omega)
  return spin
end)
measure("energy", function()                                    -- from the lowest point, by m g l
  return energy().kinetic / omega ^ 2 + 1 - math.cos(angle:position().x)
end)
reference("energy", function() return 0.5 end)
expect("after 10 s its angle is -0.651863046742, to 0.0005",
       function() return math.abs(angle:position().x + 0.651863046741975928) <= 5e-4 end)
vector { body = angle, of = "velocity", scale = 0.12 }
