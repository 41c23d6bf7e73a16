-- Thesis, listing 6.1: the fixed time step. Where a step is as long as the picture before it took, what happens depends
-- on the computer. A fixed step gives the same motion everywhere; a slow computer takes several a picture.
scenario {
  title = "Why the time step is fixed",
  description = "A double pendulum stepped once per picture on displays of 60, 120 and 240 Hz ends in three places.",
  duration = 9, rate = 60, fps = 60, view = { center = {0, -0.1}, height = 5.8 }, layers = { "bodies", "joints", "trails" },
  method = { integrator = "symplectic_euler", substeps = 1 },
  golden = { frames = {330, 750, 930, 1259}, size = {640, 360} },
}

for _, rate in ipairs { 60, 120, 240 } do pane { title = rate .. " Hz: h = 1/" .. rate .. " s", rate = rate } end

local function bob(name, at) return body { name = name, at = at, shape = circle { radius = 0.13 }, group = -1 } end
local upper, lower = bob("upper", {0.9, 0.45}), bob("lower", {1.6, 1.15})
distance { world, upper, from = {0, 0}, to = {0.9, 0.45} }
distance { upper, lower, from = {0.9, 0.45}, to = {1.6, 1.15} }
trail { body = lower, seconds = 1 }

section { at = 0, name = "Alike at first" }
section { at = 2, name = "Small errors grow" }
section { at = 5, name = "Three different motions" }
freeze { at = 0, seconds = 4.5 }
freeze { at = 3.5, seconds = 4 }
freeze { at = 8.5, seconds = 3.5 }
caption { text = "One step for every picture: the step $h$ is as long as the display takes", from = 0, to = 2 }
caption { text = "Every step errs, by more when $h$ is long, and a double pendulum makes it grow", from = 2, to = 5 }
caption { text = "With $h = \\frac{1}{240}$ s fixed, all displays show the last motion, in 4, 2 and 1 steps", from = 5 }

local start = energy().total
measure("x of the lower bob", function() return lower:position().x end)
measure("y of the lower bob", function() return lower:position().y end)
expect("the energy stays within a tenth", function()
  return math.abs(energy().total - start) < 0.1 * math.abs(start) + 0.3
end, { always = true })
