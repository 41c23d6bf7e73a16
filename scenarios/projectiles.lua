-- Same speed, different angles: forty-five degrees goes farthest, and complementary angles land together.
scenario {
  title = "Range of a throw", duration = 2.2, view = { center = {5.5, 2.1}, height = 6.8 },
  description = "Throws at 15 to 75 degrees beside the parabola formula.",
  golden = { frames = { 15, 45, 90, 131 } }, layers = { "bodies", "trails", "grid", "labels" },
}

ground { y = 0 }
local speed = 10
for i, degrees in ipairs { 15, 30, 45, 60, 75 } do
  local a = math.rad(degrees)
  local ball = body { name = degrees .. " degrees", at = {0, 0.1}, velocity = { speed * math.cos(a), speed * math.sin(a) },
                      shape = circle { radius = 0.1 }, category = 1 << i, mask = 1, friction = 1, group = -2,
                      color = ({ 0x4a7fb5, 0x3c9a8f, 0xb8433f, 0xd98c2b, 0x8c6bb1 })[i] }
  label { body = ball, text = degrees .. "°" }
  trail { body = ball, seconds = 2.2 }
  local landed
  on_contact(ball, nil, function() if time() > 0.3 then landed = landed or ball:position().x end end)
  local range = speed^2 * math.sin(2 * a) / 9.81
  expect(("%d degrees lands at %.2f m"):format(degrees, range), function() return math.abs((landed or 0) - range) < 0.05 end,
         { finally = true })
end
