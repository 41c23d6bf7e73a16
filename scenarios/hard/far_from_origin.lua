-- One and the same stack, at home and ten thousand kilometres away.
scenario {
  title = "A stack, and the same ten thousand km away",
  description = "At x = 1e7 m a double still tells two nanometres apart, a float one metre: both must do the same.",
  duration = 6, rate = 60, fps = 60, gravity = {0, -10}, method = { substeps = 4 }, effects = "auto",
  view = { center = {0, 5}, height = 12.5 }, layers = { "bodies", "contacts" },
  golden = { frames = { 359 }, size = {480, 270} },
}
include "include/gates.lua"

local rows, homes = 10, { 0, 1e7 }
local stacks, all = {}, {}
for s, home in ipairs(homes) do
  body { name = "ground", type = "static", at = { home, -0.5 }, shape = box { width = 20, height = 1 }, friction = 0.6 }
  stacks[s] = {}
  for i = 1, rows do   -- dropped by a millimetre each, a centimetre to alternate sides
    local x = home + (i % 2 == 0 and 0.01 or -0.01)
    local b = body { name = ("box %d.%d"):format(s, i), at = { x, (i - 0.5) + 0.001 * i },
                     shape = box { width = 1, height = 1 }, friction = 0.6 }
    stacks[s][i], all[#all + 1] = b, b
  end
end

no_overlap(1, 2)
no_energy_gained(all, rows)
local function difference()
  local most = 0
  for i = 1, rows do
    local p, q = stacks[1][i]:position(), stacks[2][i]:position()
    most = math.max(most, math.abs(p.x - (q.x - homes[2])), math.abs(p.y - q.y))
  end
  return most
end
local function lean(s)
  local most = 0
  for _, b in ipairs(stacks[s]) do most = math.max(most, math.abs(b:position().x - homes[s])) end
  return most
end
measure("difference", difference)
measure("lean at home", function() return lean(1) end)
measure("lean far away", function() return lean(2) end)
expect("both stacks stand", function()
  return lean(1) < 0.1 and lean(2) < 0.1 and stacks[2][rows]:position().y > 9.4
end, { always = true })
expect("both do the same, to a millimetre", function() return difference() < 1e-3 end, { always = true })
