-- A ball that gives back everything: eight bounces, and not a per cent of its height gained or lost.
scenario {
  title = "A perfectly elastic ball",
  description = "e = 1 from 2 m: Bullet's users saw over half of the height lost.",
  duration = 10, rate = 60, fps = 60, gravity = {0, -10}, method = { substeps = 4 }, effects = "auto",
  view = { center = {0, 1.3}, height = 3.6 }, layers = { "bodies", "trails" },
  golden = { frames = { 599 }, size = {480, 270} },
}
include "include/gates.lua"

ground { y = 0 }
local radius, height, g = 0.25, 2, 10
local ball = body { name = "ball", at = { 0, height + radius }, restitution = 1, shape = circle { radius = radius } }
trail { body = ball, seconds = 0.3 }

no_energy_gained({ ball }, height)
local function worth()   -- the height it would reach
  return ball:position().y - radius + ball:velocity().y ^ 2 / (2 * g)
end
measure("height it would reach", worth)
reference("height it would reach", function() return height end)
-- Bounces last 2 sqrt(2 h / g) from the first impact on.
local fall = math.sqrt(2 * height / g)
measure("height", function() return ball:position().y - radius end)
reference("height", function(t)
  local s = (t + fall) % (2 * fall) - fall
  return height - g * s * s / 2
end)
expect("it never rises above its start", function()
  return ball:position().y < height + radius + 1e-3
end, { always = true })
expect("it keeps its height to one percent", function()
  return math.abs(worth() / height - 1) < 0.01
end, { always = true })
expect("it stays on the vertical and does not spin", function()
  return math.abs(ball:position().x) < 1e-9 and math.abs(ball:spin()) < 1e-9
end, { always = true })
expect("quality: after eight bounces it is where it should be, to 2 cm", function()
  local s = (time() + fall) % (2 * fall) - fall
  return math.abs(ball:position().y - radius - (height - g * s * s / 2)) < 0.02
end)
