-- The order of integrators on the simplest problem with a scale of time, and their limit: omega h < 2 for verlet and
-- symplectic Euler. The cosine is Hooke's law (1678) under Newton's second.
scenario {
  title = "Mass on a spring", duration = 10, gravity = {0, 0}, view = { center = {-0.6, 0}, height = 2.6 },
  description = "1 kg on 100 N/m, let go at 1 m: sixteen swings beside cos 10 t.",
  layers = { "bodies", "joints", "vectors" }, golden = { frames = { 0, 22, 599 }, size = {480, 270} },
}

local mass, stiffness, rest, x0 = 1, 100, 2, 1
local omega = math.sqrt(stiffness / mass)
body { name = "post", type = "static", at = { -rest - 0.06, 0 }, group = -1,
       shape = box { width = 0.12, height = 0.8 } }
local block = body { name = "block", at = {x0, 0}, mass = mass, fixed_rotation = true, group = -1,
                     shape = box { width = 0.3, height = 0.3 } }
spring { world, block, from = {-rest, 0}, to = {x0, 0}, stiffness = stiffness, length = rest }

measure("x", function() return block:position().x end)
reference("x", function(t) return x0 * math.cos(omega * t) end)
measure("v", function() return block:velocity().x end)
reference("v", function(t) return -x0 * omega * math.sin(omega * t) end)
measure("energy", function() return energy().total end)
reference("energy", function() return stiffness * x0 ^ 2 / 2 end)

expect("after 10 s it is where the cosine says, to 2 mm", function()
  return math.abs(block:position().x - x0 * math.cos(omega * time())) <= 2e-3
end)
expect("the energy stays within a thousandth",
       function() return math.abs(energy().total / 50 - 1) <= 1e-3 end, { always = true })
vector { body = block, of = "velocity", scale = 0.08 }
