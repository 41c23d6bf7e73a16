-- Impacts that change the corner a body turns about: a block of 0.2 by 0.8 m, tilted by half of what would tip it,
-- rocks from corner to corner. G. Housner 1963: at each impact the spin falls to 1 - 1.5 sin^2 alpha of it, as the
-- angular momentum about the new corner says; between them the block is a pendulum upside down (Jacobi's sn).
scenario {
  title = "Rocking block", duration = 1.4, rate = 960, view = { center = {0, 0.42}, height = 1.1 },
  description = "A slender block rocks from corner to corner and loses a sixth of its energy at every impact.",
  layers = { "bodies", "contacts", "vectors" }, golden = { frames = { 0, 30, 83 }, size = {480, 270} },
  method = { contact_solver = "event" },
}
include "include/math_reference.lua"

local width, height, g = 0.2, 0.8, 9.81
local radius, alpha = math.sqrt(width ^ 2 + height ^ 2) / 2, math.atan(width, height)
local p, tilt = math.sqrt(3 * g / (4 * radius)), alpha / 2
local kept = 1 - 1.5 * math.sin(alpha) ^ 2
ground { y = 0, friction = 1 }
-- Tilted to the right about its right corner, which stands at (width / 2, 0)
local block = body { name = "block", angle = -tilt, friction = 1,
                     at = { width / 2 - radius * math.sin(alpha - tilt), radius * math.cos(alpha - tilt) },
                     shape = box { width = width, height = height } }

-- psi = alpha - |angle|, from where the centre stands above the corner: psi'' = p^2 sin psi. Turned upside down a
-- pendulum whose swing begins at pi - nearest; it passes pi - alpha, at the impact, `quarter` later.
local function arc(nearest)
  local k, k1 = math.cos(nearest / 2), math.sin(nearest / 2)
  local low = math.asin(math.cos(alpha / 2) / k)
  return { from = math.pi - nearest, quarter = (elliptic_k(k, k1) - elliptic_f(low, k, k1)) / p }
end
local arcs, ends = {}, 0
for n = 0, 30 do
  -- cos psi at the turning point: the energy above that at the impact falls by `kept` squared
  local above = kept ^ (2 * n) * (math.cos(alpha - tilt) - math.cos(alpha))
  local next_arc = arc(math.acos(math.cos(alpha) + above))
  next_arc.top = n == 0 and 0 or ends + next_arc.quarter            -- the moment of its turning point
  next_arc.ends = next_arc.top + next_arc.quarter
  arcs[n], ends = next_arc, next_arc.ends
end
local function impacts_until(t)
  local n = 0
  while arcs[n] and t > arcs[n].ends do n = n + 1 end
  return n
end
local function exact(t)
  local n = impacts_until(t)
  if not arcs[n] then return 0 end
  local tilted = alpha - (math.pi - pendulum_at(math.abs(t - arcs[n].top), arcs[n].from, p))
  return n % 2 == 0 and -tilted or tilted
end
measure("angle", function() return block:angle() end)
reference("angle", exact)
local flat = block:mass() * g * height / 2
local first = energy().total - flat
local function left() return (energy().total - flat) / first end
measure("energy left", left)
reference("energy left", { { 0, 1 }, { arcs[1].top, kept ^ 2 }, { arcs[2].top, kept ^ 4 } })   -- not near an impact

expect("it falls onto its other corner after 0.312308575113 s",
       function() return math.abs(arcs[0].ends - 0.3123085751126223) <= 1e-12 end)
local function near(text, t, most)
  expect(text, function() return math.abs(block:angle() - exact(time())) <= most end, { at = t })
end
near("while it falls back it is where Jacobi says, to 1e-4", 0.3, 1e-4)
near("after the first impact it rises to the other side as far as Housner says, to 3e-4", arcs[1].top, 3e-4)
near("and to the first side after the second, to 2e-3", arcs[2].top, 2e-3)
expect("the first impact leaves 0.8313 of the energy, to 1 percent",
       function() return math.abs(left() - 0.8313) <= 1e-2 end,
       { at = arcs[1].top })
vector { body = block, of = "velocity", scale = 0.3 }
