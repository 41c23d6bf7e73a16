-- Three toothed wheels: a motor turns the small one, the others follow by their numbers of teeth.
scenario {
  title = "Gear train",
  description = "A motor on the first wheel turns three; their angles stay coupled to the last digits.",
  duration = 5, view = { center = {0.9, -0.35}, height = 4.2 }, gravity = {0, 0},
  layers = { "bodies", "joints" },
  golden = { frames = { 0, 60, 299 } },
}

-- A wheel of n teeth, one every 2 pi r / n; `phase` turns a gap to where the neighbour has a tooth.
local function wheel(name, at, teeth, phase)
  local r = teeth / 20
  local shapes = { circle { radius = r - 0.06 } }
  for i = 1, teeth do
    local turn = phase + 2 * math.pi * i / teeth
    shapes[#shapes + 1] = box { width = 0.13, height = 0.1, angle = turn, at = { (r - 0.02) * math.cos(turn), (r - 0.02) * math.sin(turn) } }
  end
  local b = body { name = name, at = at, shapes = shapes, density = 2, group = -1 }
  return b
end

local small = wheel("small", { -0.55, 0 }, 10, 0)
local large = wheel("large", { 0.95, 0 }, 20, math.pi / 20)
local last = wheel("last", { 2.65, 0 }, 14, 0)
local drive = revolute { world, small, at = small:position(), motor = { speed = 4, max_torque = 1.5 } }
local middle = revolute { world, large, at = large:position() }
local driven = revolute { world, last, at = last:position() }
gear { drive, middle, ratio = 20 / 10 }
gear { middle, driven, ratio = 14 / 20 }

measure("spin of the small wheel", function() return small:spin() end)
measure("spin of the last wheel", function() return last:spin() end)
expect("the wheels keep the ratio of their teeth", function()
  return math.abs(10 * small:angle() + 20 * large:angle()) < 1e-11 and math.abs(20 * large:angle() + 14 * last:angle()) < 1e-11
end, { always = true })
expect("the motor reaches its speed", function() return math.abs(small:spin() - 4) < 1e-4 end)
plot { title = "Spin (rad/s)", seconds = 5, at = "bottom_left", y = {
  small = function() return small:spin() end,
  large = function() return large:spin() end,
  last = function() return last:spin() end,
} }
