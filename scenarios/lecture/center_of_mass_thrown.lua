-- Thesis, 3.3: whatever a thrown body does about its centre of mass, the centre itself flies along a parabola.
local start, throw, spin = {-4.6, 0.6}, {3.6, 7.8}, -7   -- m, m/s, rad/s
local g = 9.81

scenario {
  title = "A thrown hammer",
  description = "A hammer tumbles through the air: its centre of mass flies along a parabola, all other points turn round it.",
  duration = 1.6, gravity = {0, -g}, view = { center = {-1.5, 1.9}, height = 6 }, layers = { "bodies", "trails", "labels" },
  golden = { frames = {160, 264, 540, 900}, size = {640, 360} },
}

local hammer = body {
  name = "hammer", velocity = throw, spin = spin,
  shapes = { box { width = 1.1, height = 0.12, density = 1 }, box { width = 0.26, height = 0.55, at = {0.62, 0}, density = 5 } },
}
hammer:set { at = { start[1] - hammer:center().x, start[2] - hammer:center().y } }
local from = hammer:center()
local corner = {-0.55, 0.06}

ghost { body = hammer, every = 0.2 }
trail { body = hammer, seconds = 2 }
trail { body = hammer, seconds = 0.5, point = corner }
highlight { body = hammer, point = {from.x - hammer:position().x, from.y - hammer:position().y}, radius = 0.09,
            from = 0.4, to = 0.8, text = "centre of mass" }
highlight { body = hammer, point = corner, radius = 0.09, from = 0.4, to = 0.8, text = "end of the handle" }
slow { from = 0, to = 1.6, factor = 0.25 }
freeze { at = 0, seconds = 2 }

section { at = 0, name = "A throw" }
section { at = 0.4, name = "Two points" }
section { at = 0.8, name = "The parabola of the centre" }
freeze { at = 0.6, seconds = 3 }
freeze { at = 1, seconds = 4 }
freeze { at = 1.5, seconds = 3 }
caption { text = "A hammer is thrown and turns as it flies", from = 0, to = 0.4 }
caption { text = "One point of it moves simply, all the others move round it", from = 0.4, to = 0.8 }
caption { text = "Only its weight acts, so the centre obeys $x = v_x t$, $y = v_y t − \\frac{g t^2}{2}$", from = 0.8, to = 1.25 }
caption { text = "No torque about the centre: it turns at a constant $\\omega$", from = 1.25 }

measure("x of the centre", function() return hammer:center().x end)
reference("x of the centre", function(t) return from.x + throw[1] * t end)
measure("y of the centre", function() return hammer:center().y end)
reference("y of the centre", function(t) return from.y + throw[2] * t - g * t ^ 2 / 2 end)
measure("spin", function() return hammer:spin() end)
reference("spin", function() return spin end)
expect("the centre of mass lies on the parabola", function()
  local x, y, t = hammer:center().x - from.x, hammer:center().y - from.y, time()
  return math.abs(x - throw[1] * t) < 1e-9 and math.abs(y - throw[2] * t + g * t ^ 2 / 2) < 1e-9
end, { always = true })
expect("the spin never changes", function() return math.abs(hammer:spin() - spin) < 1e-12 end, { always = true })
