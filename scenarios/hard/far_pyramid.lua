-- Solver2D's FarPyramid: its boxes start apart and fall into place. Out there a float's next neighbour is 8 mm away.
scenario {
  title = "A pyramid far away", duration = 8, rate = 60, fps = 60, gravity = {0, -10}, method = { substeps = 4 },
  description = "Ten rows at (100 km, -80 km), where single precision knows positions to 8 mm only.",
  view = { center = {100000, -80000 + 6.1}, height = 14.6 }, layers = { "bodies", "contacts" },
  golden = { frames = { 0, 479 }, size = {480, 270} },
}
include "include/gates.lua"

local far_x, far_y, rows, pitch = 100000, -80000, 10, 1.25
body { name = "floor", type = "static", at = {far_x, far_y}, friction = 0.6,
       shape = box { width = 60, height = 1, at = {0, -0.5} } }
local boxes = {}
for row = 1, rows do
  for i = 1, rows - row + 1 do
    boxes[#boxes + 1] = body { name = ("row %d, box %d"):format(row, i), friction = 0.6,
                               at = { far_x + (i - (rows - row + 2) / 2) * pitch, far_y + 0.5 + (row - 0.5) * pitch },
                               shape = box { width = 1, height = 1 } }
  end
end
local top = boxes[#boxes]
measure("top height", function() return top:position().y - far_y end)
measure("top aside", function() return top:position().x - far_x end)
expect("it stands: the top keeps 98 percent of its height", function()
  return math.abs(top:position().y - far_y - (rows - 0.5)) <= 0.02 * rows
end)
expect("it stands: the top stays within 10 cm of the axis",
       function() return math.abs(top:position().x - far_x) <= 0.1 end)
expect("quality: in the end nothing moves faster than 5 mm/s", function()
  for _, b in ipairs(boxes) do
    local v = b:velocity()
    if math.sqrt(v.x^2 + v.y^2) > 5e-3 then return false end
  end
  return true
end)
no_overlap(1, 4)
no_energy_gained(boxes, rows * pitch)
