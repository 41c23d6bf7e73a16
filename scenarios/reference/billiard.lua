-- Sixty impacts with walls at any angle, nothing between them: errors are those of the located times alone.
-- Unfolding the table makes the way a straight line (see S. Tabachnikov, Geometry and Billiards, 2005).
scenario {
  title = "Rectangular billiard", duration = 100, rate = 120, fps = 60, gravity = {0, 0},
  description = "A ball on a table of 10 by 6 m without friction: after 100 s it is at (9, 3).",
  method = { contact_solver = "event" }, view = { center = {5, 3}, height = 8 }, layers = { "bodies", "trails" },
  golden = { frames = { 0, 600, 5999 }, size = {480, 270} },
}
include "include/math_reference.lua"

local width, height, r, vx, vy = 10, 6, 0.2, 3.7, 2.3               -- the table is the centre's
local function cushion(name, x, y, w, h)
  body { name = name, type = "static", at = {x, y}, friction = 0, restitution = 1,
         shape = box { width = w, height = h } }
end
cushion("left", -r - 0.25, height / 2, 0.5, height + 2 * r)
cushion("right", width + r + 0.25, height / 2, 0.5, height + 2 * r)
cushion("lower", width / 2, -r - 0.25, width + 1 + 2 * r, 0.5)
cushion("upper", width / 2, height + r + 0.25, width + 1 + 2 * r, 0.5)
local ball = body { name = "ball", at = {1, 1}, velocity = {vx, vy}, friction = 0, restitution = 1,
                    shape = circle { radius = r } }
measure("x", function() return ball:position().x end)
reference("x", function(t) return folded(1 + vx * t, width) end)
measure("y", function() return ball:position().y end)
reference("y", function(t) return folded(1 + vy * t, height) end)
expect("after 100 s it is at (9, 3), to 1e-6 m", function()
  local p = ball:position()
  return math.abs(p.x - 9) <= 1e-6 and math.abs(p.y - 3) <= 1e-6
end)
trail { body = ball, seconds = 6 }
