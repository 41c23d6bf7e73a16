-- Boxes of one metre, one on the other, shifted to the left and to the right in turns by `shift` metres.
function stack_of(count, shift)
  ground { y = 0, friction = 0.3 }
  local boxes = {}
  for i = 1, count do
    boxes[i] = body { name = "box " .. i, at = { i % 2 == 1 and -shift or shift, i - 0.5 }, friction = 0.3,
                      shape = box { width = 1, height = 1 } }
  end
  local top = boxes[count]
  local start = top:position()
  local function lean() return math.abs(top:position().x - start.x) end
  local function sink() return start.y - top:position().y end
  measure("lean", lean)
  measure("sink", sink)
  -- 5 cm and 2 cm for a stack of fifteen, and in proportion to the height
  local may_lean, may_sink = 0.05 * count / 15, 0.02 * count / 15
  expect(("it stands: the top leans by less than %.0f cm"):format(100 * may_lean),
         function() return lean() <= may_lean end, { always = true })
  expect(("it stands: the top sinks by less than %.0f cm"):format(100 * may_sink),
         function() return sink() <= may_sink end, { always = true })
  expect("nothing jumps: the top rises by less than 2 cm", function() return sink() >= -0.02 end, { always = true })
  expect("quality: in the end the top moves slower than 1 mm/s", function()
    local v = top:velocity()
    return math.sqrt(v.x^2 + v.y^2) < 1e-3
  end)
  no_overlap(1, 1)
  no_energy_gained(boxes, count)
  return boxes
end
