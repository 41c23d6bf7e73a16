-- One pendulum by six integrators. Its rod is a stiff spring, so that integrators without rigid joints can take part.
local l, phi0, g = 1, math.rad(100), 9.81

local methods = {
  { "symplectic_euler", 1 }, { "verlet", 2 }, { "implicit_midpoint", 2 }, { "rk4", 4 }, { "suzuki4", 4 }, { "gauss_legendre6", 6 },
}
local function words(name) return (name:gsub("_", " "):gsub("legendre6", "legendre 6")) end

swing = {}
for _, one in ipairs(methods) do
  if pane { title = words(one[1]) .. ", order " .. one[2], method = { integrator = one[1] } } then swing.method = one[1] end
end

local at = {l * math.sin(phi0), -l * math.cos(phi0)}
local bob = body { name = "bob", at = at, mass = 1, shape = circle { radius = 0.14 } }
spring { world, bob, from = {0, 0}, to = at, stiffness = 400, length = l }

local start = energy().total
function swing.phi() return math.atan(bob:position().x, -bob:position().y) end
function swing.omega()
  local p, v = bob:position(), bob:velocity()
  return (p.x * v.y - p.y * v.x) / (p.x ^ 2 + p.y ^ 2)
end
--- How far the energy is off, as a part of what lies between the pendulum's lowest and highest place: 2 m g l.
function swing.off() return (energy().total - start) / (2 * g * l) end
