-- A rope of nineteen links of half a square metre, the first held, and a block of nine hundred as the twentieth.
scenario {
  title = "A light rope and a heavy block",
  description = "1800:1 at a rope's end: solvers that sweep joint by joint stretch it by metres.",
  duration = 5, rate = 60, fps = 60, gravity = {0, -10}, method = { substeps = 4 }, effects = "auto",
  view = { center = {10, -12}, height = 84 }, layers = { "bodies", "joints" },
  golden = { frames = { 0, 299 }, size = {480, 270} },
}
include "include/gates.lua"

local links, size = 19, 30
local bodies, joints, last = {}, {}, world
for i = 0, links - 1 do
  local link = body { name = "link " .. i, type = i == 0 and "static" or "dynamic", at = { i, 10 },
                      shape = box { width = 1, height = 0.5 }, group = -1 }
  if i > 0 then
    joints[i] = revolute { last, link, at = { i - 0.5, 10 } }
    bodies[i] = link
  end
  last = link
end
-- The block hangs by the middle of its left side, as in AVBD's demo (where this joint starts half a metre open).
local block = body { name = "block", at = { links - 0.5 + size / 2, 10 }, group = -1,
                     shape = box { width = size, height = size } }
joints[links] = revolute { last, block, at = { links - 0.5, 10 } }
bodies[links] = block

no_gap(joints, 0.5, 0)
no_energy_gained(bodies, links + size)
local function stretch()   -- of the straight line from the rope's hook to its end
  local p, a = block:position(), block:angle()
  local x, y = p.x - size / 2 * math.cos(a), p.y - size / 2 * math.sin(a)
  return math.sqrt((x - 0.5) ^ 2 + (y - 10) ^ 2) - (links - 1)
end
measure("stretch", stretch)
expect("the rope holds: it is never longer than it is, to one percent", function()
  return stretch() < 0.01 * (links - 1)
end, { always = true })
expect("quality: nor to a hundredth of a link's thickness", function() return stretch() < 0.005 end, { always = true })
-- Nothing brakes: what falls must keep what it has (the block has 450 kJ to turn over).
local first = energy().total
measure("energy lost", function() return first - energy().total end)
expect("quality: the joints bleed no energy, to one percent of what the fall turns over", function()
  return math.abs(energy().total - first) < 0.01 * block:mass() * 10 * (links + size)
end, { always = true })
