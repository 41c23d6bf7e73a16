-- Boxes of five centimetres, thirty rows high: tolerances chosen for metres are large here.
local rows, side = 30, 0.05

scenario {
  title = "Pyramid of five-centimetre boxes",
  description = "465 boxes of 5 cm must stay where they are; Box2D calls it hard, its slop is a tenth of a box.",
  duration = 5, rate = 60, fps = 60, gravity = {0, -10}, method = { substeps = 4 }, effects = "auto",
  view = { center = {0, 0.73}, height = 1.8 }, layers = { "bodies" },
  golden = { frames = { 299 }, size = {480, 270} },
}
include "include/gates.lua"

ground { y = 0, friction = 0.6 }
local boxes, top = {}, nil
for row = 1, rows do
  local n = rows - row + 1
  for i = 1, n do
    top = body { name = ("row %d, box %d"):format(row, i), at = { (i - (n + 1) / 2) * side, (row - 0.5) * side },
                 shape = box { width = side, height = side }, friction = 0.6 }
    boxes[#boxes + 1] = top
  end
end

no_overlap(side, 1)
no_energy_gained(boxes, rows * side)
local height = (rows - 0.5) * side
measure("top down", function() return height - top:position().y end)
measure("top sideways", function() return top:position().x end)
-- A row that gives way lowers the top by a whole side.
expect("the pyramid stands: its top is less than half a box lower", function()
  return height - top:position().y < side / 2 and math.abs(top:position().x) < side / 2
end, { always = true })
expect("quality: the top keeps 98 percent of its height", function() return top:position().y > 0.98 * height end)
expect("quality: the top comes to rest", function()
  return math.abs(top:velocity().y) + math.abs(top:velocity().x) < 1e-3
end)
