-- A hundred boxes at one and the same point: no direction is better than another to part them.
scenario {
  title = "A hundred boxes at one point",
  description = "Identical shapes in identical places have no normal; they must part in peace, not explode or stay.",
  duration = 8, rate = 60, fps = 60, gravity = {0, -10}, method = { substeps = 4 }, effects = "auto",
  view = { center = {0, 8}, height = 20 }, layers = { "bodies" },
}
include "include/gates.lua"

ground { y = 0, friction = 0.5 }
local boxes, side, count = {}, 1, 100
for i = 1, count do
  boxes[i] = body { name = "box " .. i, at = { 0, 0.5 * side }, shape = box { width = side, height = side },
                    friction = 0.5 }
end

no_overlap(side, 6)
local function fastest()
  local v = 0
  for _, b in ipairs(boxes) do v = math.max(v, math.sqrt(b:velocity().x ^ 2 + b:velocity().y ^ 2)) end
  return v
end
local function widest()
  local x = 0
  for _, b in ipairs(boxes) do x = math.max(x, math.abs(b:position().x)) end
  return x
end
local function lowest()
  local y = 100
  for _, b in ipairs(boxes) do y = math.min(y, b:position().y) end
  return y
end
measure("fastest", fastest)
measure("widest", widest)
measure("lowest", lowest)
-- Apart they are, in the worst case, a row of a hundred boxes or a column: fifty metres to a side, and a fall of a
-- hundred. Anything faster or farther was thrown.
expect("nothing is thrown", function() return fastest() < math.sqrt(2 * 10 * count * side) end, { always = true })
expect("nothing flies away", function() return widest() < count * side / 2 end, { always = true })
expect("nothing goes through the floor", function() return lowest() > 0 end, { always = true })
expect("the boxes part", function()
  for _, c in ipairs(contacts()) do if c.separation < -0.1 * side then return false end end
  return true
end)
-- Solver2D holds overlaps to a push of 3 m/s; a tower of boxes that was pushed out may fall as well.
expect("quality: nothing is pushed faster than 10 m/s", function() return fastest() < 10 end, { always = true })
expect("quality: it comes to rest", function() return fastest() < 0.1 end)
