-- The double pendulum in minimal coordinates, so that integrators without constraints can be compared on it: x and y
-- are its angles. Lagrange's equations (1788); values by Taylor series with 50 digits, see include/double_pendulum.lua.
scenario {
  title = "Double pendulum, by its angles", duration = 5, gravity = {0, 0}, rate = 240,
  description = "The motion of a double pendulum as the way of a point in the plane of its angles.",
  view = { center = {0, 0}, height = 5 }, layers = { "bodies", "trails", "grid" },
  golden = { frames = { 0, 60, 299 }, size = {480, 270} },
}
include "include/double_pendulum.lua"

local g = 9.81
local point = body { name = "angles", at = { math.pi / 2, math.pi / 2 }, mass = 1, shape = circle { radius = 0.09 } }
-- (2, c; c, 1) (a'', b'') = (-s b'^2 - 2 g sin a, s a'^2 - g sin b), where c and s are of a - b
field(function(a, b, da, db)
  local c, s = math.cos(a - b), math.sin(a - b)
  local first, second = -s * db ^ 2 - 2 * g * math.sin(a), s * da ^ 2 - g * math.sin(b)
  local determinant = 2 - c * c
  return (first - c * second) / determinant, (2 * second - c * first) / determinant
end)

measure("upper angle", function() return point:position().x end)
reference("upper angle", double_pendulum_table(function(a) return a end, 5))
measure("lower angle", function() return point:position().y end)
reference("lower angle", double_pendulum_table(function(_, b) return b end, 5))
measure("energy", function()                                    -- from the lowest point, by m g l
  local p, v = point:position(), point:velocity()
  return (v.x ^ 2 + v.y ^ 2 / 2 + v.x * v.y * math.cos(p.x - p.y)) / g + 3 - 2 * math.cos(p.x) - math.cos(p.y)
end)
reference("energy", function() return 3 end)
expect("after 5 s the angles are -0.627186705067 and -1.30131555021, to 0.005", function()
  local p = point:position()
  return math.abs(p.x + 0.627186705066530730) <= 5e-3 and math.abs(p.y + 1.30131555020981168) <= 5e-3
end)
trail { body = point, seconds = 1.5 }
