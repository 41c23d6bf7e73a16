-- Thesis, 3.2: the same mass, the same torque; what lies farther from the axis is slower to turn.
local torque, mass, radius, sides = 1.5, 4, 1, 16   -- N m, kg, m

scenario {
  title = "Torque and moment of inertia",
  description = "A disc and a ring of equal mass get the same torque: the disc, whose mass is nearer to the axis, turns faster.",
  duration = 4, gravity = {0, 0}, view = { center = {0.2, 0.3}, height = 4.6 }, layers = { "bodies", "joints", "labels" },
  golden = { frames = {300, 370, 620, 1019}, size = {640, 360} },
}

-- The area and the moment of inertia (of 1 kg/m^2) of a regular polygon about its centre.
local function area(r) return sides / 2 * r ^ 2 * math.sin(2 * math.pi / sides) end
local function inertia(r) return area(r) * r ^ 2 / 6 * (2 + math.cos(2 * math.pi / sides)) end

local inner = 0.8 * radius
local function corner(r, i)
  local angle = 2 * math.pi * i / sides
  return { r * math.cos(angle), r * math.sin(angle) }
end
local pieces = {}
for i = 0, sides - 1 do
  pieces[#pieces + 1] = polygon { corner(inner, i), corner(radius, i), corner(radius, i + 1), corner(inner, i + 1) }
end
local disc = body { name = "disc", at = {-2.2, 0.4}, mass = mass, shape = regular { sides = sides, radius = radius } }
local ring = body { name = "ring", at = {0.4, 0.4}, mass = mass, shapes = pieces }
local I = { disc = mass * inertia(radius) / area(radius),
            ring = mass * (inertia(radius) - inertia(inner)) / (area(radius) - area(inner)) }

for _, wheel in ipairs { disc, ring } do
  revolute { world, wheel, at = wheel:center(), motor = { speed = 1000, max_torque = torque } }
  highlight { body = wheel, point = {0.9, 0}, radius = 0.1 }
end
label { body = disc, text = "disc" }
label { body = ring, text = "ring" }

section { at = 0, name = "Equal masses, equal torques" }
section { at = 1.5, name = "Unequal spins" }
section { at = 3, name = "Why" }
freeze { at = 0, seconds = 4.5 }
freeze { at = 2.2, seconds = 3 }
freeze { at = 3.6, seconds = 5.5 }
caption { text = "A disc and a ring of equal mass and radius, driven by the same torque $M$", from = 0, to = 1.5 }
caption { text = "Each gains spin evenly, $\\omega = \\alpha t$ with $\\alpha = \\frac{M}{I}$", from = 1.5, to = 3 }
caption { text = "The ring has its mass far out: its $I = \\sum m_i r_i^2$ is larger, so its $\\alpha$ is smaller", from = 3 }
plot { title = "Spin", unit = "rad/s", seconds = 4, at = "top_right",
       y = { disc = function() return disc:spin() end, ring = function() return ring:spin() end } }

for name, wheel in pairs { disc = disc, ring = ring } do
  measure("spin of the " .. name, function() return wheel:spin() end)
  reference("spin of the " .. name, function(t) return torque / I[name] * t end)
  expect("the " .. name .. " obeys alpha = M / I", function()
    return math.abs(wheel:spin() - torque / I[name] * time()) < 1e-9
  end, { always = true })
end
expect("the disc is ahead of the ring", function() return disc:angle() > 1.5 * ring:angle() end)
