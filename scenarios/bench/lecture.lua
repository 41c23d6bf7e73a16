-- What ./dev bench films beside the crowd: few bodies, and much that is written.
scenario {
  title = "A ball on a spring and a ball on a rod", duration = 10, size = {1920, 1080}, view = { center = {0.4, -0.6}, height = 4.6 },
  description = "Two oscillators with their energies: plots, captions, formulas, labels, vectors and trails in full HD.",
  layers = { "bodies", "joints", "trails", "vectors", "labels", "grid", "clock" },
}

local bob = body { name = "bob", at = {-2.6, -0.3}, mass = 1, shape = circle { radius = 0.16 } }
distance { world, bob, from = {-1.6, 0.9}, to = {-2.6, -0.3} }
local weight = body { name = "weight", at = {0.6, -1}, mass = 1, shape = box { width = 0.4, height = 0.4 } }
spring { world, weight, from = {0.6, 0.9}, to = {0.6, -0.8}, stiffness = 20, damping = 0, length = 1 }
for _, b in ipairs { bob, weight } do
  vector { body = b, of = "velocity", scale = 0.25 }
  vector { body = b, of = "force", scale = 0.04 }
  trail { body = b, seconds = 1.5 }
end
label { body = bob, text = "1 kg on a rod" }
label { body = weight, text = "1 kg on a spring" }

local function kinetic(b)
  local v = b:velocity()
  return 0.5 * b:mass() * (v.x ^ 2 + v.y ^ 2)
end
plot { title = "Kinetic energy (J)", seconds = 10, at = "top_right",
       y = { rod = function() return kinetic(bob) end, spring = function() return kinetic(weight) end } }
plot { title = "Height (m)", seconds = 10, at = "bottom_right",
       y = { rod = function() return bob:position().y end, spring = function() return weight:position().y end } }

section { at = 0, name = "Two oscillators" }
section { at = 5, name = "Their periods" }
caption { text = "Two oscillators", from = 0, to = 5, at = "top" }
caption { text = "Their periods", from = 5, at = "top" }
caption { text = "The rod pulls with whatever keeps its length", from = 0, to = 2.5 }
caption { text = "The spring pulls with $F = k (l - l_0)$, against gravity $m g$", from = 2.5, to = 5 }
caption { text = "The spring swings at $\\omega = 2 \\pi / T$ with $\\omega^2 = \\frac{k}{m}$", from = 5, to = 7.5 }
caption { text = "The rod is slower the farther it swings; for small angles $\\omega^2 = \\frac{g}{l}$", from = 7.5 }
