-- A jointed figure falls down the stairs and must come to rest there: stops, contacts and friction in one heap.
scenario {
  title = "A ragdoll comes to rest on stairs",
  description = "Nine hinges with stops on the edges of stairs: where stops and contacts fight, it twitches for ever.",
  duration = 12, rate = 60, fps = 60, gravity = {0, -10}, method = { substeps = 4 }, effects = "auto",
  view = { center = {-0.3, 1.45}, height = 3.6 }, layers = { "bodies", "joints", "contacts" },
  golden = { frames = { 719 }, size = {480, 270} },
}
include "include/gates.lua"

ground { y = 0, friction = 0.7 }
for i = 0, 4 do
  body { name = "stair " .. i, type = "static", at = { -1.85 + 0.5 * i, 0.85 - 0.17 * i },
         shape = box { width = 0.5, height = 1.7 - 0.34 * i }, friction = 0.7 }
end

local x, y = -1.75, 1.72   -- where the feet are
local bodies = {}
local function limb(name, from, to, radius)
  local half = { (to[1] - from[1]) / 2, (to[2] - from[2]) / 2 }
  local b = body { name = name, at = { x + from[1] + half[1], y + from[2] + half[2] }, density = 10, friction = 0.7,
                   group = -1,
                   shape = capsule { a = { -half[1], -half[2] }, b = half, radius = radius } }
  bodies[#bodies + 1] = b
  return b
end
local trunk = limb("trunk", {0, 0.62}, {0, 0.98}, 0.11)
local head = body { name = "head", at = { x, y + 1.27 }, shape = circle { radius = 0.13 }, density = 8,
                    friction = 0.7, group = -1 }
bodies[#bodies + 1] = head
local joints, bounds = {}, {}
local function joint(a, b, at, lo, hi)
  joints[#joints + 1] = revolute { a, b, at = { x + at[1], y + at[2] }, limits = { lo, hi } }
  bounds[#bounds + 1] = { a, b, lo, hi }
end
joint(trunk, head, {0, 1.12}, -0.5, 0.5)
for i = 1, 2 do
  local upper_arm = limb("upper arm", {0, 0.98}, {0, 0.72}, 0.05)
  local forearm = limb("forearm", {0, 0.7}, {0, 0.46}, 0.045)
  local thigh = limb("thigh", {0, 0.56}, {0, 0.34}, 0.07)
  local shin = limb("shin", {0, 0.3}, {0, 0.06}, 0.055)
  joint(trunk, upper_arm, {0, 0.98}, i == 1 and -0.6 or -1.2, 2.4)
  joint(upper_arm, forearm, {0, 0.71}, 0, 2.3)
  joint(trunk, thigh, {0, 0.56}, -0.4, i == 1 and 1.8 or 1.5)
  joint(thigh, shin, {0, 0.32}, -2.2, 0)
end
trunk:set { velocity = { 1.5, 0 } }
head:set { velocity = { 1.8, 0 } }

local function beyond()   -- the largest angle by which a joint is beyond its stops
  local worst = 0
  for _, b in ipairs(bounds) do
    local angle = b[2]:angle() - b[1]:angle()
    worst = math.max(worst, b[3] - angle, angle - b[4])
  end
  return worst
end
local function fastest()
  local v = 0
  for _, b in ipairs(bodies) do
    v = math.max(v, math.sqrt(b:velocity().x ^ 2 + b:velocity().y ^ 2) + 0.1 * math.abs(b:spin()))
  end
  return v
end
local function outermost()
  local out = 0
  for _, b in ipairs(bodies) do
    local p = b:position()
    out = math.max(out, -p.y, math.abs(p.x) - 6)
  end
  return out
end

no_overlap(0.09, 8)
no_gap(joints, 0.09, 0)
no_energy_gained(bodies, 3)
measure("fastest", fastest)
measure("beyond a stop", beyond)
-- It falls 2.9 m from the head down: 7.6 m/s, and a limb may whip round at twice that.
expect("nothing is thrown", function() return fastest() < 16 and outermost() <= 0 end, { always = true })
expect("the figure comes to rest", function() return fastest() < 0.01 end)
expect("no joint bends beyond its stops", function() return beyond() < 0.02 end, { always = true })
