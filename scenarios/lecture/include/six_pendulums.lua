-- One pendulum by six integrators. It is unrolled: what is stepped is the arc s = l phi, which the weight drives by
-- -m g sin(s / l), so that integrators without rigid joints can take part; the rod only shows it.
local l, phi0, g = 1, 2.4, 9.81

local methods = {
  { "symplectic_euler", 1 }, { "verlet", 2 }, { "implicit_midpoint", 2 }, { "rk4", 4 }, { "suzuki4", 4 }, { "gauss_legendre6", 6 },
}
local function words(name) return (name:gsub("_", " "):gsub("(%a)(%d)", "%1 %2")) end

swing = {}
for _, one in ipairs(methods) do
  if pane { title = words(one[1]) .. ", order " .. one[2], method = { integrator = one[1] } } then swing.method = one[1] end
end

local arc = body { name = "arc", at = {l * phi0, 0}, shape = circle { radius = 1e-3 }, mass = 1, group = -1, color = "#fbfaf6" }
field(function(x) return -g * math.sin(x / l), 0 end)
local rod = body {
  name = "pendulum", type = "kinematic", at = {0, 0}, angle = phi0, group = -1, color = "#78aee0",
  shapes = { box { width = 0.03, height = l, at = {0, -l / 2} }, circle { radius = 0.14, at = {0, -l} } },
}
every(0.05, function() rod:set { angle = arc:position().x / l } end)

function swing.phi() return arc:position().x / l end
function swing.omega() return arc:velocity().x / l end
--- How far the energy is off, as a part of what the pendulum could have at most: 2 m g l.
function swing.off()
  local now = 0.5 * l * swing.omega() ^ 2 - g * math.cos(swing.phi())
  return (now + g * math.cos(phi0)) / (2 * g)
end
