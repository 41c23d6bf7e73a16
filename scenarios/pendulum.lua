-- A point mass on a massless rod, checked against the exact solution of the large-angle pendulum.
scenario {
  title = "Pendulum at 60 degrees",
  description = "A large swing beside its exact solution: the rod keeps its length, the energy its sum.",
  duration = 10, view = { center = {0.35, -0.42}, height = 1.7 },
  layers = { "bodies", "joints", "trails", "vectors" },
  golden = { frames = { 0, 33, 97, 599 } },
}

local from = math.rad(60)
local bob = body { name = "bob", at = { math.sin(from), -math.cos(from) }, density = 40, shape = circle { radius = 0.07 } }
distance { world, bob, from = {0, 0}, to = bob:position(), length = 1 }   -- held at its centre: a point mass

local function theta()
  local p = bob:position()
  return math.atan(p.x, -p.y)
end
measure("theta", theta)
reference("theta", { { 0, from }, { 10, -0.651863046741975928 } })        -- Jacobi's sn, by the arithmetic-geometric mean

local function rod_error()
  local p = bob:position()
  return math.abs(math.sqrt(p.x^2 + p.y^2) - 1)
end
expect("the rod is 1 m long to a tenth of a millimetre", function() return rod_error() < 1e-4 end, { always = true })
local total = energy().total
expect("the energy stays within a ten-thousandth of the swing's", function()
  return math.abs(energy().total - total) < 1e-4 * bob:mass() * 9.81
end, { always = true })

trail { body = bob, seconds = 1.2 }
vector { body = bob, of = "velocity", scale = 0.12 }
plot { title = "Energy (J)", seconds = 4, at = "top_right", y = {
  kinetic = function() return energy().kinetic end,
  potential = function() return energy().potential end,
  total = function() return energy().total end,
} }
