-- A fast disc strikes discs that lie before a thin wall: what was slow at the step's beginning is not slow at its end.
scenario {
  title = "Struck into a thin wall",
  description = "At 30 steps a second a blow sends a resting disc at a thin wall; sweeping only fast bodies loses it.",
  duration = 1, rate = 30, fps = 30, gravity = {0, 0}, method = { substeps = 4 }, effects = "auto",
  view = { center = {-1.2, 0}, height = 5.4 }, layers = { "bodies", "contacts" },
  golden = { frames = { 29 }, size = {480, 270} },
}
include "include/gates.lua"

local radius, thin = 0.1, 0.02
body { name = "wall", type = "static", at = { thin / 2, 0 }, shape = box { width = thin, height = 5 } }
local discs = {}
-- In three lanes one, two and three discs rest before the wall; the last all but touches it, the first is struck.
for lane = 1, 3 do
  local y = (lane - 2) * 1.6
  for i = 1, lane do
    local x = -radius - (i - 1) * 2.5 * radius - (lane == 1 and 0.05 or 0)
    discs[#discs + 1] = body { name = ("resting %d.%d"):format(lane, i), at = { x, y },
                               shape = circle { radius = radius } }
  end
  -- Ten metres a step for the first, and each lane's striker heavier than what it strikes.
  discs[#discs + 1] = body { name = "striker " .. lane, at = { -4, y }, velocity = { 100 * lane, 0 }, bullet = true,
                             shape = circle { radius = 2 * radius }, density = 4 }
end

no_energy_gained(discs, 1)
local function foremost()
  local x = -100
  for _, d in ipairs(discs) do x = math.max(x, d:position().x) end
  return x
end
measure("foremost", foremost)
expect("nothing gets through the wall", function() return foremost() < 0 end, { always = true })
expect("nothing ends up inside the wall", function() return foremost() < -0.8 * radius end)
