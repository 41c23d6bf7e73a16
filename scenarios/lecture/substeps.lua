-- The same number of sweeps over the joints, spent in two ways (M. Macklin et al. 2019, "Small steps in physics
-- simulation"): many of them in one step, or many steps with one sweep each.
scenario {
  title = "Substeps against iterations",
  description = "A light chain carries a weight of twenty links: 32 sweeps per tick, as iterations or as substeps.",
  duration = 6, rate = 60, fps = 60, view = { center = {0.95, -1.75}, height = 4 }, layers = { "bodies", "joints" },
  golden = { frames = {0, 90, 410, 779}, size = {640, 360} },
}

local function shared_out(substeps, iterations)
  return pane {
    title = substeps .. (substeps == 1 and " step of " or " steps of ") .. iterations .. (iterations == 1 and " sweep" or " sweeps"),
    method = { joint_solver = "iterative", substeps = substeps, iterations = iterations },
  }
end
shared_out(1, 32)
local small_steps = shared_out(32, 1)

local links, length = 10, 0.2
local above, joints = world, {}
for i = 1, links do
  local top = -(i - 1) * length
  local link = body { name = "link " .. i, at = {0, top - length / 2}, shape = box { width = 0.06, height = length }, mass = 0.1, group = -1 }
  joints[i] = revolute { above, link, at = {0, top} }
  above = link
end
local weight = body { name = "weight", at = {0, -links * length - 0.3}, shape = circle { radius = 0.3 }, mass = 2, group = -1 }
joints[links + 1] = revolute { above, weight, at = {0, -links * length} }

local function largest_gap()
  local largest = 0
  for _, joint in ipairs(joints) do largest = math.max(largest, joint:gap()) end
  return largest
end
plot { title = "largest gap of a joint in mm", y = { gap = function() return 1000 * largest_gap() end }, seconds = 6, at = "top_right" }
caption { text = "A weight of 2 kg on links of 0.1 kg: every tick has 32 sweeps over the joints", from = 0, to = 3 }
caption { text = "In steps 32 times as short the gap is $32^2$ times as small: it shrinks with $h^2$", from = 3 }

freeze { at = 1.5, seconds = 3.5 }
freeze { at = 5.5, seconds = 3.5 }

measure("largest gap", largest_gap)
if small_steps then
  expect("in small steps no joint opens by more than a millimetre", function() return largest_gap() < 1e-3 end)
else
  expect("in one step a joint stays open by more than a centimetre", function() return largest_gap() > 1e-2 end)
end
