-- Friction that ends: a block slides at 5 m/s, comes to rest after v / (mu g) and v^2 / (2 mu g), and stays there.
-- G. Amontons 1699, C. A. Coulomb 1785.
scenario {
  title = "Sliding to a stop", duration = 2, rate = 240, view = { center = {1.7, 0.6}, height = 3 },
  description = "5 m/s and a coefficient of 0.4: at rest after 1.274 s and 3.186 m.",
  layers = { "bodies", "vectors", "grid" }, golden = { frames = { 0, 40, 119 }, size = {480, 270} },
}

local mu, g, speed = 0.4, 9.81, 5
ground { y = 0, friction = mu }
local block = body { name = "block", at = {0, 0.15}, velocity = {speed, 0}, friction = mu,
                     shape = box { width = 0.6, height = 0.3 } }
local stop = speed / (mu * g)
local function exact(t)
  local s = math.min(t, stop)
  return speed * s - mu * g * s * s / 2
end
measure("x", function() return block:position().x end)
reference("x", exact)
measure("v", function() return block:velocity().x end)
reference("v", function(t) return math.max(0, speed - mu * g * t) end)
expect("it stops after 3.18552497452 m, to 1 mm",
       function() return math.abs(block:position().x - 3.185524974515800) <= 1e-3 end)
expect("it lies still from 1.275 s on, to 1e-9 m/s", function()
  local v = block:velocity()
  return time() < 1.275 + 1 / 120 or math.abs(v.x) <= 1e-9
end, { always = true })
vector { body = block, of = "velocity", scale = 0.2 }
