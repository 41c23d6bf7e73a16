-- A bit of everything: falling shapes, a turning paddle, a lift, a pendulum, with the hierarchy and the contacts drawn.
scenario {
  title = "Sandbox", duration = 12, seed = 20, view = { center = {0, 6}, height = 14.5 }, theme = "dark",
  description = "Discs and polygons rain on moving and fixed obstacles; the boxes are the bounding-volume hierarchy.",
  layers = { "bodies", "bvh", "contacts", "joints", "clock" }, golden = { frames = { 0, 150, 400, 719 } },
}

ground { y = 0 }
wall { a = {-12, 0}, b = {-12, 16} }
wall { a = {12, 0}, b = {12, 16} }
body { name = "hill", type = "static", shape = polygon { {-9.5, 0}, {-3.5, 0}, {-6.5, 2.2} } }
body { name = "shelf", type = "static", at = {-7.5, 6.5}, angle = -0.3, shape = box { width = 5, height = 0.4 } }
local paddle = body { name = "paddle", type = "kinematic", at = {6, 4.2}, spin = 1.3, shape = box { width = 5.5, height = 0.45 } }
local lift = body { name = "lift", type = "kinematic", at = {-0.5, 1.2}, velocity = {0, 0.7},
                    shape = regular { sides = 6, radius = 1.1 } }
local bob = body { name = "bob", at = {5.2, 11.5}, shape = circle { radius = 0.7 }, density = 3 }
revolute { world, bob, at = {1.5, 11.5} }

every(5, function() lift:set { velocity = { 0, -lift:velocity().y } } end)
at(7, function() paddle:set { spin = -2.2 } end)

every(0.12, function()
  if time() > 9 then return end
  local x = -10 + 20 * math.random()
  if math.random() < 0.5 then
    body { at = {x, 15}, shape = circle { radius = 0.22 + 0.3 * math.random() }, restitution = 0.3 }
  else
    body { at = {x, 15}, angle = 6 * math.random(),
           shape = regular { sides = math.random(3, 7), radius = 0.3 + 0.3 * math.random() } }
  end
end)

local arm = math.sqrt(3.7^2)
expect("the pendulum's arm keeps its length", function()
  local p = bob:position()
  return math.abs(math.sqrt((p.x - 1.5)^2 + (p.y - 11.5)^2) - arm) < 1e-6
end, { always = true })
