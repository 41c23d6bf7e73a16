-- A box lands flat on the seam of two ground boxes, at 30 m/s: nothing about it points sideways.
scenario {
  title = "Landing flat on a seam",
  description = "At 30 m/s flat onto the joint of two ground boxes: it must not be kicked sideways or set spinning.",
  duration = 2, rate = 60, fps = 60, gravity = {0, -10}, method = { substeps = 4 }, effects = "auto",
  view = { center = {0, 1}, height = 4.5 }, layers = { "bodies", "contacts" },
  golden = { frames = { 119 }, size = {480, 270} },
}
include "include/gates.lua"

for _, side in ipairs { -1, 1 } do
  body { name = "ground", type = "static", at = { side * 2, -0.5 }, shape = box { width = 4, height = 1 } }
end
-- Off the seam's middle, so that the two halves carry unequal parts of the blow.
local start, from, height = 0.2, 30, 8
local block = body { name = "block", at = { start, height + 0.5 }, velocity = { 0, -from },
                     shape = box { width = 1, height = 1 } }

no_overlap(1, 1)
no_energy_gained({ block }, height + from ^ 2 / 20)   -- what 30 m/s are worth, too
measure("spin", function() return block:spin() end)
measure("sideways", function() return block:velocity().x end)
measure("height", function() return block:position().y - 0.5 end)
-- A thousandth of the blow.
expect("it is not kicked sideways", function() return math.abs(block:velocity().x) < 0.03 end, { always = true })
expect("it is not set spinning", function() return math.abs(block:spin()) < 0.03 end, { always = true })
expect("it does not go into the ground", function() return block:position().y > 0.5 - 0.1 end, { always = true })
expect("it does not bounce", function() return time() < 0.5 or block:position().y < 0.51 end, { always = true })
expect("it lies where it landed", function()
  local p = block:position()
  return math.abs(p.x - start) < 1e-3 and math.abs(block:angle()) < 1e-3 and math.abs(p.y - 0.5) < 0.01
end)
