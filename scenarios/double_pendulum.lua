-- Three double pendulums, a ten-thousandth of a degree apart: the same at first, strangers soon after.
scenario {
  title = "Sensitive to the start", duration = 14, rate = 960, view = { center = {1.7, 0}, height = 5 }, gravity = {0, -9.81},
  description = "Chaos: three double pendulums that start 0.0001 degrees apart.",
  golden = { frames = { 0, 120, 839 } }, layers = { "bodies", "joints", "trails" }, theme = "dark",
}

local tips = {}
for k, color in ipairs { 0x5aa9e6, 0xf2a541, 0x7bc47f } do
  local a1 = math.rad(120 + (k - 1) * 1e-4)
  local a2 = math.rad(150)
  local elbow = { math.sin(a1), -math.cos(a1) }
  local tip = { elbow[1] + math.sin(a2), elbow[2] - math.cos(a2) }
  local upper = body { name = "elbow " .. k, at = elbow, mass = 1, shape = circle { radius = 0.06 }, group = -1, color = color }
  local lower = body { name = "tip " .. k, at = tip, mass = 1, shape = circle { radius = 0.08 }, group = -1, color = color }
  distance { world, upper, from = {0, 0}, to = elbow, length = 1 }
  distance { upper, lower, from = elbow, to = tip, length = 1 }
  trail { body = lower, seconds = 1.5 }
  tips[k] = lower
end

local function apart()
  local p, q = tips[1]:position(), tips[3]:position()
  return math.sqrt((p.x - q.x)^2 + (p.y - q.y)^2)
end
measure("distance between the tips", apart)
local total = energy().total
expect("the energy is kept through it all", function() return math.abs(energy().total - total) < 0.02 end, { always = true })
expect("after two seconds they still go together", function() return apart() < 0.01 end, { at = 2 })
expect("in the end they have parted", function() return apart() > 0.1 end, { finally = true })
plot { title = "log10 of the distance (m)", seconds = 14, at = "bottom_right", y = {
  ["1 to 3"] = function() return math.log(math.max(apart(), 1e-9), 10) end,
} }
