-- Seen from above: ten pins, one ball, no gravity in the plane.
scenario {
  title = "Bowling, from above", duration = 3, gravity = {0, 0}, view = { center = {0.9, 0}, height = 4.2 },
  description = "A heavy ball meets a triangle of ten light pins.",
  golden = { frames = { 0, 30, 60, 179 } }, layers = { "bodies", "trails", "vectors" },
}

for _, side in ipairs { -1, 1 } do
  body { name = "gutter", type = "static", at = {0.9, side * 1.75}, shape = box { width = 9, height = 0.18 }, restitution = 0.4 }
end
local pins = {}
for row = 0, 3 do
  for i = 0, row do
    pins[#pins + 1] = body { name = ("pin %d"):format(#pins + 1), at = { 1 + row * 0.46, (i - row / 2) * 0.52 }, restitution = 0.7,
                             friction = 0.2, shape = circle { radius = 0.09 }, density = 1.6, color = 0xb8433f }
  end
end
local ball = body { name = "ball", at = {-2.3, 0.06}, velocity = {4, 0.02}, restitution = 0.6, friction = 0.2,
                    shape = circle { radius = 0.24 }, density = 5 }
trail { body = ball, seconds = 3 }
vector { body = ball, of = "momentum", scale = 0.12 }

local function momentum()
  local p = ball:mass() * ball:velocity().x
  for _, pin in ipairs(pins) do p = p + pin:mass() * pin:velocity().x end
  return p
end
local before = momentum()
measure("momentum along the lane", momentum)
expect("until the gutters are met no momentum along the lane is lost", function()
  return math.abs(momentum() - before) < 1e-9 * before
end, { at = 0.95 })
expect("a strike", function()
  for _, pin in ipairs(pins) do
    local p = pin:position()
    if math.abs(p.x - 1) < 0.05 and math.abs(p.y) < 0.05 then return false end
  end
  return true
end, { finally = true })
