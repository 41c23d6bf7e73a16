-- Infinitely many impacts in finite time: a method that locates them all never comes to the end, one that does not is
-- off by steps. The flights are a geometric series: sqrt(2 h / g) (1 + e) / (1 - e) = 1.3546 s (paradox of Zeno).
scenario {
  title = "Zeno's ball", duration = 2, rate = 240, method = { contact_solver = "event" },
  description = "Each bounce takes half as long as the one before: all are over after 1.3546 s.",
  view = { center = {0, 0.6}, height = 1.6 }, layers = { "bodies", "trails", "grid" },
  golden = { frames = { 0, 40, 119 }, size = {480, 270} },
}

local drop, e, radius, g = 1, 0.5, 0.1, 9.81
ground { y = 0, friction = 0 }
local ball = body { name = "ball", at = { 0, drop + radius }, restitution = e, friction = 0,
                    shape = circle { radius = radius } }
local fall = math.sqrt(2 * drop / g)
local function exact(t)
  if t <= fall then return drop - g * t * t / 2 end
  local since, flight = t - fall, 2 * fall * e
  while flight > 1e-12 do
    if since <= flight then return g * since * (flight - since) / 2 end
    since, flight = since - flight, flight * e
  end
  return 0
end
measure("gap", function() return ball:position().y - radius end)
reference("gap", exact)

local stop = fall * (1 + e) / (1 - e)
expect("all flights together take 1.35457092296 s", function() return math.abs(stop - 1.354570922957193) <= 1e-12 end)
local fifth = 1.298130467833976
expect("at its apex after the fifth impact, 0.977 mm high, it is where it should be, to 1e-8 m", function()
  return math.abs(ball:position().y - radius - exact(time())) <= 1e-8
end, { at = fifth + fall * e ^ 5 })
expect("a hundredth of a second before the end it still moves, afterwards no more", function()
  local v = math.abs(ball:velocity().y)
  return time() > stop - 0.01 and (time() < stop + 0.01 or v <= 1e-6) or time() <= stop - 0.01
end, { always = true })
expect("in the end it lies on the floor, to 1e-6 m", function() return math.abs(ball:position().y - radius) <= 1e-6 end)
trail { body = ball, seconds = 0.4 }
