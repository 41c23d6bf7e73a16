-- Hulls that have cost engines a crash: tiny and written far from their body's origin, or all but collinear.
scenario {
  title = "Tiny hulls, far from their origin",
  description = "A triangle of 0.1 m drawn 78 m off its origin (Box2D's sample Bad Steiner), and other small hulls.",
  duration = 3, rate = 60, fps = 60, gravity = {0, -10}, method = { substeps = 4 }, effects = "auto",
  view = { center = {0.8, 0.3}, height = 1 }, layers = { "bodies", "contacts" },
  golden = { frames = { 179 }, size = {480, 270} },
}
include "include/gates.lua"

ground { y = 0, friction = 0.6 }
-- Box2D's sample Bad Steiner: the parallel axis theorem takes 6000 from 6000 to find the inertia.
local far = body { name = "far from its origin", at = {-48.7, 61.06}, friction = 0.6, shape = hull {
  { 48.7599983, -60.5699997 }, { 48.7400017, -60.5400009 }, { 48.6800003, -60.5600014 } } }
-- The same triangle, written about its own middle, a metre to the right.
local mx, my = (48.7599983 + 48.7400017 + 48.6800003) / 3, -(60.5699997 + 60.5400009 + 60.5600014) / 3
local near = body { name = "written about itself", at = { 1 + mx - 48.7, 61.06 + my }, friction = 0.6, shape = hull {
  { 48.7599983 - mx, -60.5699997 - my }, { 48.7400017 - mx, -60.5400009 - my },
  { 48.6800003 - mx, -60.5600014 - my } } }
-- A disc of a centimetre with as many corners as a hull may have here.
local many = {}
for i = 1, 16 do many[i] = { 0.01 * math.cos(2 * math.pi * i / 16), 0.01 * math.sin(2 * math.pi * i / 16) } end
local round = body { name = "sixteen corners", at = {0.5, 0.05}, friction = 0.6, shape = hull(many) }
-- Corners closer to each other than a micrometre, and corners on the line between others.
local doubled = body { name = "doubled corners", at = {1.6, 0.3}, friction = 0.6, shape = hull {
  {-0.05, -0.05}, {0.05, -0.05}, {0.05, -0.05 + 1e-9}, {0, -0.05}, {0.05, 0.05},
  {0, 0.05 + 1e-10}, {-0.05, 0.05}, {-0.05, 0} } }
local bodies = { far, near, round, doubled }

no_overlap(0.01, 1.5)
no_energy_gained(bodies, 1)
local function lowest()
  local y = 100
  for _, b in ipairs(bodies) do y = math.min(y, b:center().y) end
  return y
end
local function fastest()
  local v = 0
  for _, b in ipairs(bodies) do
    v = math.max(v, math.abs(b:velocity().x) + math.abs(b:velocity().y) + 0.05 * math.abs(b:spin()))
  end
  return v
end
measure("lowest", lowest)
measure("fastest", fastest)
measure("far: turned", function() return far:angle() end)
measure("near: turned", function() return near:angle() end)
expect("no body sinks into the ground", function() return lowest() > 0.005 end, { always = true })
-- They fall half a metre at most: 3.2 m/s, and what a blow turns into spin.
expect("nothing is thrown", function() return fastest() < 5 end, { always = true })
expect("all come to rest", function() return fastest() < 1e-3 end)
expect("where it is written does not change how the triangle falls", function()
  return math.abs(far:angle() - near:angle()) < 0.01 and math.abs(far:center().x + 1 - near:center().x) < 1e-3
end)
expect("a square with doubled corners is a square", function()
  local level = math.abs(doubled:center().y - 0.05) < 1e-3 and math.abs(doubled:angle()) < 1e-3
  return level and math.abs(doubled:mass() - 0.01) < 1e-6
end)
