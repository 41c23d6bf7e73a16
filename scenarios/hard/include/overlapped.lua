-- A pyramid of boxes of one metre that overlap by a quarter of their size, to the side and downwards (Solver2D's
-- OverlapRecovery): it has to come apart gently and stay a pyramid.
function overlapped_pyramid(rows, fastest)
  ground { y = 0 }
  local boxes, pitch = {}, 0.75
  for row = 1, rows do
    for i = 1, rows - row + 1 do
      boxes[#boxes + 1] = body { name = ("row %d, box %d"):format(row, i), friction = 0.6,
                                 at = { (i - (rows - row + 2) / 2) * pitch, 0.5 + (row - 1) * pitch },
                                 shape = box { width = 1, height = 1 } }
    end
  end
  local top = boxes[#boxes]
  local function speed()
    local most = 0
    for _, b in ipairs(boxes) do
      local v = b:velocity()
      most = math.max(most, math.sqrt(v.x^2 + v.y^2))
    end
    return most
  end
  measure("fastest", speed)
  measure("top height", function() return top:position().y end)
  expect(("nothing flies: no box is ever faster than %g m/s"):format(fastest), function() return speed() <= fastest end,
         { always = true })
  expect("it stays a pyramid: the top rests within 5 cm of its full height",
         function() return math.abs(top:position().y - (rows - 0.5)) <= 0.05 end)
  expect("the top stays within half a box of the axis", function() return math.abs(top:position().x) <= 0.5 end)
  expect("quality: in the end nothing moves faster than 5 mm/s", function() return speed() <= 5e-3 end)
  return boxes
end
