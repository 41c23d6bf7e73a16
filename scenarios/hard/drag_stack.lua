-- The lowest of six boxes is dragged along, gently: the others ride on it by friction.
local speed, up = 1, 2   -- m/s, reached after so many seconds: half a metre per second squared, friction allows five

scenario {
  title = "A stack is dragged along",
  description = "A limited force drags the lowest of six boxes over a rough floor; the others must ride along upright.",
  duration = 8, rate = 60, fps = 60, gravity = {0, -10}, method = { substeps = 4 }, effects = "auto",
  view = { center = {2.2, 2.9}, height = 7.4 }, layers = { "bodies", "contacts" },
  golden = { frames = { 479 }, size = {480, 270} },
}
include "include/gates.lua"

ground { y = 0, friction = 0.5 }
local boxes = {}
for i = 1, 6 do
  boxes[i] = body { name = "box " .. i, at = { 0, i - 0.5 }, shape = box { width = 1, height = 1 }, friction = 0.5 }
end
-- The floor brakes with 0.5 * 60 N, the gain of speed takes 3 N; the drag acts at half a metre, which tilts with
-- 16.5 N m, and the weight holds with 30 N m. (Of the boxes above, each is accelerated by less than a tenth of what
-- it would tip at.)
local drag = drag_to { boxes[1], target = { 0, 0.5 }, max_force = 200 }
local function way(t)   -- two seconds to get going, two on the way, two to brake, and rest
  if t < up then return speed * t * t / (2 * up) end
  if t < 4 then return speed * (t - up / 2) end
  local left = math.max(0, 6 - t)
  return speed * 4 - speed * left * left / (2 * up)
end
every(1 / 60, function() drag:set { target = { way(time()), 0.5 } } end)

no_overlap(1, 1)
local function lean()
  local most = 0
  for _, b in ipairs(boxes) do
    most = math.max(most, math.abs(b:position().x - boxes[1]:position().x), math.abs(b:angle()))
  end
  return most
end
measure("lean", lean)
measure("x", function() return boxes[1]:position().x end)
expect("the stack stays upright", function() return lean() < 0.1 and boxes[6]:position().y > 5.4 end, { always = true })
expect("quality: it does not shift by a centimetre", function() return lean() < 0.01 end, { always = true })
expect("the stack has come along", function() return math.abs(boxes[6]:position().x - way(8)) < 0.1 end)
