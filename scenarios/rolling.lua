-- How far does it roll? Rolling resistance is a lever r: the ground brakes with a torque of r times the normal force.
scenario {
  title = "Rolling resistance", duration = 10, view = { center = {5.15, 2.1}, height = 7 },
  description = "Four equal discs, four levers: each stops after v^2 / (2a) with a = g (r/R) / (1 + I / (m R^2)).",
  layers = { "bodies", "labels", "trails" }, golden = { frames = { 0, 120, 300, 599 } },
}

local R, v = 0.3, 2
local lanes = {}
for i, r in ipairs { 0.01, 0.014, 0.02, 0.04 } do
  local y = 4.4 - 1.2 * (i - 1)
  wall { a = {-0.4, y}, b = {11.2, y}, friction = 0.5 }
  local disc = body { name = ("r = %g mm"):format(1000 * r), at = {0, y + R}, velocity = {v, 0}, spin = -v / R,
                      shape = circle { radius = R }, friction = 0.5, rolling_resistance = r }
  label { body = disc, text = ("r = %g mm"):format(1000 * r) }
  trail { body = disc, seconds = 10 }
  body { name = "mark", type = "static", at = { v * v / (2 * 9.81 * (r / R) / 1.5), y - 0.17 }, shape = box { width = 0.06, height = 0.26 } }
  lanes[i] = { disc = disc, a = 9.81 * (r / R) / 1.5, name = ("way at r = %g mm"):format(1000 * r) }
end

for _, lane in ipairs(lanes) do
  measure(lane.name, function() return lane.disc:center().x end)
  reference(lane.name, function(t)
    local rolling = math.min(t, v / lane.a)
    return v * rolling - lane.a * rolling * rolling / 2
  end)
  expect(lane.name .. " obeys the law", function()
    local rolling = math.min(time(), v / lane.a)
    return math.abs(lane.disc:center().x - (v * rolling - lane.a * rolling * rolling / 2)) < 0.02
  end, { always = true })
end
expect("all stand still in the end", function()
  for _, lane in ipairs(lanes) do
    if math.abs(lane.disc:velocity().x) > 1e-6 then return false end
  end
  return true
end)
caption { text = "Slowed evenly by 2/3 g r/R, each stops above its mark", from = 0, to = 10 }
