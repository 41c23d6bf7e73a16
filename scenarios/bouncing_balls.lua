-- Each bounce takes its share: the height that is left is the square of the restitution.
scenario {
  title = "Restitution", duration = 5, view = { center = {0, 1.6}, height = 4 },
  description = "Five balls that differ only in restitution, from clay to a perfect rubber.",
  golden = { frames = { 0, 40, 75, 299 } }, layers = { "bodies", "trails", "labels" },
}

ground { y = 0 }
local colors = { 0x8c6bb1, 0x4a7fb5, 0x3c9a8f, 0xd98c2b, 0xb8433f }
for i, e in ipairs { 0, 0.5, 0.7, 0.9, 1 } do
  local ball = body { name = ("e = %.1f"):format(e), at = { (i - 3) * 0.8 + 1.45, 2.15 }, restitution = e, color = colors[i],
                      shape = circle { radius = 0.15 }, category = 1 << i, mask = 1 }
  label { body = ball, text = ("e = %.1f"):format(e) }
  trail { body = ball, seconds = 0.35 }
  local apex, touched = 0, false
  on_contact(ball, nil, function() touched = time() < 1 end)
  every(1 / 240, function()
    if touched and time() < 1.27 then apex = math.max(apex, ball:position().y - 0.15) end
  end)
  expect(("e = %.1f rises to e squared of its height"):format(e), function() return math.abs(apex - 2 * e * e) < 0.01 end,
         { finally = true })
end
plot { title = "Energy (J)", seconds = 5, at = "top_left", y = { total = function() return energy().total end } }
