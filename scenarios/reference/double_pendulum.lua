-- What is left of an integrator's order where errors grow exponentially: two rigid rods, a chaotic motion.
-- No closed form (H. Poincare 1892); values by Taylor series with 50 digits, see include/double_pendulum.lua.
scenario {
  title = "Double pendulum", duration = 10, view = { center = {0, -0.3}, height = 4.6 },
  description = "Two points on rods, both let go level with the pivot: chaos, known to twelve digits.",
  layers = { "bodies", "joints", "trails" }, golden = { frames = { 0, 60, 599 }, size = {480, 270} },
}
include "include/double_pendulum.lua"

local elbow = body { name = "elbow", at = {1, 0}, mass = 1, shape = circle { radius = 0.07 }, group = -1 }
local tip = body { name = "tip", at = {2, 0}, mass = 1, shape = circle { radius = 0.07 }, group = -1 }
distance { world, elbow, from = {0, 0}, to = {1, 0} }
distance { elbow, tip, from = {1, 0}, to = {2, 0} }

local sin, cos = math.sin, math.cos
local places = {
  ["elbow x"] = { function() return elbow:position().x end, function(a) return sin(a) end },
  ["elbow y"] = { function() return elbow:position().y end, function(a) return -cos(a) end },
  ["tip x"] = { function() return tip:position().x end, function(a, b) return sin(a) + sin(b) end },
  ["tip y"] = { function() return tip:position().y end, function(a, b) return -cos(a) - cos(b) end },
}
for name, place in pairs(places) do
  measure(name, place[1])
  reference(name, double_pendulum_table(place[2], 10))
end
for _, e in ipairs { { 1, 5e-4 }, { 5, 5e-3 }, { 10, 2e-2 } } do
  local t, most = e[1], e[2]
  local x, y = double_pendulum_table(places["tip x"][2], t), double_pendulum_table(places["tip y"][2], t)
  x, y = x[#x][2], y[#y][2]
  expect(("after %g s the tip is where it should be, to %g mm"):format(t, 1000 * most), function()
    local p = tip:position()
    return math.sqrt((p.x - x) ^ 2 + (p.y - y) ^ 2) <= most
  end, { at = t })
end
measure("energy", function() return energy().total / 9.81 + 3 end)      -- from the lowest point
reference("energy", function() return 3 end)
expect("the energy stays within a thousandth of m g l", function() return math.abs(energy().total) <= 9.81e-3 end,
       { always = true })
trail { body = tip, seconds = 1 }
