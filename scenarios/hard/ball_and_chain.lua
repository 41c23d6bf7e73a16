-- The ball and chain of Box2D's manual, which names it as what stretches: 672 times the mass of a link.
scenario {
  title = "Ball and chain", duration = 10, rate = 60, fps = 60, gravity = {0, -10}, method = { substeps = 4 },
  description = "Forty light links swing a ball of 672 times their mass: iterative joints open by centimetres.",
  view = { center = {0, -22}, height = 74 }, layers = { "bodies", "joints" },
  golden = { frames = { 0, 599 }, size = {480, 270} },
}
include "include/gates.lua"

local links, last, joints, bodies = 40, world, {}, {}
for i = 1, links do
  local link = body { name = "link " .. i, at = { i - 0.5, 0 }, group = -1,
                      shape = capsule { a = {-0.5, 0}, b = {0.5, 0}, radius = 0.125 } }
  joints[i], bodies[i] = revolute { last, link, at = { i - 1, 0 } }, link
  last = link
end
local ball = body { name = "ball", at = { links + 8, 0 }, shape = circle { radius = 8 }, group = -1 }
joints[#joints + 1] = revolute { last, ball, at = { links, 0 } }
bodies[#bodies + 1] = ball

local function widest()
  local most = 0
  for _, j in ipairs(joints) do most = math.max(most, j:gap()) end
  return most
end
expect("no joint ever opens by 2 cm", function() return widest() <= 0.02 end, { always = true })
expect("the ball stays at the end of its chain", function()
  local p = ball:position()
  return math.sqrt(p.x^2 + p.y^2) <= links + 8 + 0.02
end, { always = true })
no_gap(joints, 0.25, 0)                                  -- a link is 25 cm thick

-- Nothing brakes it. The scale is what the ball gains on its way down.
local first = energy().total
measure("energy kept", function() return energy().total - first end)
expect("quality: the energy stays within a thousandth", function()
  return math.abs(energy().total - first) <= 1e-3 * ball:mass() * 10 * (links + 8)
end, { always = true })
no_energy_gained(bodies, links + 8)
