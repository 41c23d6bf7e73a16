-- Parcels ride down three belts. Each is caught by friction, gains mu g, and then rides along without slip.
scenario {
  title = "Conveyor belts", duration = 17, view = { center = {3.0, 2.9}, height = 8.2 },
  description = "Surfaces that move: boxes and balls are taken along, and what the belts' motors do is booked as work.",
  layers = { "bodies" }, golden = { frames = { 0, 120, 400, 1019 } },
}

local speed, mu = 2, 0.5
-- A belt runs round its body counter-clockwise where its surface_speed is positive: then its upper side goes left.
local function belt(name, x, y, surface_speed)
  body { name = name, type = "static", at = {x, y}, friction = mu, surface_speed = surface_speed,
         shape = capsule { a = {-2.3, 0}, b = {2.3, 0}, radius = 0.15 } }
  for _, end_x in ipairs { -2.3, 0, 2.3 } do     -- the rollers show which way it runs
    body { name = name .. " roller", type = "kinematic", at = { x + end_x, y }, spin = surface_speed / 0.15, sensor = true,
           shape = circle { radius = 0.15 } }
  end
end
belt("upper belt", -1.6, 4.4, -speed)
belt("middle belt", 1.6, 2.9, speed)
belt("lower belt", -1.6, 1.4, -speed)
ground { y = 0, friction = mu }

local parcels = {}
local function parcel()
  local ball = #parcels % 2 == 1
  parcels[#parcels + 1] = body {
    name = ("parcel %d"):format(#parcels + 1), at = { -3.4, 4.55 + (ball and 0.22 or 0.2) }, friction = mu,
    density = 20, rolling_resistance = 0.02,
    shape = ball and circle { radius = 0.22 } or box { width = 0.5, height = 0.4 } }
end
parcel()
every(1.6, function() if #parcels < 4 then parcel() end end)
local first = parcels[1]

measure("speed of the first parcel", function() return first:velocity().x end)
local law = {}
for i = 1, 25 do law[i] = { 0.05 * i, math.min(speed, mu * 9.81 * 0.05 * i) } end
reference("speed of the first parcel", law)
expect("it gains mu g", function() return math.abs(first:velocity().x - mu * 9.81 * 0.3) < 1e-3 end, { at = 0.3 })
expect("then it rides at the speed of the belt", function()
  return math.abs(first:velocity().x - speed) < 1e-3
end, { at = 1 })
expect("all parcels arrive on the ground", function()
  for _, p in ipairs(parcels) do
    if p:center().y > 1 then return false end
  end
  return #parcels == 4
end)
plot { title = "first parcel, m/s", seconds = 17, at = "top_right",
       y = { ["to the right"] = function() return first:velocity().x end } }
caption { text = "The belts run right, left and right at 2 m/s", from = 0, to = 17 }
