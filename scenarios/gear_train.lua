-- Three toothed wheels: a motor turns the small one, the others follow by their numbers of teeth.
scenario {
  title = "Gear train",
  description = "A motor on the first wheel turns three; their angles stay coupled to the last digits.",
  duration = 5, view = { center = {0.5, -0.75}, height = 5.2 }, gravity = {0, 0},
  layers = { "bodies", "joints", "labels" },
  golden = { frames = { 0, 60, 389 } },
}

-- A wheel of n teeth, one every 2 pi r / n; `phase` turns a gap to where the neighbour has a tooth.
local function wheel(name, at, teeth, phase, color)
  local r = teeth / 20
  local shapes = { circle { radius = r - 0.06 } }
  for i = 1, teeth do
    local turn = phase + 2 * math.pi * i / teeth
    local c, s = math.cos(turn), math.sin(turn)
    local function corner(out, side) return { (r + out) * c - side * s, (r + out) * s + side * c } end
    shapes[#shapes + 1] = hull { corner(-0.08, -0.1), corner(0.045, -0.045), corner(0.045, 0.045), corner(-0.08, 0.1) }
  end
  local b = body { name = name, at = at, shapes = shapes, density = 2, group = -1, color = color }
  label { body = b, text = ("%d teeth"):format(teeth) }
  return b
end

local small = wheel("small", { -0.55, 0 }, 10, 0, 0x9CCFBD)
local large = wheel("large", { 0.95, 0 }, 20, math.pi / 20, 0x78AEE0)
local last = wheel("last", { 2.65, 0 }, 14, 0, 0xE9B794)
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
freeze { at = 4.9, seconds = 1.5 }
caption { text = "The more teeth, the slower: 10 × 4 = 20 × 2 = 14 × 2.86 rad/s", at = "top" }
