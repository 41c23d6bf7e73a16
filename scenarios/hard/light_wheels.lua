-- Ninety kilograms on wheels of 0.28 kg, axles without springs: the whole load goes through what weighs almost nothing.
scenario {
  title = "A heavy car on light wheels",
  description = "320:1 at rest and under way: the wheels must neither sink into the road nor come off their axles.",
  duration = 5, rate = 60, fps = 60, gravity = {0, -10}, method = { substeps = 4 }, effects = "auto",
  view = { center = {2.6, 1.2}, height = 6 }, layers = { "bodies", "joints", "contacts" },
  golden = { frames = { 299 }, size = {480, 270} },
}
include "include/gates.lua"

ground { y = 0, friction = 0.9 }
local radius, mass = 0.3, 90
local car = body { name = "car", at = {0, 0.65}, mass = mass, shape = box { width = 2.4, height = 0.5 }, group = -1 }
local wheels, axles = {}, {}
for i, x in ipairs { -0.8, 0.8 } do
  wheels[i] = body { name = "wheel " .. i, at = { x, radius }, shape = circle { radius = radius }, friction = 0.9,
                     group = -1 }
  axles[i] = revolute { car, wheels[i], at = { x, radius } }
end

-- From 2 s on each wheel is turned by 20 N m for two seconds: a = 2 T / (r (M + 2 m + 2 I / r^2)), rolling without slip
-- (each wheel presses 450 N and needs 67 N of friction). A disc has I = m r^2 / 2.
local torque, m = 20, wheels[1]:mass()
every(1 / 60, function()
  if time() >= 2 and time() < 4 - 1e-9 then
    for _, w in ipairs(wheels) do w:torque(-torque) end
    car:torque(2 * torque)   -- the motors sit in the car
  end
end)
local speed = 2 * 2 * torque / (radius * (mass + 3 * m))

no_overlap(radius, 0.5)
no_gap(axles, radius, 0)
no_energy_gained({ car, wheels[1], wheels[2] }, 1)
local function sink() return radius - math.min(wheels[1]:position().y, wheels[2]:position().y) end
measure("sink", sink)
measure("speed", function() return car:velocity().x end)
reference("speed", { { 2, 0 }, { 4, speed }, { 5, speed } })
expect("the car stays on its wheels", function()
  return sink() < 0.1 * radius and math.abs(car:angle()) < 0.1
end, { always = true })
expect("at rest the car does not creep", function() return math.abs(car:position().x) < 1e-3 end, { at = 2 })
expect("the car drives as fast as its torque takes it", function()
  return math.abs(car:velocity().x / speed - 1) < 0.02
end, { at = 4 })
expect("the car rolls on", function() return math.abs(car:velocity().x / speed - 1) < 0.02 end)
expect("quality: the axles turn as the road passes", function()
  return math.abs(wheels[1]:spin() * radius + car:velocity().x) < 0.01 * speed
end)
