-- Six boxes, each twice as wide as the one it stands on: 1024 times the mass on the smallest.
scenario {
  title = "Boxes that double",
  description = "Six boxes from 1 m to 32 m, the largest on top: 1364 times its own mass rests on the smallest.",
  duration = 10, rate = 60, fps = 60, gravity = {0, -10}, method = { substeps = 4 }, effects = "auto",
  view = { center = {0, 31}, height = 68 }, layers = { "bodies", "contacts" },
  golden = { frames = { 599 }, size = {480, 270} },
}
include "include/gates.lua"

ground { y = 0 }
local boxes, tops, y = {}, {}, 0
for i = 0, 5 do
  local side = 2 ^ i
  boxes[#boxes + 1] = body { name = ("%d m"):format(side), at = { 0, y + side / 2 },
                             shape = box { width = side, height = side } }
  tops[#tops + 1] = y + side / 2
  y = y + side
end

no_overlap(1, 1)
no_energy_gained(boxes, y)
local function lowered()
  local most = 0
  for i, b in ipairs(boxes) do most = math.max(most, math.abs(tops[i] - b:position().y)) end
  return most
end
local function leaning()
  local most = 0
  for _, b in ipairs(boxes) do most = math.max(most, math.abs(b:angle())) end
  return most
end
measure("lowered", lowered)
measure("leaning", leaning)
-- Level and centred it is at rest, and stable until the centre of what stands on the smallest box, 39 m above it, is
-- beyond its edge, half a metre off: 0.5 / 39 = 0.013 rad. What leans by more must fall.
expect("the tower stands", function() return lowered() < 0.5 and leaning() < 0.012 end, { always = true })
expect("quality: no box sinks by more than 5 percent of the smallest", function()
  return lowered() < 0.05
end, { always = true })
expect("quality: the tower does not lean", function() return leaning() < 1e-3 end, { always = true })
