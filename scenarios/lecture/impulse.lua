-- Thesis, 3.4: the same impulse gives every mass the same momentum, and so a light one the higher speed.
local push, masses = 2, { 1, 2, 4 }                                -- N s, kg

scenario {
  title = "One impulse, three masses",
  description = "Three discs get the same impulse: equal momenta, speeds as 4 : 2 : 1.",
  duration = 3, gravity = {0, 0}, view = { center = {0, 0}, height = 5.6 }, layers = { "bodies", "trails", "vectors", "labels" },
  golden = { frames = {140, 151, 420, 509}, size = {640, 360} },
}

local discs = {}
for i, m in ipairs(masses) do
  local disc = body { name = ("%g kg"):format(m), at = {-4, 3.1 - 1.5 * i}, mass = m,
                      shape = circle { radius = 0.24 * m ^ 0.5 } }
  discs[i] = disc
  label { body = disc, text = ("%g kg"):format(m) }
  ghost { body = disc, every = 0.5 }
end
at(0.5, function()
  for _, disc in ipairs(discs) do
    disc:impulse { push, 0 }
    vector { body = disc, of = "momentum", scale = 0.6 }
  end
end)

section { at = 0, name = "At rest" }
section { at = 0.5, name = "Equal momenta" }
section { at = 1.7, name = "Unequal speeds" }
freeze { at = 0, seconds = 2 }
freeze { at = 0.51, seconds = 4 }
freeze { at = 2.9, seconds = 4 }
caption { text = "Three discs at rest", from = 0, to = 0.51 }
caption { text = "The same impulse $J$ for each: the momentum $m v = J$ is the same (arrows)", from = 0.51, to = 1.7 }
caption { text = "The speeds are not: $v = \\frac{J}{m}$ is 2, 1 and 0.5 m/s", from = 1.7 }

for i, disc in ipairs(discs) do
  measure(("speed of %g kg"):format(masses[i]), function() return disc:velocity().x end)
  reference(("speed of %g kg"):format(masses[i]), function(t) return t > 0.5 and push / masses[i] or 0 end)
end
expect("all momenta are the same", function()
  for i, disc in ipairs(discs) do
    if math.abs(masses[i] * disc:velocity().x - (time() > 0.5 and push or 0)) > 1e-12 then return false end
  end
  return true
end, { always = true })
