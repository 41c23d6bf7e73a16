-- 17 m in a tick, 4 m in a substep, against a hundredth of a metre: twelve discs that start at other distances, so that
-- none is stopped by the luck of being looked at just inside the wall.
scenario {
  title = "One kilometre per second", duration = 1, rate = 60, fps = 60, gravity = {0, 0}, method = { substeps = 4 },
  description = "Discs of 10 cm fly at a wall of 1 cm at 1 km/s: without continuous collision most pass it unseen.",
  view = { center = {-3, 0}, height = 5.4 }, layers = { "bodies" },
  golden = { frames = { 0, 59 }, size = {480, 270} },
}
include "include/gates.lua"

local speed, radius, thick = 1000, 0.05, 0.01
body { name = "wall", type = "static", shape = box { width = thick, height = 5 } }
local discs = {}
for i = 1, 12 do
  -- from 2 m away to 6.2 m: more than what is travelled in a substep
  discs[i] = body { name = "disc " .. i, at = { -2 - 4.2 * (i - 1) / 11, (i - 6.5) * 0.4 }, velocity = {speed, 0},
                    shape = circle { radius = radius } }
end
local function farthest()
  local most = -math.huge
  for _, d in ipairs(discs) do most = math.max(most, d:position().x) end
  return most
end
measure("farthest", farthest)
expect("no disc ever passes the wall", function() return farthest() < 0 end, { always = true })
expect("none sinks into it by more than half its thickness", function() return farthest() <= -radius end,
       { always = true })
expect("all have arrived and rest against it or have come back", function()
  for _, d in ipairs(discs) do if d:velocity().x > 1e-6 or d:position().x < -100 then return false end end
  return true
end)
no_energy_gained(discs, 50000)                             -- 1 km/s is a fall from 50 km
no_overlap(thick, 0.5)
