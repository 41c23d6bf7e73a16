-- Long runs of a smooth problem without constraints: sixteen turns of an eccentric orbit, as in E. Hairer, C. Lubich
-- and G. Wanner, Geometric Numerical Integration (2002). The ellipse by Kepler's equation (1609).
scenario {
  title = "Kepler's ellipse", duration = 100, gravity = {0, 0}, theme = "dark", rate = 120, fps = 60,
  description = "A planet on an ellipse of eccentricity 0.6; errors along the way grow with the time, or its square.",
  view = { center = {-0.6, 0}, height = 2.2 }, layers = { "bodies", "trails" },
  golden = { frames = { 0, 150, 5999 }, size = {480, 270} }, method = { substeps = 4 },
}
include "include/math_reference.lua"

local e = 0.6
body { name = "sun", type = "static", at = {0, 0}, shape = circle { radius = 0.09 }, color = 0xE69F00, group = -1 }
local planet = body { name = "planet", at = { 1 - e, 0 }, velocity = { 0, math.sqrt((1 + e) / (1 - e)) }, mass = 1,
                      shape = circle { radius = 0.04 }, group = -1 }
attractor { at = {0, 0}, strength = 1 }

measure("x", function() return planet:position().x end)
reference("x", function(t) return (kepler_at(t, e)) end)
measure("y", function() return planet:position().y end)
reference("y", function(t) return (select(2, kepler_at(t, e))) end)
measure("energy", function() return energy().total end)
reference("energy", function() return -0.5 end)
measure("angular momentum", function()
  local p, v = planet:position(), planet:velocity()
  return p.x * v.y - p.y * v.x
end)
reference("angular momentum", function() return math.sqrt(1 - e * e) end)

expect("after 100 s it is at (-0.104183204434, -0.694741715568), to 2 cm", function()
  local p = planet:position()
  return math.sqrt((p.x + 0.104183204434180605) ^ 2 + (p.y + 0.694741715567950599) ^ 2) <= 2e-2
end)
expect("the angular momentum stays to 1e-12", function()
  local p, v = planet:position(), planet:velocity()
  return math.abs(p.x * v.y - p.y * v.x - math.sqrt(1 - e * e)) <= 1e-12
end, { always = true })
trail { body = planet, seconds = 6.2 }
