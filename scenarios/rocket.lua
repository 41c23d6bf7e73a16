-- A rocket leaves the ground: thrust against weight, a mass that falls as it burns, and the drag of the air.
scenario {
  title = "Lift-off", duration = 8, view = { center = {0, 9}, height = 22 }, theme = "dark",
  description = "A rocket that loses mass, with drag; the plot compares it with Tsiolkovsky's equation.",
  layers = { "bodies", "trails", "vectors", "labels", "grid" }, golden = { frames = { 0, 150, 330, 479 } },
}

local dry, fuel, exhaust, rate = 40, 60, 300, 12                  -- kg, kg, m/s, kg/s: burns for 5 s
local thrust = exhaust * rate
drag { quadratic = 0.12 }
ground { y = 0 }
body { name = "pad", type = "static", at = {0, 0.15}, shape = box { width = 3.4, height = 0.3 } }

local ship = body {
  name = "rocket", at = {0, 0.3}, mass = dry + fuel, friction = 0.8,
  shape = polygon { {-0.9, 0}, {-0.45, 0.35}, {0.45, 0.35}, {0.9, 0}, {0.9, 0.5}, {0.5, 1.1}, {0.5, 3}, {0, 4.2},
                    {-0.5, 3}, {-0.5, 1.1}, {-0.9, 0.5} },
}
rocket { body = ship, thrust = thrust, burn_rate = rate, fuel = fuel }

local function ideal(t)                                           -- no drag
  local burnt = rate * math.min(t, fuel / rate)
  return exhaust * math.log((dry + fuel) / (dry + fuel - burnt)) - 9.81 * t
end

camera { follow = ship }
trail { body = ship, seconds = 2 }
vector { body = ship, of = "velocity", scale = 0.03 }
plot { title = "speed, m/s", seconds = 8, at = "top_right",
       y = { rocket = function() return ship:velocity().y end, ["without drag"] = function() return ideal(time()) end } }
measure("mass", function() return ship:mass() end)
reference("mass", function(t) return dry + fuel - rate * math.min(t, fuel / rate) end)
expect("all the fuel is burnt", function() return math.abs(ship:mass() - dry) < 1e-9 end)
expect("it flies straight up", function() return math.abs(ship:center().x) < 1e-6 end, { always = true })
