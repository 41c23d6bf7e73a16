-- Three slider-cranks turned by motors: closed loops that all but fold up twice a turn.
scenario {
  title = "Three driven slider-cranks",
  description = "Rods of 3, 1.5 and 1.04 cranks at 10 rad/s: the shorter, the harder the jerk; loops must stay closed.",
  duration = 6, rate = 60, fps = 60, gravity = {0, -10}, method = { substeps = 4 }, effects = "auto",
  view = { center = {0.7, 0}, height = 4.4 }, layers = { "bodies", "joints" },
  golden = { frames = { 359 }, size = {480, 270} },
}
include "include/gates.lua"

local r, omega = 0.5, 10
local joints, cranks = {}, {}
for i, l in ipairs { 1.5, 0.75, 0.52 } do
  local y = (2 - i) * 1.4
  local crank = body { name = "crank " .. i, at = { r / 2, y },
                       shape = capsule { a = {-r / 2, 0}, b = {r / 2, 0}, radius = 0.06 }, group = -1,
                       spin = omega, velocity = { 0, omega * r / 2 } }
  -- All begin at their outer dead centre, already turning: the rod turns by -r / l as fast.
  local rod = body { name = "rod " .. i, at = { r + l / 2, y },
                     shape = capsule { a = {-l / 2, 0}, b = {l / 2, 0}, radius = 0.04 }, group = -1,
                     spin = -omega * r / l, velocity = { 0, omega * r / 2 } }
  local piston = body { name = "piston " .. i, at = { r + l, y }, shape = box { width = 0.3, height = 0.3 },
                        group = -1 }
  joints[#joints + 1] = revolute { world, crank, at = { 0, y }, motor = { speed = omega, max_torque = 1e4 } }
  joints[#joints + 1] = revolute { crank, rod, at = { r, y } }
  joints[#joints + 1] = revolute { rod, piston, at = { r + l, y } }
  joints[#joints + 1] = prismatic { world, piston, at = { r + l, y }, axis = {1, 0} }
  cranks[i] = { crank = crank, rod = rod, piston = piston, l = l, y = y }

  -- Where the crank is at time t, a piston is at r cos + sqrt(l^2 - r^2 sin^2).
  local name = ("piston, l = %.2f"):format(l)
  measure(name, function() return piston:position().x end)
  reference(name, function(t) return r * math.cos(omega * t) + math.sqrt(l ^ 2 - (r * math.sin(omega * t)) ^ 2) end)
  local function off()   -- from where its own crank puts it
    local a = crank:angle()
    return piston:position().x - (r * math.cos(a) + math.sqrt(l ^ 2 - (r * math.sin(a)) ^ 2))
  end
  measure(("loop error, l = %.2f"):format(l), off)
  expect(("l = %.2f: the piston is where its crank puts it, to a millimetre"):format(l), function()
    return math.abs(off()) < 1e-3
  end, { always = true })
  expect(("l = %.2f: the crank keeps its speed to one percent"):format(l), function()
    return math.abs(crank:spin() / omega - 1) < 0.01
  end, { always = true })
end

no_gap(joints, 0.08, 0)
expect("after a second the first piston is at 1.0556 m", function()
  return math.abs(cranks[1].piston:position().x - 1.05559482552) < 1e-3
end, { at = 1 })
local function late()
  local most = 0
  for _, c in ipairs(cranks) do most = math.max(most, math.abs(c.crank:angle() - omega * time())) end
  return most
end
measure("late (rad)", late)
expect("all keep time with their motors: to a tenth of a radian in sixty", function() return late() < 0.1 end)
expect("quality: to a hundredth of a radian", function() return late() < 0.01 end)
