-- Whether a constant force is integrated exactly: verlet does, symplectic Euler is off by g T h / 2 to the last digit.
-- The parabola is Galilei's (1638).
scenario {
  title = "Projectile", duration = 1, view = { center = {1.7, 10}, height = 3.6 },
  description = "Free flight from 10 m at 3 and 5 m/s: on the parabola to the last digits.",
  layers = { "bodies", "trails", "vectors", "grid" }, golden = { frames = { 0, 59 }, size = {480, 270} },
}

local g = 9.81
local ball = body { name = "ball", at = {0, 10}, velocity = {3, 5}, shape = circle { radius = 0.08 } }
measure("x", function() return ball:position().x end)
reference("x", function(t) return 3 * t end)
measure("y", function() return ball:position().y end)
reference("y", function(t) return 10 + 5 * t - g * t * t / 2 end)

local function off() return math.abs(ball:position().y - 10.095) end
expect("after 1 s it is 10.095 m high, to 1e-12 m", function() return off() <= 1e-12 end)
trail { body = ball, seconds = 1 }
vector { body = ball, of = "velocity", scale = 0.1 }
