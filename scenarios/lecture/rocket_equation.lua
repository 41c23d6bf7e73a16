-- Thesis, 3.3: far from everything, a rocket is driven by what it throws out behind. Its mass falls as it burns.
local dry, fuel, exhaust, rate = 20, 60, 120, 15                   -- kg, kg, m/s, kg/s: burns for 4 s

scenario {
  title = "The rocket equation",
  description = "A rocket in empty space burns three quarters of its mass: the speed follows Tsiolkovsky's equation.",
  duration = 5.5, gravity = {0, 0}, view = { center = {0, 0}, height = 24 }, theme = "dark",
  layers = { "bodies", "trails", "vectors", "labels", "grid" }, golden = { frames = {80, 480, 956, 1316}, size = {640, 360} },
}

local ship = body {
  name = "rocket", mass = dry + fuel, angle = -math.pi / 2,
  shape = polygon { {-1.2, -2}, {1.2, -2}, {1.2, -1.2}, {0.7, 0}, {0.7, 1.6}, {0, 3}, {-0.7, 1.6}, {-0.7, 0}, {-1.2, -1.2} },
}
rocket { body = ship, thrust = exhaust * rate, burn_rate = rate, fuel = fuel }
local function ideal(t) return exhaust * math.log((dry + fuel) / (dry + fuel - rate * math.min(t, fuel / rate))) end

camera { follow = ship }
vector { body = ship, of = "momentum", scale = 0.0025 }
trail { body = ship, seconds = 0.5 }

section { at = 0, name = "Burning" }
section { at = 2, name = "Lighter and faster" }
section { at = 4, name = "Burnt out" }
slow { from = 0, to = 5.5, factor = 0.25 }
caption { text = "$q$ = 15 kg of gas leave at $u$ = 120 m/s every second: the thrust is $u q$", from = 0, to = 2 }
caption { text = "The lighter it gets, the more the same thrust accelerates it: $\\frac{dv}{dt} = \\frac{u q}{m}$", from = 2, to = 4 }
caption { text = "Burnt out at $v = u \\cdot ln \\frac{m_0}{m}$ = 120 m/s $\\cdot$ ln 4 = 166 m/s", from = 4 }
plot { title = "Speed", unit = "m/s", seconds = 5.5, at = "top_left",
       y = { speed = function() return ship:velocity().x end } }
plot { title = "Mass", unit = "kg", seconds = 5.5, at = "top_right", y = { mass = function() return ship:mass() end } }

measure("speed", function() return ship:velocity().x end)
reference("speed", ideal)
measure("mass", function() return ship:mass() end)
reference("mass", function(t) return dry + fuel - rate * math.min(t, fuel / rate) end)
expect("the speed follows Tsiolkovsky's equation", function()
  return math.abs(ship:velocity().x - ideal(time())) < 1e-3
end, { always = true })
expect("it flies straight on", function() return math.abs(ship:velocity().y) < 1e-9 end, { always = true })
