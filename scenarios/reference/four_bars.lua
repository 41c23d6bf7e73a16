-- Closed loops that pass through a singular pose twice in every turn: the N-four-bar mechanism with N = 40 (A02 of the
-- IFToMM library, M. Gonzalez et al. 2006). All posts turn as one: phi'' = lambda sin phi from upright, by Jacobi's am.
scenario {
  title = "Forty four-bar loops", duration = 20, view = { center = {20, 0}, height = 25 },
  description = "81 rods of 1 m and 1 kg that move as one, beside the exact solution.",
  layers = { "bodies", "joints" }, golden = { frames = { 0, 1199 }, size = {480, 270} },
}
include "include/math_reference.lua"

local loops, g, bodies, joints = 40, 9.81, {}, {}
local function rod(name, at_, angle, velocity, spin)
  bodies[#bodies + 1] = body { name = name, at = at_, angle = angle, velocity = velocity, spin = spin, mass = 1,
                               inertia = 1 / 12, group = -1, shape = box { width = 1, height = 0.08 } }
  return bodies[#bodies]
end
-- Upright; the tips go right at 1 m/s, so that all posts turn clockwise.
local before, first
for i = 0, loops do
  local post = rod("post " .. i, {i, 0.5}, math.pi / 2, {0.5, 0}, -1)
  joints[#joints + 1] = revolute { world, post, at = {i, 0} }
  if before then joints[#joints + 1] = revolute { before, post, at = {i, 1} } end
  if i < loops then
    before = rod("beam " .. i + 1, {i + 0.5, 1}, 0, {1, 0}, 0)
    joints[#joints + 1] = revolute { post, before, at = {i, 1} }
  end
  first = first or post
end

-- Inertia and weight's arm of all rods: (N + 1) / 3 + N and (N + 1) / 2 + N. From (phi' / 2)^2 = 1/4 + lambda sin^2
-- (phi / 2) it follows that phi / 2 = pi / 2 + am(W t - K, k), W^2 = lambda + 1/4, k^2 = lambda / W^2.
local lambda = g * ((loops + 1) / 2 + loops) / ((loops + 1) / 3 + loops)
local W = math.sqrt(lambda + 0.25)
local k, k1 = math.sqrt(lambda) / W, 0.5 / W
local function exact(t)
  local _, _, dn, am = jacobi(W * t - elliptic_k(k, k1), k, k1)
  return math.pi + 2 * am, 2 * W * dn
end
local function turned() return math.pi / 2 - first:angle() end

measure("tip x", function() return math.sin(turned()) end)
reference("tip x", function(t) return math.sin((exact(t))) end)
measure("tip y", function() return math.cos(turned()) end)
reference("tip y", function(t) return math.cos((exact(t))) end)
measure("spin", function() return -first:spin() end)
reference("spin", function(t) return (select(2, exact(t))) end)
measure("energy", function() return energy().total end)
reference("energy", function() return ((loops + 1) / 3 + loops) / 2 + g * ((loops + 1) / 2 + loops) end)

expect("a turn takes 1.96560192870 s",
       function() return math.abs(2 * elliptic_k(k, k1) / W - 1.96560192870465044) <= 1e-12 end)
expect("after 20 s the tip is where Jacobi says, to 2 cm", function()
  return math.sqrt((math.sin(turned()) - 0.410901153762945222) ^ 2
                   + (math.cos(turned()) - 0.911679900971980652) ^ 2) <= 2e-2
end)
expect("all posts point the same way, to 1e-6", function()
  return math.abs(bodies[#bodies]:angle() - first:angle()) <= 1e-6
end, { always = true })
expect("the loops stay closed to 1e-9 m", function()
  for _, j in ipairs(joints) do if j:gap() > 1e-9 then return false end end
  return true
end)
