-- A ground two thousand kilometres wide under boxes of one metre.
scenario {
  title = "A very wide ground",
  description = "Three boxes on a ground of 1e6 m half width: edges that long eat the digits a contact needs.",
  duration = 5, rate = 60, fps = 60, gravity = {0, -10}, method = { substeps = 4 }, effects = "auto",
  view = { center = {0, 1.4}, height = 4.4 }, layers = { "bodies", "contacts" },
  golden = { frames = { 299 }, size = {480, 270} },
}
include "include/gates.lua"

body { name = "ground", type = "static", at = {0, -2}, shape = box { width = 2e6, height = 4 } }
local boxes, xs = {}, { -2.3, 0, 2.3 }
for i, x in ipairs(xs) do
  boxes[i] = body { name = "box " .. i, at = { x, 0.5 + 0.5 * i }, shape = box { width = 1, height = 1 } }
end

no_overlap(1, 2)
no_energy_gained(boxes, 2)
local function off()   -- from where it must lie
  local most = 0
  for i, b in ipairs(boxes) do
    most = math.max(most, math.abs(b:position().y - 0.5), math.abs(b:position().x - xs[i]))
  end
  return most
end
local function fastest()
  local v = 0
  for _, b in ipairs(boxes) do v = math.max(v, math.abs(b:velocity().x) + math.abs(b:velocity().y)) end
  return v
end
measure("off", off)
measure("fastest", fastest)
expect("the boxes lie on the ground, to 0.1 m", function() return off() < 0.1 end)
expect("they lie still", function() return fastest() < 0.1 end)
expect("quality: they lie where they fell, to a millimetre", function() return off() < 1e-3 end)
