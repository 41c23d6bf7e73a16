include "include/math_reference.lua"

-- A point mass of 1 kg on a massless rod of 1 m, let go at rest at `degrees` from straight down: in Cartesian
-- coordinates with a constraint, as the engine has it. The energy counts from the lowest point, in units of m g l (at
-- 90 degrees it is zero from the pivot, so no error can be measured by it).
function swinging_point(degrees)
  local g, length, from = 9.81, 1, math.rad(degrees)
  local omega = math.sqrt(g / length)
  local start = { math.sin(from), -math.cos(from) }
  local bob = body { name = "bob", at = start, mass = 1, shape = circle { radius = 0.07 } }
  local rod = distance { world, bob, from = {0, 0}, to = start, length = length }
  local function exact(t) return pendulum_at(t, from, omega) end

  measure("x", function() return bob:position().x end)
  reference("x", function(t) return math.sin((exact(t))) end)
  measure("y", function() return bob:position().y end)
  reference("y", function(t) return -math.cos((exact(t))) end)
  measure("energy", function() return energy().total / (g * length) + 1 end)
  reference("energy", function() return 1 - math.cos(from) end)

  expect("the rod keeps its length to 1e-12 m", function()
    local p = bob:position()
    return math.abs(math.sqrt(p.x ^ 2 + p.y ^ 2) - length) <= 1e-12
  end, { always = true })
  trail { body = bob, seconds = 0.6 }
  vector { body = bob, of = "velocity", scale = 0.1 }
  local function off()
    local p, theta = bob:position(), exact(time())
    return math.sqrt((p.x - math.sin(theta)) ^ 2 + (p.y + math.cos(theta)) ^ 2)
  end
  local function energy_off() return math.abs(energy().total / (g * length) + math.cos(from)) end
  return { bob = bob, rod = rod, off = off, energy_off = energy_off, period = pendulum_period(from, omega) }
end
