-- 5050 boxes, a hundred rows: whatever a step leaves unsolved, the hundredth row shows.
local rows, side = 100, 0.8

scenario {
  title = "Pyramid of a hundred rows",
  description = "5050 boxes at rest for 300 steps: a solver that leaves errors behind lets the top drift by metres.",
  duration = 5, rate = 60, fps = 60, gravity = {0, -10}, method = { substeps = 4 }, effects = "auto",
  view = { center = {0, 38}, height = 92 }, layers = { "bodies" },
  golden = { frames = { 299 }, size = {480, 270} },
}
include "include/gates.lua"

ground { y = 0, friction = 0.6 }
local boxes, top = {}, nil
for row = 1, rows do
  local n = rows - row + 1
  for i = 1, n do
    local x = (i - (n + 1) / 2) * side * 1.125
    top = body { name = ("row %d, box %d"):format(row, i), at = { x, (row - 0.5) * side },
                 shape = box { width = side, height = side }, friction = 0.6 }
    boxes[#boxes + 1] = top
  end
end

no_overlap(side, 4)
no_energy_gained(boxes, rows * side)
local function drift()
  local p = top:position()
  return math.sqrt(p.x ^ 2 + (p.y - (rows - 0.5) * side) ^ 2)
end
measure("drift of the top", drift)
expect("the pyramid stands: its top moves by less than 2 percent of its height", function()
  return drift() < 0.02 * rows * side
end, { always = true })
expect("quality: the top moves by less than a metre", function() return drift() < 1 end, { always = true })
expect("quality: the top moves by less than half a box", function() return drift() < side / 2 end, { always = true })
