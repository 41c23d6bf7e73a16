scenario {
  title = "Bricks over the edge, just standing", duration = 6,
  rate = 60, fps = 60, gravity = {0, -10}, method = { substeps = 4 },
  description = "Four bricks reach further than one of their lengths over the edge, 1 percent less than they may.",
  view = { center = {-0.1, 0.15}, height = 1.9 }, layers = { "bodies", "contacts" },
  golden = { frames = { 359 }, size = {480, 270} },
}
include "include/gates.lua"
include "include/overhang.lua"

local bricks, sunk = overhanging(0.99)
expect("it stands: the top sinks by less than a hundredth of a brick's length", function() return sunk() <= 0.01 end,
       { always = true })
expect("quality: in the end nothing moves faster than 1 mm/s", function()
  for _, b in ipairs(bricks) do
    local v = b:velocity()
    if math.sqrt(v.x^2 + v.y^2) > 1e-3 then return false end
  end
  return true
end)
no_overlap(0.2, 0.5)
