-- Left or right, row after row: the slots fill to a bell.
scenario {
  title = "Galton board", duration = 16, seed = 5, view = { center = {0, 4.15}, height = 9.8 },
  description = "Balls fall one by one through rows of pegs; the slots below collect a bell-shaped heap.",
  golden = { frames = { 0, 240, 600, 959 } }, layers = { "bodies" },
}

local rows, columns, pitch, drop, top = 11, 15, 0.5, 0.44, 8
local half = columns * pitch / 2
ground { y = 0 }
for row = 1, rows do
  local odd = row % 2
  for i = 1, columns - odd do
    body { name = ("peg %d.%d"):format(row, i), type = "static", at = { (i - (columns - odd + 1) / 2) * pitch, top - row * drop },
           restitution = 0.25, friction = 0.1, shape = circle { radius = 0.08 } }
  end
end
for i = 0, columns do
  local height = (i == 0 or i == columns) and 8.4 or 2.7
  body { name = "divider " .. i, type = "static", at = { i * pitch - half, height / 2 }, shape = box { width = 0.05, height = height }, friction = 0.1 }
end

local balls = {}
every(0.11, function()
  if #balls >= 90 then return end
  balls[#balls + 1] = body { name = "ball " .. #balls + 1, at = { (math.random() - 0.5) * 0.02, 8.3 }, restitution = 0.25, friction = 0.05,
                             shape = circle { radius = 0.11 }, density = 5 }
end)

local function moments()
  local sum, squares = 0, 0
  for _, b in ipairs(balls) do
    local slot = b:position().x / pitch
    sum, squares = sum + slot, squares + slot^2
  end
  local mean = sum / #balls
  return mean, math.sqrt(squares / #balls - mean^2)
end
measure("mean slot", function() return #balls > 0 and moments() or 0 end)
expect("every ball has come down", function()
  for _, b in ipairs(balls) do if b:position().y > 3.2 then return false end end
  return #balls == 90
end, { finally = true })
-- A mean of 90 throws strays by about a tenth of the width of the heap.
expect("the heap is centred", function()
  local mean, width = moments()
  return math.abs(mean) < 0.3 * width
end, { finally = true })
expect("its width is that of a chain of random choices, one a row", function()
  local _, width = moments()
  return width > 0.5 * math.sqrt(rows) / 2 and width < 2 * math.sqrt(rows) / 2
end, { finally = true })
