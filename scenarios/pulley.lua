-- Atwood's machine (1784): two weights on one rope over two pins.
scenario {
  title = "Atwood's machine",
  description = "Two weights on a rope fall at g (m1 - m2) / (m1 + m2), slowly enough to be measured by eye.",
  duration = 1.4, view = { center = {0.9, 0.8}, height = 5 },
  layers = { "bodies", "joints", "vectors", "labels" },
  golden = { frames = { 0, 168, 332 } },
}

local m1, m2, g = 3, 2, 9.81
local left = body { name = "left", at = {-0.8, 1.5}, shape = box { width = 0.62, height = 0.62 }, mass = m1 }
local right = body { name = "right", at = {0.8, -0.5}, shape = box { width = 0.5, height = 0.5 }, mass = m2 }
body { name = "beam", type = "static", at = {0, 2.8}, shape = box { width = 2.4, height = 0.16 }, group = -1 }
local rope = pulley { left, right, from_a = {-0.8, 2.8}, from_b = {0.8, 2.8}, to_a = {-0.8, 1.81}, to_b = {0.8, -0.25} }

local a = g * (m1 - m2) / (m1 + m2)
measure("height of the left weight", function() return left:position().y end)
reference("height of the left weight", function(t) return 1.5 - a * t ^ 2 / 2 end)
measure("tension", function() return rope:reaction().y end)
expect("the weights fall and rise at g (m1 - m2) / (m1 + m2)", function()
  return math.abs(left:velocity().y + a * time()) < 1e-6 and math.abs(right:velocity().y - a * time()) < 1e-6
end, { always = true })
expect("the rope pulls with 2 m1 m2 g / (m1 + m2)", function()
  return math.abs(rope:reaction().y - 2 * m1 * m2 * g / (m1 + m2)) < 1e-6
end)
expect("the rope keeps its length", function() return rope:gap() < 1e-12 end, { always = true })
label { body = left, text = "3 kg" }
label { body = right, text = "2 kg" }
vector { body = left, of = "velocity", scale = 0.3 }
vector { body = right, of = "velocity", scale = 0.3 }
plot { title = "Speed (m/s)", seconds = 1.4, at = "top_right", y = { ["3 kg, down"] = function() return -left:velocity().y end } }
slow { from = 0, to = 1.4, factor = 0.25 }
caption { text = "a = g (3 − 2) / (3 + 2) = g / 5" }
