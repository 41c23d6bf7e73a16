-- What ./dev bench films: enough bodies that drawing and stepping count beside the encoder.
scenario {
  title = "Four hundred falling bodies", duration = 5, seed = 4, size = {1920, 1080}, view = { center = {8, 4.5}, height = 9 },
  description = "Three hundred discs and a hundred boxes drop into a heap; the picture they fill is full HD.",
  layers = { "bodies" },
}

local width, height = 16, 9
local gap, row_height = 0.03, 0.61
ground { y = 0 }
wall { a = {0, 0}, b = {0, height} }
wall { a = {width, 0}, b = {width, height} }
wall { a = {0, height}, b = {width, height} }

-- Bodies are laid into rows like words into lines, so that they fill the picture and none overlap. Every fourth is a
-- box. Half a disc of the widest kind is all a row may stand out.
local x, y = gap, 0.6
for i = 1, 400 do
  local is_box = i % 4 == 0
  local size = is_box and 0.3 + 0.15 * math.random() or 0.3 + 0.3 * math.random()
  if x + size + gap > width then x, y = gap, y + row_height end
  body { name = (is_box and "box " or "disc ") .. i, at = { x + size / 2, y }, restitution = 0.4, friction = 0.4,
         velocity = { 4 * math.random() - 2, 2 * math.random() }, spin = 6 * math.random() - 3,
         shape = is_box and box { width = size, height = size } or circle { radius = size / 2 } }
  x = x + size + gap
end
