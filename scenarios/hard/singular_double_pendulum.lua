-- The N-four-bar mechanism of the IFToMM benchmark library (A02; M. Gonzalez et al. 2006) with forty loops: 81 rods of
-- 1 m and 1 kg that move as one. Whenever they all lie in one line it could fold in many ways, and must not.
scenario {
  title = "Forty four-bar loops", duration = 20, rate = 60, fps = 60, gravity = {0, -9.81}, method = { substeps = 4 },
  description = "Parallelograms pass through their singular pose twice in every turn: joint solvers break down there.",
  view = { center = {20, 0}, height = 24 }, layers = { "bodies", "joints" },
  golden = { frames = { 0, 1199 }, size = {480, 270} },
}
include "include/gates.lua"

local loops, joints, bodies = 40, {}, {}
local function rod(name, at_, angle, velocity, spin)
  bodies[#bodies + 1] = body { name = name, at = at_, angle = angle, velocity = velocity, spin = spin,
                               mass = 1, inertia = 1 / 12, group = -1, shape = box { width = 1, height = 0.08 } }
  return bodies[#bodies]
end
-- Upright; the tips go right at 1 m/s, so that all posts turn clockwise.
local before, tip
for i = 0, loops do
  local post = rod("post " .. i, {i, 0.5}, math.pi / 2, {0.5, 0}, -1)
  joints[#joints + 1] = revolute { world, post, at = {i, 0} }
  if before then joints[#joints + 1] = revolute { before, post, at = {i, 1} } end
  if i < loops then
    before = rod("beam " .. i + 1, {i + 0.5, 1}, 0, {1, 0}, 0)
    joints[#joints + 1] = revolute { post, before, at = {i, 1} }
  end
  tip = tip or post
end

-- phi'' = lambda sin(phi) from upright; the reference is Jacobi's am and dn.
local function tip_x() return -math.sin(tip:angle() - math.pi / 2) end
local function tip_y() return math.cos(tip:angle() - math.pi / 2) end
local exact = { { 1, -0.115356880632109898, -0.993324111300450186 },
                { 5, -0.540190050675526274, -0.841543052464443055 },
                { 10, 0.180512226686728390, 0.983572740582311575 },
                { 20, 0.410901153762945222, 0.911679900971980652 } }
local xs, ys = {}, {}
for i, e in ipairs(exact) do xs[i], ys[i] = { e[1], e[2] }, { e[1], e[3] } end
measure("tip x", tip_x)
reference("tip x", xs)
measure("tip y", tip_y)
reference("tip y", ys)
for _, e in ipairs(exact) do
  expect(("after %g s the tip is where it should be to a tenth"):format(e[1]), function()
    return math.sqrt((tip_x() - e[2])^2 + (tip_y() - e[3])^2) <= 0.1
  end, { at = e[1] })
end
expect("it stays a chain of parallelograms: all posts point the same way to a thousandth", function()
  local other = bodies[#bodies]:angle()
  return math.abs(other - tip:angle()) <= 1e-3
end, { always = true })
local first = energy().total
measure("energy drift", function() return energy().total - first end)
expect("quality: the energy stays within a thousandth of what the mechanism turns over",
       function() return math.abs(energy().total - first) <= 1e-3 * #bodies * 9.81 * 2 end, { always = true })
no_gap(joints, 0.08, 0)
no_energy_gained(bodies, 2, 9.81)
