-- A closed loop driven by a crank that turns evenly: what the joints are off by is all there is, since the place of the
-- slider follows from the angle. x = r cos + sqrt(l^2 - r^2 sin^2), from Pythagoras.
scenario {
  title = "Driven slider and crank", duration = 1, view = { center = {0.75, 0}, height = 1.5 },
  description = "A crank of 0.5 m at 10 rad/s, a rod of 1.5 m, and a slider on the axis.",
  layers = { "bodies", "joints", "vectors" }, golden = { frames = { 0, 6, 59 }, size = {480, 270} }, gravity = {0, 0},
}

local r, l, speed = 0.5, 1.5, 10
local crank = body { name = "crank", type = "kinematic", at = {0, 0}, spin = speed, group = -1,
                     shapes = { circle { radius = 0.08 }, capsule { a = {0, 0}, b = {r, 0}, radius = 0.05 } } }
local rod = body { name = "rod", at = { r + l / 2, 0 }, mass = 1, group = -1, velocity = { 0, speed * r / 2 },
                   spin = -speed * r / l, shape = capsule { a = {-l / 2, 0}, b = {l / 2, 0}, radius = 0.04 } }
local slider = body { name = "slider", at = { r + l, 0 }, mass = 1, group = -1,
                      shape = box { width = 0.3, height = 0.2 } }
local joints = {
  revolute { crank, rod, at = { r, 0 } },
  revolute { rod, slider, at = { r + l, 0 } },
  prismatic { world, slider, at = { r + l, 0 }, axis = {1, 0} },
}

local function root(t) return math.sqrt(l ^ 2 - (r * math.sin(speed * t)) ^ 2) end
local function exact(t) return r * math.cos(speed * t) + root(t) end
measure("x", function() return slider:position().x end)
reference("x", exact)
measure("v", function() return slider:velocity().x end)
reference("v", function(t)
  local s, c = math.sin(speed * t), math.cos(speed * t)
  return -r * speed * s - r ^ 2 * speed * s * c / root(t)
end)

expect("after 1 s the slider is at 1.05559482552 m, to 1e-12 m",
       function() return math.abs(slider:position().x - 1.055594825520388) <= 1e-12 end)
expect("its place always follows from the crank's angle, to 1e-11 m",
       function() return math.abs(slider:position().x - exact(time())) <= 1e-11 end, { always = true })
expect("the loop stays closed to 1e-12 m", function()
  for _, j in ipairs(joints) do if j:gap() > 1e-12 then return false end end
  return true
end, { always = true })
vector { body = slider, of = "velocity", scale = 0.05 }
