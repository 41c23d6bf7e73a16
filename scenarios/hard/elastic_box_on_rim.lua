-- An elastic box wider than what it lands on: it bounces on the corners of its floor.
scenario {
  title = "An elastic box on a narrow floor",
  description = "e = 1, the floor narrower than the box: two corner blows must not add up, as in box3d they did.",
  duration = 6, rate = 60, fps = 60, gravity = {0, -10}, method = { substeps = 4 }, effects = "auto",
  view = { center = {0, 1.1}, height = 3.6 }, layers = { "bodies", "contacts" },
  golden = { frames = { 359 }, size = {480, 270} },
}
include "include/gates.lua"

local half, height, g = 0.375, 1, 10
body { name = "floor", type = "static", at = { 0, -0.1 }, shape = box { width = 2 * half, height = 0.2 } }
local block = body { name = "block", at = { 0, height + 0.5 }, restitution = 1, shape = box { width = 1, height = 1 } }

no_energy_gained({ block }, height)
local function worth()   -- the height it would reach
  return block:position().y - 0.5 + block:velocity().y ^ 2 / (2 * g)
end
measure("height it would reach", worth)
measure("height", function() return block:position().y - 0.5 end)
measure("angle", function() return block:angle() end)
expect("it never overshoots its start", function()
  return block:position().y < height + 0.5 + 1e-3
end, { always = true })
expect("it keeps its height to one percent", function()
  return math.abs(worth() / height - 1) < 0.01
end, { always = true })
expect("it stays level and above the floor's middle", function()
  return math.abs(block:angle()) < 1e-6 and math.abs(block:position().x) < 1e-6
end, { always = true })
