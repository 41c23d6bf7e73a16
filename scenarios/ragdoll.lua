-- A jointed figure falls down a staircase; its joints bend only as far as a body's do.
scenario {
  title = "Jointed figure",
  description = "Nine hinges with stops: the figure tumbles down the stairs and no joint bends too far.",
  duration = 6, view = { center = {0.75, 1.35}, height = 4.2 },
  layers = { "bodies", "joints" },
  golden = { frames = { 0, 70, 150, 359 } },
}

ground { y = 0 }
for i = 0, 4 do
  local landing = i == 0
  if i ~= 1 then   -- the landing takes the place of the first stair
    body { name = "stair", type = "static", at = { (landing and -1.9 or -1.85) + 0.5 * i, 0.85 - 0.17 * i },
           shape = box { width = landing and 1.6 or 0.5, height = 1.7 - 0.34 * i }, friction = 0.4 }
  end
end

local x, y = -1.15, 1.72   -- where the feet stand
local function limb(name, from, to, radius)
  local half = { (to[1] - from[1]) / 2, (to[2] - from[2]) / 2 }
  return body { name = name, at = { x + from[1] + half[1], y + from[2] + half[2] }, density = 10, friction = 0.5, group = -1,
                shape = capsule { a = { -half[1], -half[2] }, b = half, radius = radius } }
end
local trunk = limb("trunk", {0, 0.62}, {0, 0.98}, 0.11)
local head = body { name = "head", at = { x, y + 1.27 }, shape = circle { radius = 0.13 }, density = 8, group = -1 }
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

-- The largest angle by which a joint is beyond its stops.
local function beyond()
  local worst = 0
  for _, b in ipairs(bounds) do
    local angle = b[2]:angle() - b[1]:angle()
    worst = math.max(worst, b[3] - angle, angle - b[4])
  end
  return worst
end
local function gap()
  local worst = 0
  for _, j in ipairs(joints) do worst = math.max(worst, j:gap()) end
  return worst
end
measure("beyond a stop", beyond)
measure("widest gap", gap)
expect("no joint bends beyond its stops", function() return beyond() < 1e-6 end, { always = true })
expect("no joint comes apart", function() return gap() < 1e-6 end, { always = true })
expect("the figure falls down the stairs", function() return head:position().y < 1 end)
caption { text = "Nine hinges, each with stops that hold it as far as a body bends" }
