-- Thesis, 3.5: in a stack at rest every contact carries the weight of all that lies above it.
local m, g, count, side = 1, 9.81, 5, 0.8                          -- kg, m/s^2, boxes, m

scenario {
  title = "What a stack hands down",
  description = "Five equal boxes rest on each other: the contact below the n-th from the top carries n m g.",
  duration = 4, gravity = {0, -g}, view = { center = {0, 1.75}, height = 5.6 }, layers = { "bodies", "labels" },
  force_scale = 0.03, golden = { frames = {30, 310, 629, 989}, size = {640, 360} },
}

local floor = ground { y = 0 }
local boxes = {}
for i = 1, count do                                                -- from the top down
  boxes[i] = body { name = ("box %d"):format(i), at = {0, (count - i + 0.5) * side}, mass = m, shape = box { width = 1.4, height = side } }
  label { body = boxes[i], text = ("%d"):format(i) }
end

-- N with which box i is held up from below.
local function carried(i)
  local below, sum = boxes[i + 1] or floor, 0
  for _, c in ipairs(contacts(boxes[i])) do
    if c.other == below then sum = sum + c.impulse * 240 end
  end
  return sum
end

layers { at = 1, "bodies", "mass" }
layers { at = 2, "bodies", "forces" }
section { at = 0, name = "A stack" }
section { at = 1, name = "Masses" }
section { at = 2, name = "Forces" }
freeze { at = 0.5, seconds = 1.5 }
freeze { at = 1.5, seconds = 2 }
freeze { at = 2.5, seconds = 4 }
freeze { at = 3.5, seconds = 5 }
caption { text = "Five equal boxes at rest", from = 0, to = 1 }
caption { text = "Each weighs $m g$ = 9.81 N", from = 1, to = 2 }
caption { text = "The contact below the $n$-th box carries all that lies above it: $n m g$", from = 2, to = 3 }
caption { text = "From 9.81 N at the top to 49.05 N on the ground, half of it at each corner", from = 3 }

for i = 1, count do
  local name = ("below box %d"):format(i)
  measure(name, function() return carried(i) end)
  reference(name, { {1, i * m * g}, {2, i * m * g}, {4, i * m * g} })
  expect(name .. (" the contact carries %d m g"):format(i), function() return math.abs(carried(i) - i * m * g) < 1e-6 end, { at = 2 })
end
expect("the stack rests", function()
  for _, box in ipairs(boxes) do if box:velocity().x ^ 2 + box:velocity().y ^ 2 > 1e-12 then return false end end
  return true
end)
