-- How far four bricks reach over an edge, bracketed: by 25/24 of their length in the harmonic stack, where every brick
-- hangs over by 1/2, 1/4, 1/6 and 1/8 (M. Paterson and U. Zwick 2009 have its history). A threshold has no order in h.
scenario {
  title = "The harmonic stack, bracketed", duration = 4, rate = 240,
  view = { center = {-0.1, 0.1}, height = 6.9 }, layers = { "bodies", "labels" },
  description = "Stacks that reach a little less or more than they may: the upper four stand, the others fall.",
  golden = { frames = { 0, 120, 239 }, size = {480, 270} },
}

local count, high, critical, stacks = 4, 0.2, 0, {}
for k = 1, count do critical = critical + 1 / (2 * k) end
-- The upper edge of the table ends at `corner`.
local function stack(times, corner, group)
  local lane = 1 << group
  body { name = ("table %+.1f %%"):format(100 * (times - 1)), type = "static", friction = 0.6,
         category = lane, mask = lane, at = corner, shape = box { width = 1.2, height = 0.3, at = {-0.6, -0.15} } }
  local edge, top = 0, nil
  for k = count, 1, -1 do
    edge = edge + times / (2 * k)
    top = body { name = ("brick %d at %+.1f %%"):format(k, 100 * (times - 1)), friction = 0.6, category = lane,
                 mask = lane, at = { corner[1] + edge - 0.5, corner[2] + (count - k + 0.5) * high },
                 shape = box { width = 1, height = high } }
  end
  local start = top:position().y
  label { body = top, text = ("%+.1f %%"):format(100 * (times - 1)) }
  return { reach = times * critical, sunk = function() return start - top:position().y end }
end
for i, off in ipairs { -0.1, -0.03, -0.01, -0.003, 0.003, 0.01, 0.03, 0.1 } do
  local column, row = (i - 1) % 4, (i - 1) // 4
  stacks[i] = stack(1 + off, { 2.8 * column - 4.6, 1.7 - 2.8 * row }, i)
end

for _, y in ipairs { 0.4, -2.4 } do                                -- for what falls
  body { name = "floor", type = "static", category = 0xffff, mask = 0xffff, at = {0, y},
         shape = box { width = 11.2, height = 0.1 } }
end

local function bracketed()
  local stood, fell = 0, 2 * critical
  for _, s in ipairs(stacks) do
    if s.sunk() < 0.01 then stood = math.max(stood, s.reach) else fell = math.min(fell, s.reach) end
  end
  return (stood + fell) / 2
end
measure("largest overhang by brick lengths", bracketed)
reference("largest overhang by brick lengths", { { 4, critical } })
measure("sinking at -0.3 %", stacks[4].sunk)
reference("sinking at -0.3 %", function() return 0 end)
expect("the closed form is 1.04166666667", function() return math.abs(critical - 1.041666666666667) <= 1e-12 end)
expect("those and only those stand that reach less far", function()
  for i, s in ipairs(stacks) do if (s.sunk() < 0.01) ~= (i <= 4) then return false end end
  return true
end)
