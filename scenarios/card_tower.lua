-- Nothing but friction holds this up: thin cards leaning on each other, three storeys high.
scenario {
  title = "Card tower", duration = 6, rate = 480, view = { center = {0, 1.4}, height = 3.7 },
  description = "Leaning pairs of thin cards stand by friction alone, until a ball arrives.",
  golden = { frames = { 0, 180, 250, 359 } }, layers = { "bodies", "contacts" }, method = { substeps = 4 },
}

ground { y = 0, friction = 0.8 }
local card, thin, lean = 0.8, 0.016, math.rad(22)
local wide, high = card * math.sin(lean), card * math.cos(lean)
local storey = high + thin * 2.2
local cards = {}
local function add(name, x, y, angle)
  cards[#cards + 1] = body { name = name, at = {x, y}, angle = angle, friction = 0.8, shape = box { width = thin, height = card } }
end
for level = 0, 2 do
  local pairs_here = 3 - level
  for i = 1, pairs_here do
    local x = (i - (pairs_here + 1) / 2) * (2 * wide + 0.1)
    local y = level * storey + high / 2 + thin / 2
    add(("leaning left %d.%d"):format(level, i), x - wide / 2 - thin / 2, y, -lean)
    add(("leaning right %d.%d"):format(level, i), x + wide / 2 + thin / 2, y, lean)
  end
  for i = 1, pairs_here - 1 do
    add(("flat %d.%d"):format(level, i), (i - pairs_here / 2) * (2 * wide + 0.1), level * storey + high + thin * 1.7, math.pi / 2)
  end
end
local peak = cards[#cards]
local start = peak:position()
expect("the tower stands for three seconds", function() return peak:position().y > 0.97 * start.y end, { at = 2.9 })
at(3, function()
  body { name = "ball", at = {-2.4, 0.9}, velocity = {4.2, 1.2}, shape = circle { radius = 0.09 }, density = 3, bullet = true }
end)
expect("the ball brings it down", function() return peak:position().y < 0.8 * start.y end, { finally = true })
caption { text = "Friction alone holds it", from = 0, to = 2.8, at = "top" }
