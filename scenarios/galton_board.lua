-- Left or right, twelve times: the slots fill to a bell.
scenario {
  title = "Galton board", duration = 16, seed = 5, view = { center = {0, 4.6}, height = 10.4 },
  description = "Balls fall through rows of pegs; the slots below collect the binomial distribution.",
  golden = { frames = { 0, 240, 600, 959 } }, layers = { "bodies" },
}

local rows, pitch, drop = 12, 0.56, 0.42
local top = 8.4
ground { y = 0 }
for row = 1, rows do
  for i = 1, row + 1 do
    body { name = "peg", type = "static", at = { (i - 1 - row / 2) * pitch, top - row * drop }, restitution = 0.35, friction = 0.1,
           shape = circle { radius = 0.07 } }
  end
end
local slots = rows + 3
for i = 0, slots do
  local x = (i - slots / 2) * pitch
  body { name = "divider", type = "static", at = { x, 1.45 }, shape = box { width = 0.05, height = 2.9 }, friction = 0.1 }
end
-- The funnel and the outer walls keep everything on the board.
for _, side in ipairs { -1, 1 } do
  body { name = "funnel", type = "static", shape = polygon { { side * 0.24, 8.5 }, { side * 2.2, 9.7 }, { side * 2.2, 9.8 }, { side * 0.24, 8.6 } }, friction = 0.05 }
  wall { a = { side * slots / 2 * pitch, 0 }, b = { side * slots / 2 * pitch, 9.6 } }
end

local balls = {}
every(0.08, function()
  if #balls >= 130 then return end
  balls[#balls + 1] = body { name = "ball", at = { (math.random() - 0.5) * 1.6, 9.6 + 0.2 * math.random() }, restitution = 0.3, friction = 0.05,
                             shape = circle { radius = 0.13 }, density = 5 }
end)
measure("mean slot", function()
  local sum, n = 0, 0
  for _, b in ipairs(balls) do
    local p = b:position()
    if p.y < 2.9 then sum, n = sum + p.x / pitch, n + 1 end
  end
  return n > 0 and sum / n or 0
end)
expect("every ball has found a slot", function()
  for _, b in ipairs(balls) do if b:position().y > 3.4 then return false end end
  return #balls == 130
end, { finally = true })
expect("the heap is centred", function()
  local sum = 0
  for _, b in ipairs(balls) do sum = sum + b:position().x / pitch end
  return math.abs(sum / #balls) < 0.6
end, { finally = true })
