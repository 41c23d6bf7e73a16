-- Thesis, 3.4: a force through the centre of mass moves a body; beside it, the body turns as well and moves as fast.
local push, arm = 0.72, 0.6   -- N s; m from the centre of mass

scenario {
  title = "A force through and beside the centre",
  description = "Two equal bars get the same push: both centres move alike, one bar turns as well.",
  duration = 4.5, gravity = {0, 0}, view = { center = {-0.6, 0}, height = 6 }, layers = { "bodies", "trails", "vectors", "labels" },
  golden = { frames = {140, 150, 340, 480, 749}, size = {640, 360} },
}

local function bar(name, y)
  return body { name = name, at = {-4.2, y}, shape = box { width = 0.3, height = 1.6 } }
end
local through, beside = bar("through the centre", 1.3), bar("beside it", -1.3)
for _, b in ipairs { through, beside } do
  label { body = b, text = b == through and "through the centre" or "beside it" }
  ghost { body = b, every = 0.5 }
  vector { body = b, of = "velocity", scale = 0.6 }
end

at(0.5, function()
  through:impulse({push, 0}, through:center())
  beside:impulse({push, 0}, {beside:center().x, beside:center().y + arm})
end)

vector { body = through, of = {push, 0}, from = 0.5, to = 0.51 }
vector { body = beside, of = {push, 0}, point = {0, arm}, from = 0.5, to = 0.51 }
for _, b in ipairs { through, beside } do highlight { body = b, point = {0, 0}, radius = 0.09, from = 0.3, to = 0.7 } end

section { at = 0, name = "At rest" }
section { at = 0.5, name = "One push for both" }
section { at = 2.5, name = "What is equal, what is not" }
freeze { at = 0, seconds = 2 }
freeze { at = 0.5, seconds = 3 }
freeze { at = 4.4, seconds = 3 }
caption { text = "Two equal bars at rest", from = 0, to = 0.5 }
caption { text = "One impulse $J$ (arrows): through the centre, and at distance $d$ from it", from = 0.5, to = 2.5 }
caption { text = "Both centres move at $v = \\frac{J}{m}$; one bar turns as well, at $\\omega = \\frac{J d}{I}$", from = 2.5 }

local m = 0.3 * 1.6
local inertia = m * (0.3 ^ 2 + 1.6 ^ 2) / 12
measure("speed beside", function() return beside:velocity().x end)
reference("speed beside", function(t) return t > 0.5 and push / m or 0 end)
measure("spin beside", function() return beside:spin() end)
reference("spin beside", function(t) return t > 0.5 and -push * arm / inertia or 0 end)
expect("both centres are equally far", function()
  return math.abs(through:center().x - beside:center().x) < 1e-12
end, { always = true })
expect("only one bar turns", function() return through:angle() == 0 and beside:angle() < -10 end)
