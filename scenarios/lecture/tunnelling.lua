-- Fast bodies and thin walls: an engine that looks at its ticks only never sees what happens between them.
scenario {
  title = "Tunnelling and continuous collision",
  description = "Three balls fly at a thin wall, with and without continuous collision; pale copies mark every tick.",
  duration = 3, rate = 20, fps = 20, gravity = {0, 0}, method = { substeps = 1 },
  view = { center = {0.2, 0}, height = 5.6 }, layers = { "bodies", "trails", "labels" },
  golden = { frames = {0, 4, 100, 229}, size = {640, 360} },
}

local with_ccd = pane { title = "with continuous collision", effects = { "contacts", "friction", "restitution", "ccd" } }
pane { title = "at the ticks only", effects = { "contacts", "friction", "restitution" } }

body { name = "wall", type = "static", at = {0, 0}, shape = box { width = 0.06, height = 5 } }
local balls = {}
for i, speed in ipairs { 2, 6, 14 } do
  local ball = body { name = speed .. " m/s", at = {-2.45, 3.2 - 1.6 * i}, velocity = {speed, 0}, shape = circle { radius = 0.13 } }
  highlight { at = {-2.45, 3.2 - 1.6 * i}, radius = 0.15, text = speed .. " m/s" }   -- where it starts: clear of the wall
  ghost { body = ball, every = 0.05 }
  balls[i] = ball
end

section { at = 0, name = "The flight" }
section { at = 1.6, name = "What became of the balls" }
freeze { at = 0.3, seconds = 4.5 }
freeze { at = 2.9, seconds = 4 }
caption { text = "20 ticks a second: at 14 m/s a ball moves $v h$ = 70 cm from one tick to the next", from = 0, to = 1.6 }
caption { text = "Who looks at the ticks only never finds the fast ball at the wall", from = 1.6 }

expect("the slow ball stays on its side", function() return balls[1]:position().x < 0 end)
if with_ccd then
  expect("no ball reaches into the wall by more than a centimetre", function()
    for _, ball in ipairs(balls) do if ball:position().x > -0.15 then return false end end
    return true
  end, { always = true })
else
  expect("the fast ball has passed the wall", function() return balls[3]:position().x > 1 end)
end
