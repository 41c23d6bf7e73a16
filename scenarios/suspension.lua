-- A car with sprung wheels: it rests at its static sag, then its motor takes it over bumps.
scenario {
  title = "Suspension",
  description = "Two sprung, driven wheels carry a car over bumps; at rest the springs give by m g / (2 k).",
  duration = 8, view = { center = {0, 1.75}, height = 5 },
  layers = { "bodies", "joints" },
  golden = { frames = { 0, 89, 450, 689 } },
}

for i = 0, 5 do
  body { name = "bump " .. i, type = "static", at = { 3.5 + 1.9 * i, -0.28 }, shape = circle { radius = 0.4 }, friction = 0.9 }
end
ground { y = 0 }
local stiffness, mass = 700, 12
local car = body { name = "car", at = {-2, 0.95}, mass = mass, shapes = {
  box { width = 2.4, height = 0.4 }, hull { {-0.9, 0.2}, {0.6, 0.2}, {0.3, 0.65}, {-0.6, 0.65} } }, group = -1 }
local tyres = {}
local function axle(x)
  local tyre = body { name = "wheel", color = 0x9AA5B1, at = { x, 0.35 }, shape = circle { radius = 0.35 }, mass = 1.5, friction = 0.9, group = -1 }
  tyres[#tyres + 1] = tyre
  return wheel { car, tyre, at = { x, 0.35 }, axis = {0, 1}, stiffness = stiffness, damping = 45, motor = { speed = 0, max_torque = 12 } }
end
local rear, front = axle(-2.8), axle(-1.2)
local from = car:position().y

at(2, function() rear:set { speed = -9 } front:set { speed = -9 } end)
camera { follow = car }
local sag = mass * 9.81 / (2 * stiffness)
local start = car:center()
measure("sag", function() return from - car:position().y end)
measure("speed", function() return car:velocity().x end)
expect("at rest the springs give by m g / (2 k)", function()
  return math.abs((start.y - car:center().y) - sag) < 0.01 * sag
end, { at = 2 })
expect("the wheels stay on their axes", function() return rear:gap() < 1e-9 and front:gap() < 1e-9 end, { always = true })
expect("the car gets over all bumps", function() return car:position().x > 14 end)
expect("the car stays on its wheels", function() return math.abs(car:angle()) < 0.5 end, { always = true })
local function travel(i, x)   -- how far the wheel is pushed into the car, cm
  local p, a = tyres[i]:position(), car:angle()
  local dx, dy = p.x - car:position().x, p.y - car:position().y
  return 100 * (-math.sin(a) * dx + math.cos(a) * dy + 0.6)
end
plot { title = "Springs pushed in (cm)", seconds = 8, at = "top_left",
       y = { rear = function() return travel(1) end, front = function() return travel(2) end } }
freeze { at = 1.9, seconds = 3.5 }
caption { text = "At rest the springs give by m g / (2 k) = 8.4 cm", from = 0, to = 2 }
caption { text = "Driving over bumps, the springs take up the blows", from = 2 }
