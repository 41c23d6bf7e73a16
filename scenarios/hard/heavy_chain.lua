-- Sixteen light balls and one of a thousand times their mass, hung up level and let go.
scenario {
  title = "A chain of balls with a heavy end",
  description = "1000:1 at the end of a chain; Rapier gives such a body extra substeps to keep the stretch down.",
  duration = 5, rate = 60, fps = 60, gravity = {0, -10}, method = { substeps = 4 }, effects = "auto",
  view = { center = {0, -7}, height = 36 }, layers = { "bodies", "joints" },
  golden = { frames = { 299 }, size = {480, 270} },
}
include "include/gates.lua"

local count, pitch, radius = 17, 1, 0.3
local balls, joints, last = {}, {}, world
for i = 1, count do
  local ball = body { name = "ball " .. i, at = { i * pitch, 0 }, shape = circle { radius = radius }, group = -1,
                      mass = i == count and 1000 or 1 }
  joints[i] = distance { last, ball, from = { (i - 1) * pitch, 0 }, to = { i * pitch, 0 } }
  balls[i], last = ball, ball
end
local heavy = balls[count]

no_gap(joints, radius, 0)
no_energy_gained(balls, count * pitch)
local function stretch()
  local p = heavy:position()
  return math.sqrt(p.x ^ 2 + p.y ^ 2) - count * pitch
end
measure("stretch", stretch)
expect("the chain holds: it is never longer than it is, to one percent", function()
  return stretch() < 0.01 * count * pitch
end, { always = true })
local first = energy().total
measure("energy lost", function() return first - energy().total end)
expect("quality: the joints bleed no energy, to one percent of what the fall turns over", function()
  return math.abs(energy().total - first) < 0.01 * heavy:mass() * 10 * count * pitch
end, { always = true })
