-- A net of 2500 balls, each pinned to the middle of the one above and of the one to its left.
local side = 50

scenario {
  title = "A net of 2500 balls",
  description = "4900 pins in loops of four; Rapier asserts for 8000 steps that it does not explode (360 here).",
  duration = 6, rate = 60, fps = 60, gravity = {0, -10}, method = { substeps = 4 }, effects = "auto",
  view = { center = { (side - 1) / 2, -25 }, height = 58 }, layers = { "bodies" },
  golden = { frames = { 359 }, size = {480, 270} },
}
include "include/gates.lua"

local radius = 0.3
local balls, joints, net = {}, {}, {}
for i = 0, side - 1 do
  net[i] = {}
  for k = 0, side - 1 do   -- column k, row i from above; every fourth of the upper row is held
    local held = i == 0 and (k % 4 == 0 or k == side - 1)
    local ball = body { name = ("ball %d.%d"):format(i, k), type = held and "static" or "dynamic", at = { k, -i },
                        shape = circle { radius = radius }, group = -1 }
    net[i][k] = ball
    if not held then balls[#balls + 1] = ball end
    if i > 0 then joints[#joints + 1] = revolute { net[i - 1][k], ball, at = { k, -i + 1 } } end
    if k > 0 and not (held and k == side - 1 and (k - 1) % 4 == 0) then
      joints[#joints + 1] = revolute { net[i][k - 1], ball, at = { k - 1, -i } }
    end
  end
end

local function is_due() return math.abs(time() * 4 - math.floor(time() * 4 + 0.5)) < 1e-6 end
local function fastest()
  local v = 0
  for _, b in ipairs(balls) do v = math.max(v, math.abs(b:velocity().x), math.abs(b:velocity().y)) end
  return v
end
local function farthest()
  local most = 0
  for _, b in ipairs(balls) do most = math.max(most, math.abs(b:position().x), math.abs(b:position().y)) end
  return most
end
local function widest()
  local most = 0
  for _, j in ipairs(joints) do most = math.max(most, j:gap()) end
  return most
end
measure("fastest", function() return is_due() and fastest() or 0 end)
measure("gap", function() return is_due() and widest() or 0 end)
local first = energy().total
measure("energy gained", function() return is_due() and energy().total - first or 0 end)
expect("nothing is faster than 100 m/s", function() return not is_due() or fastest() < 100 end, { always = true })
expect("nothing is farther away than 500 m", function() return not is_due() or farthest() < 500 end, { always = true })
expect("energy does not grow", function()
  return not is_due() or energy().total - first < 1e-3 * #balls * balls[1]:mass() * 10 * side
end, { always = true })
expect("the net hangs together: no pin is open by half a metre", function() return widest() < 0.5 end)
expect("quality: no pin is open by a hundredth of a ball", function() return widest() < 0.02 * radius end)
