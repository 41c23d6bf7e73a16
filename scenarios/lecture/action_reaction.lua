-- Thesis, 3.1: two skaters push each other off. Whatever one gains in momentum the other loses; their centre stays.
local light, heavy = 40, 80                                        -- kg

scenario {
  title = "Action and reaction",
  description = "Two skaters of unequal mass push each other off: equal and opposite momenta, and a common centre that rests.",
  duration = 3, view = { center = {0.3, 1.1}, height = 5.6 }, layers = { "bodies", "joints", "vectors", "labels" },
  golden = { frames = {160, 210, 375, 610, 911}, size = {640, 360} },
}

ground { y = 0, friction = 0 }
local function skater(name, x, mass, size)
  return body { name = name, at = {x, size}, mass = mass, fixed_rotation = true, friction = 0,
                shape = box { width = 0.9 * size, height = 2 * size, rounding = 0.2 } }
end
local a, b = skater("light", -0.4, light, 0.6), skater("heavy", 0.65, heavy, 0.75)
for _, s in ipairs { a, b } do
  label { body = s, text = ("%g kg"):format(s:mass()) }
  vector { body = s, of = "momentum", scale = 0.012 }
end
local function centre() return (light * a:center().x + heavy * b:center().x) / (light + heavy) end
highlight { at = {centre(), 0}, radius = 0.1, text = "common centre" }

-- Their arms: a spring, pressed together, and a latch that holds it until the push.
local pressed, stiffness = 0.6, 400                                -- m, N/m
local relaxed = b:center().x - a:center().x + pressed
local arms = spring { a, b, from = {a:center().x, 0.7}, to = {b:center().x, 0.7}, stiffness = stiffness, length = relaxed }
local latch = distance { a, b, from = {a:center().x, 0.7}, to = {b:center().x, 0.7} }
at(1, function() latch:remove() end)
every(1 / 240, function()
  if arms and b:center().x - a:center().x >= relaxed then arms:remove() arms = nil end
end)

section { at = 0, name = "At rest" }
section { at = 1, name = "The push" }
section { at = 1.4, name = "Apart" }
slow { from = 1, to = 1.4, factor = 0.25 }
freeze { at = 0, seconds = 2 }
freeze { at = 1.2, seconds = 2 }
freeze { at = 1.8, seconds = 3 }
freeze { at = 2.6, seconds = 4 }
caption { text = "Two skaters at rest on smooth ice", from = 0, to = 1 }
caption { text = "They push each other: $F_{AB} = −F_{BA}$ at every moment", from = 1, to = 1.4 }
caption { text = "Momenta stay equal and opposite: $m_A v_A + m_B v_B = 0$", from = 1.4, to = 2.2 }
caption { text = "The light one is faster, $\\frac{v_A}{v_B} = −\\frac{m_B}{m_A}$; the common centre stays at rest", from = 2.2 }

measure("total momentum", function() return light * a:velocity().x + heavy * b:velocity().x end)
reference("total momentum", function() return 0 end)
local start = centre()
measure("common centre", centre)
reference("common centre", function() return start end)
expect("the momenta are equal and opposite", function()
  return math.abs(light * a:velocity().x + heavy * b:velocity().x) < 1e-9
end, { always = true })
expect("the common centre rests", function() return math.abs(centre() - start) < 1e-12 end, { always = true })
expect("what was stored in the arms is motion now", function()
  local kinetic = (light * a:velocity().x ^ 2 + heavy * b:velocity().x ^ 2) / 2
  return math.abs(kinetic - stiffness * pressed ^ 2 / 2) < 0.5
end)
expect("they part", function() return a:velocity().x < -1.5 and b:velocity().x > 0.75 end)
