-- What sleeps must not change by a bit; what is nudged must wake in the very next step, and all that lies on it.
scenario {
  title = "Asleep, then nudged", duration = 8, rate = 60, fps = 60, gravity = {0, -10}, method = { substeps = 4 },
  description = "Six boxes sleep without changing by a bit until the lowest is nudged: then all wake at once.",
  view = { center = {0, 2.7}, height = 6.6 }, layers = { "bodies" },
  golden = { frames = { 299, 479 }, size = {480, 270} },
}
include "include/gates.lua"

ground { y = 0 }
local boxes, slept_at, kept = {}, {}, {}
for i = 1, 6 do
  local b = body { name = "box " .. i, at = {0.02 * (i % 2), i - 0.5}, friction = 0.5,
                   shape = box { width = 1, height = 1 } }
  boxes[i] = b
  on_sleep(b, function()
    local p, v = b:position(), b:velocity()
    slept_at[i], kept[i] = slept_at[i] or time(), { p.x, p.y, b:angle(), v.x, v.y, b:spin() }
  end)
end
local function sleepers()
  local n = 0
  for _, b in ipairs(boxes) do if b:asleep() then n = n + 1 end end
  return n
end
local nudge = 5
at(nudge, function() boxes[1]:impulse({0.5, 0}) end)
measure("sleepers", sleepers)
expect("all sleep within two seconds", function() return sleepers() == 6 end, { at = 2 })
expect("asleep, nothing changes by a single bit", function()
  if time() < 2 or time() > nudge then return true end
  for i, b in ipairs(boxes) do
    local p, v, k = b:position(), b:velocity(), kept[i]
    if not k or p.x ~= k[1] or p.y ~= k[2] or b:angle() ~= k[3] or v.x ~= k[4] or v.y ~= k[5] or b:spin() ~= k[6] then
      return false
    end
  end
  return sleepers() == 6
end, { always = true })
expect("one step after the nudge nobody sleeps", function() return sleepers() == 0 end, { at = nudge + 1 / 60 })
expect("and the lowest has moved", function()
  return kept[1] ~= nil and boxes[1]:position().x ~= kept[1][1]
end, { at = nudge + 1 / 60 })
expect("in the end all stand and sleep again", function() return sleepers() == 6 and boxes[6]:position().y >= 5.4 end)
no_overlap(1, 1)
no_energy_gained(boxes, 6)
