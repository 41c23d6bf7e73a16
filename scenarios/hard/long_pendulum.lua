-- A million steps. The energy of a symplectic method breathes with every swing but must not wander: a line laid
-- through all its values has no slope.
scenario {
  title = "A million steps", duration = 4168, rate = 60, fps = 60, gravity = {0, -9.81}, method = { substeps = 4 },
  description = "A pendulum swings two thousand times at 60 degrees: methods that lose or gain a little show it.",
  view = { center = {0, -0.45}, height = 1.6 }, layers = { "bodies", "joints" },
  golden = { frames = { 250079 }, size = {480, 270} },
}

local from, g, length = math.rad(60), 9.81, 1
local bob = body { name = "bob", at = { math.sin(from), -math.cos(from) }, density = 40,
                   shape = circle { radius = 0.07 } }
distance { world, bob, from = {0, 0}, to = bob:position(), length = length }
local scale = bob:mass() * g * length
local first = energy().total
local function drift() return (energy().total - first) / scale end

-- Sums of a least-squares line, at times that are no multiple of the swing's
local n, st, se, stt, ste, widest = 0, 0, 0, 0, 0, 0
every(37 / 60, function()
  local t, e = time(), drift()
  n, st, se, stt, ste = n + 1, st + t, se + e, stt + t * t, ste + t * e
  widest = math.max(widest, math.abs(e))
end)
local function slope() return (n * ste - st * se) / math.max(1e-300, n * stt - st * st) end
measure("energy drift by m g l", drift)
measure("widest", function() return widest end)
measure("slope per second", slope)

-- An oscillator started at rest errs by (omega h)^2 / 4 of its energy, here of m g l / 2. So large a swing may err by
-- twice that.
local bound = (g / length) / 240^2 / 4
expect("the energy stays within what a step's length explains", function() return widest > 0 and widest <= bound end)
expect("the energy does not wander: over all the time by less than a hundredth of that",
       function() return math.abs(slope()) * time() <= 0.01 * bound end)
local function rod_error()
  local p = bob:position()
  return math.abs(math.sqrt(p.x^2 + p.y^2) - length)
end
expect("quality: the rod keeps its length to a billionth", function() return rod_error() <= 1e-9 end)
