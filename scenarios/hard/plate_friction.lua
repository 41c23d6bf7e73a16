-- A box lies on a plate that is turned slowly, never as far as the friction lets it slide: it must not move against it.
local mu, rate_of_turn = 0.5, 0.05
local slip = math.atan(mu)             -- Coulomb 1781: it slips where the slope's tangent exceeds the coefficient

scenario {
  title = "A box on a slowly turning plate",
  description = "Friction on a moving plate: below the angle of friction the box rides along and does not creep.",
  duration = 16, rate = 60, fps = 60, gravity = {0, -10}, method = { substeps = 4 }, effects = "auto",
  view = { center = {0, 0.6}, height = 4.2 }, layers = { "bodies", "contacts" },
  golden = { frames = { 959 }, size = {480, 270} },
}
include "include/gates.lua"

local plate = body { name = "plate", type = "kinematic", at = {0, 0}, friction = mu,
                     shape = box { width = 6, height = 0.2 } }
local block = body { name = "block", at = {2, 0.35}, friction = mu, shape = box { width = 0.8, height = 0.5 } }
-- It turns to 0.35 rad (the slip angle is 0.46 rad) in one second less than eight, back, and rests.
every(1 / 60, function()
  local t = time()
  local turning = t < 7.5 and 1 or t < 14.5 and -1 or 0
  local ramp = math.min(1, t, math.abs(t - 7.5), math.abs(t - 14.5))   -- a second to get going: no jolt
  plate:set { spin = rate_of_turn * turning * ramp }
end)

no_overlap(0.5, 0.25)
local function along()
  local p, a = block:position(), plate:angle()
  return p.x * math.cos(a) + p.y * math.sin(a)
end
measure("plate (rad)", function() return plate:angle() end)
measure("creep", function() return along() - 2 end)
measure("turned against the plate", function() return block:angle() - plate:angle() end)
expect("the plate stays below the angle of friction", function()
  return plate:angle() < 0.9 * slip
end, { always = true })
-- Rigid, it would not move at all; a millimetre is a six hundredth of the way the plate carries it.
expect("the box does not creep along the plate", function() return math.abs(along() - 2) < 1e-3 end, { always = true })
expect("quality: not even by a tenth of a millimetre", function()
  return math.abs(along() - 2) < 1e-4
end, { always = true })
expect("the box lies flat on the plate", function()
  return math.abs(block:angle() - plate:angle()) < 1e-3
end, { always = true })
