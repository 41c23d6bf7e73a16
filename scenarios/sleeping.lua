-- Three piles fall asleep one after the other; then a stone wakes one of them.
scenario {
  title = "Let sleeping piles lie",
  description = "What rests is not stepped until something touches it: a late stone wakes one pile and leaves the other two asleep.",
  duration = 9, view = { center = {0.2, 2.85}, height = 7.6 },
  layers = { "bodies" },
  golden = { frames = { 0, 60, 299, 340, 479 } },
}

ground { y = 0 }
local side = 0.7
local function heap(x, rows, drop)
  local boxes = {}
  for row = 1, rows do
    for i = 1, rows - row + 1 do
      local box = body { name = ("box %d of heap at %g"):format(#boxes + 1, x), friction = 0.6, shape = box { width = side, height = side },
                         at = { x + (i - (rows - row + 2) / 2) * (side + 0.06), drop + (row - 0.5) * side } }
      boxes[#boxes + 1] = box
    end
  end
  return boxes
end
local low, middle, high = heap(-4, 2, 0), heap(0, 3, 0.5), heap(4, 4, 0.9)

local slept, asleep_at = 0, {}
for name, boxes in pairs { low = low, middle = middle, high = high } do
  for _, b in ipairs(boxes) do
    on_sleep(b, function()
      slept = slept + 1
      asleep_at[name] = asleep_at[name] or time()
    end)
  end
end
local function all_asleep(boxes)
  for _, b in ipairs(boxes) do if not b:asleep() then return false end end
  return true
end
local function sleepers()
  local n = 0
  for _, boxes in ipairs { low, middle, high } do
    for _, b in ipairs(boxes) do if b:asleep() then n = n + 1 end end
  end
  return n
end

local stone, hit_at
at(5, function()
  stone = body { name = "stone", at = {-2, 3.4}, velocity = {3, 0}, spin = -2, shape = regular { sides = 5, radius = 0.35 }, density = 2, friction = 0.8 }
  on_contact(stone, nil, function() hit_at = hit_at or time() end)
end)

measure("sleepers", sleepers)
expect("the heaps fall asleep one after the other", function()
  return asleep_at.low < asleep_at.middle and asleep_at.middle < asleep_at.high
end, { at = 5 })
expect("when the stone comes all of them sleep", function() return sleepers() == 19 and slept >= 19 end, { at = 5 })
expect("the stone wakes the heap it hits", function() return hit_at ~= nil and sleepers() == 13 end, { at = 6 })
expect("the other two sleep on", function() return time() < 5 or (all_asleep(low) and all_asleep(high)) end, { always = true })
expect("in the end all sleep again, the stone too", function() return sleepers() == 19 and stone:asleep() end)

caption { text = "What has lain still for half a second falls asleep", from = 0, to = 4.5 }
caption { text = "Only the heap that is hit wakes", from = 5, to = 9 }
plot { title = "Boxes asleep", seconds = 9, at = "top_right", y = { asleep = sleepers } }
