-- A film for a telephone: the scene is made for a wide picture, its golden pictures are upright.
scenario {
  title = "Hung on a spring, and let go", duration = 4, view = { center = {0, 0}, height = 4 },
  description = "A weight swings about where it would hang still; its energy goes to and fro, and none of it is lost.",
  layers = { "bodies", "joints", "vectors", "labels", "clock" }, golden = { frames = {0, 30, 150}, size = {360, 640} },
}

local mass, stiffness = 2, 40
local weight = body { name = "weight", at = {0, 0.8}, mass = mass, shape = box { width = 0.7, height = 0.5 } }
spring { world, weight, from = {0, 1.9}, to = {0, 1.05}, stiffness = stiffness, damping = 0, length = 0.85 }
body { name = "beam", type = "static", at = {0, 1.95}, shape = box { width = 3.4, height = 0.1 } }
label { body = weight, text = "2 kg" }
vector { body = weight, of = "velocity", scale = 0.3 }
caption { text = "Let go", from = 0, to = 1, at = "top" }
freeze { at = 3.9, seconds = 2 }
caption { text = "It swings at $\\omega$ with $\\omega^2 = \\frac{k}{m}$, however far it falls", from = 1 }

local function height() return weight:position().y - 0.8 end
plot { title = "Height (m)", seconds = 4, at = "top_right", y = { height = height } }
plot { title = "Energy (J)", seconds = 4, at = "bottom_right", y = {
  kinetic = function() return energy().kinetic end,
  potential = function() return energy().potential end,
} }

local omega, sag = math.sqrt(stiffness / mass), mass * 9.81 / stiffness
measure("height", height)
reference("height", function(t) return sag * (math.cos(omega * t) - 1) end)
local total = energy().total
expect("no energy is lost", function() return math.abs(energy().total - total) < 0.01 end, { always = true })
expect("it never rises above where it was let go", function() return height() < 1e-6 end, { always = true })
