-- Ten rows of boxes of 2 m; the last one, `times` as heavy, falls on the others from 2 m (Solver2D's HighMassRatio1).
-- The load can go straight down through every row, so that statics asks for no friction at all: it stands.
function topped_pyramid(times)
  ground { y = 0 }
  local boxes, rows = {}, 10
  for row = 1, rows do
    for i = 1, rows - row + 1 do
      local is_top = row == rows
      boxes[#boxes + 1] = body { name = ("row %d, box %d"):format(row, i), density = is_top and times or 1,
                                 at = { 2 * i - rows + row - 2, 2 * row - (is_top and -1 or 1) },
                                 shape = box { width = 2, height = 2 } }
    end
  end
  local top = boxes[#boxes]
  local rest = 2 * rows - 1
  measure("top height", function() return top:position().y end)
  measure("top aside", function() return top:position().x end)
  expect("it stands: the top keeps 98 percent of its height", function() return top:position().y >= 0.98 * rest end)
  expect("it stands: the top stays within a quarter of its width of the axis",
         function() return math.abs(top:position().x) <= 0.5 end)
  expect("quality: the top stays within 10 cm of the axis", function() return math.abs(top:position().x) <= 0.1 end)
  expect("quality: the top is level to a hundredth", function() return math.abs(top:angle()) <= 0.01 end)
  no_overlap(2, 3)
  no_energy_gained(boxes, rest)
end
