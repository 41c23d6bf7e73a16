-- A disc rolls over thirty flat seams, slow and fast: each seam has a corner to trip over, if one looks at it alone.
scenario {
  title = "Rolling over flat seams",
  description = "Discs roll over ground boxes that lie flush: ghost corners brake them, lift them or throw them back.",
  duration = 5, rate = 60, fps = 60, gravity = {0, -10}, method = { substeps = 4 }, effects = "auto",
  view = { center = {15, 4}, height = 22 }, layers = { "bodies", "contacts" },
  golden = { frames = { 299 }, size = {480, 270} },
}
include "include/gates.lua"

local radius, discs, speeds = 0.4, {}, { 0.5, 2, 6 }
for i, v in ipairs(speeds) do
  local y = (i - 1) * 4
  for k = 0, 32 do
    body { name = ("piece %d.%d"):format(i, k), type = "static", at = { k - 0.5, y - 0.5 },
           shape = box { width = 1, height = 1 } }
  end
  discs[i] = body { name = ("%.1f m/s"):format(v), at = { 0, y + radius }, velocity = { v, 0 }, spin = -v / radius,
                    shape = circle { radius = radius } }
  measure(("way at %.1f m/s"):format(v), function() return discs[i]:position().x end)
  reference(("way at %.1f m/s"):format(v), function(t) return v * t end)
  -- Rolling without slip nothing brakes a disc on a level.
  expect(("at %.1f m/s it keeps its speed to one percent"):format(v), function()
    return math.abs(discs[i]:velocity().x / v - 1) < 0.01 and math.abs(discs[i]:spin() * radius / v + 1) < 0.01
  end, { always = true })
  expect(("at %.1f m/s it stays on the floor"):format(v), function()
    return math.abs(discs[i]:position().y - y - radius) < 0.005
  end, { always = true })
end

no_overlap(2 * radius, 0.25)
no_energy_gained(discs, 1)
