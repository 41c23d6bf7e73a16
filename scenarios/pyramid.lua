-- A hundred and twenty boxes that have nothing to do but stay where they are.
scenario {
  title = "Pyramid", duration = 5, view = { center = {0, 5.6}, height = 14 },
  description = "Fifteen rows of boxes at rest: the simplest test that most engines fail a little.",
  layers = { "bodies", "contacts", "bvh" }, golden = { frames = { 0, 30, 299 } },
}

ground { y = 0 }
local rows, side, pitch = 15, 0.8, 0.9
local top
for row = 1, rows do
  local boxes = rows - row + 1
  for i = 1, boxes do
    top = body { name = ("row %d, box %d"):format(row, i), at = { (i - (boxes + 1) / 2) * pitch, (row - 0.5) * side },
                 shape = box { width = side, height = side }, friction = 0.6 }
  end
end

local start = top:position()
measure("top height", function() return top:position().y end)
reference("top height", function() return start.y end)
expect("the top keeps 99 percent of its height", function() return top:position().y > 0.99 * start.y end, { finally = true })
expect("the top is within 1 cm of the axis", function() return math.abs(top:position().x) < 0.01 end, { finally = true })
expect("everything has come to rest", function()
  local v = top:velocity()
  return math.sqrt(v.x^2 + v.y^2) < 1e-3
end, { finally = true })
