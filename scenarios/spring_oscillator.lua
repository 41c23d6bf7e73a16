-- One mass, one spring: the textbook's cosine, and two lighter companions that swing faster.
scenario {
  title = "Mass on a spring", duration = 8, rate = 960, gravity = {0, 0}, view = { center = {-0.25, 0}, height = 4.2 },
  description = "Harmonic oscillators of 4, 1 and 0.25 kg on equal springs, beside the cosine.",
  golden = { frames = { 0, 37, 200 } }, layers = { "bodies", "joints", "vectors", "labels" },
}

local k, x0 = 40, 0.7
for i, mass in ipairs { 4, 1, 0.25 } do
  local y = 1.0 - 1.1 * (i - 1)
  local side = 0.28 * mass^0.25 + 0.1
  body { name = "post", type = "static", at = { -1.6, y }, shape = box { width = 0.14, height = 0.8 } }
  local block = body { name = mass .. " kg", at = { x0, y }, mass = mass, fixed_rotation = true, shape = box { width = side, height = side } }
  spring { world, block, from = { -1.53, y }, to = { x0, y }, stiffness = k, length = 1.53 }
  label { body = block, text = mass .. " kg" }
  vector { body = block, of = "velocity", scale = 0.12 }
  local omega = math.sqrt(k / mass)
  local name = ("x at %g kg"):format(mass)
  measure(name, function() return block:position().x end)
  reference(name, function(t) return x0 * math.cos(omega * t) end)
end
local total = energy().total
expect("the energy stays to a thousandth", function() return math.abs(energy().total - total) < 1e-3 * total end, { always = true })
