-- A thin plank, fast and spinning, over a post: either of the two can pass through the other. And a ball into a notch.
scenario {
  title = "A spinning plank over a post",
  description = "Planks of 4 x 0.1 m at 100 m/s and 50 rad/s, and a ball at 200 m/s into a wedge; nothing may tunnel.",
  duration = 3, rate = 60, fps = 60, gravity = {0, -10}, method = { substeps = 4 }, effects = "auto",
  view = { center = {0, 4}, height = 10 }, layers = { "bodies", "contacts" },
  golden = { frames = { 179 }, size = {480, 270} },
}
include "include/gates.lua"

-- The floor is thin as well, so that what passes it does not come back.
body { name = "floor", type = "static", at = {0, -0.05}, shape = box { width = 40, height = 0.1 } }
local moving = {}
for i, spin in ipairs { -50, 50 } do
  local x = (i - 1.5) * 14
  body { name = "post", type = "static", at = { x, 1 }, shape = box { width = 0.2, height = 2 } }
  moving[i] = body { name = spin < 0 and "plank, clockwise" or "plank, counter-clockwise", at = { x, 8 },
                     velocity = { 0, -100 },
                     spin = spin, shape = box { width = 4, height = 0.1 } }
end
-- A slanted and an upright side meet at the floor.
wall { a = {-3, 6}, b = {0, 0.2} }
wall { a = {0, 0.2}, b = {0, 6} }
local ball = body { name = "ball", at = {-0.35, 8}, velocity = { 0, -200 }, shape = circle { radius = 0.3 } }
moving[3] = ball

no_overlap(0.1, 2)
no_energy_gained(moving, 8 + 200 ^ 2 / 20)
local function lowest()
  local y = 100
  for _, b in ipairs(moving) do y = math.min(y, b:position().y) end
  return y
end
measure("lowest", lowest)
-- In the wedge the centre stays off both sides by the radius, to a tenth of it.
local wedge = math.sqrt(3 ^ 2 + 5.8 ^ 2)
local function room()
  local p = ball:position()
  return math.min(-p.x, (3 * (p.y - 0.2) + 5.8 * p.x) / wedge) - 0.3
end
measure("room in the wedge", room)
-- A plank that passed through the post would have it inside; the post's axis must never be crossed below its top.
local function through_post(b, x)
  local p, a = b:position(), b:angle()
  local dx, dy = x - p.x, 1 - p.y   -- the post's middle, seen from the plank
  local u, v = math.cos(a) * dx + math.sin(a) * dy, -math.sin(a) * dx + math.cos(a) * dy
  return math.abs(u) < 2 and math.abs(v) < 0.05
end
expect("nothing passes the floor", function() return lowest() > 0 end, { always = true })
expect("no plank has the post's middle inside", function()
  return not through_post(moving[1], -7) and not through_post(moving[2], 7)
end, { always = true })
expect("the ball stays in the wedge", function() return room() > -0.1 end, { always = true })
expect("quality: the ball rests in the wedge", function() return math.abs(room()) < 3e-3 end)
