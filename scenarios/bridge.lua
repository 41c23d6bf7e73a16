-- Planks on hinges between two cliffs, and what falls on them.
scenario {
  title = "Plank bridge", duration = 8, seed = 11, view = { center = {0, 0.7}, height = 7.2 },
  description = "A hanging bridge of twenty planks carries a load without stretching.",
  golden = { frames = { 0, 120, 479 } }, layers = { "bodies", "joints", "contacts" },
}

-- The planks start as chords of a circle, so that the bridge has the slack it needs to carry anything at all.
local planks, width, radius = 20, 0.5, 14
local turn = 2 * math.asin(width / (2 * radius))
local half = planks * turn / 2
local span = 2 * radius * math.sin(half)
local function hinge(i)
  local a = -half + i * turn
  return { radius * math.sin(a), radius * (math.cos(half) - math.cos(a)) }
end
for _, side in ipairs { -1, 1 } do
  body { name = "cliff", type = "static", at = { side * (span / 2 + 2.04), -1.44 }, shape = box { width = 4, height = 3 }, group = -3 }
end
ground { y = -2.9 }
local last, joints = world, {}
for i = 1, planks do
  local a, b = hinge(i - 1), hinge(i)
  local plank = body { name = "plank " .. i, at = { (a[1] + b[1]) / 2, (a[2] + b[2]) / 2 }, angle = math.atan(b[2] - a[2], b[1] - a[1]),
                       density = 6, shape = box { width = width - 0.02, height = 0.12 }, friction = 0.7, group = -3 }
  joints[#joints + 1] = revolute { last, plank, at = a }
  last = plank
end
joints[#joints + 1] = revolute { last, world, at = hinge(planks) }

local cargo = 0
every(0.4, function()
  if cargo >= 12 then return end
  cargo = cargo + 1
  local shape = cargo % 2 == 0 and box { width = 0.7, height = 0.5 } or regular { sides = 5, radius = 0.38 }
  body { name = "cargo " .. cargo, at = { -3 + 6 * math.random(), 4.6 }, shape = shape, friction = 0.7 }
end)
local function widest_gap()
  local worst = 0
  for _, j in ipairs(joints) do worst = math.max(worst, j:gap()) end
  return worst
end
measure("widest hinge gap", widest_gap)
expect("no hinge opens by more than a hundredth of a millimetre", function() return widest_gap() < 1e-5 end, { always = true })
