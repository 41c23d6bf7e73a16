-- A sliver three millimetres thick and a point five millimetres above it; and a foil of 0.4 mm, shot at.
scenario {
  title = "A point and a sliver",
  description = "Millimetres between bodies of millimetres; Box2D's own test of a cast against 0.2 mm is switched off.",
  duration = 1, rate = 60, fps = 60, gravity = {0, -10}, method = { substeps = 4 }, effects = "auto",
  view = { center = {0.005, 0.02}, height = 0.075 }, layers = { "bodies", "contacts" },
  golden = { frames = { 59 }, size = {480, 270} },
}
include "include/gates.lua"

local thick, radius, above, foil = 0.0032, 0.002, 0.005, 0.06
body { name = "sliver", type = "static", at = {0, 0}, shape = box { width = 1, height = thick } }
local point = body { name = "point", at = { 0.02, thick / 2 + above + radius }, shape = circle { radius = radius } }
-- A triangle as thin as the sliver, lying still on it: its normals all but coincide.
local flat = body { name = "flat", at = { -0.028, thick / 2 }, shape = hull { {-0.025, 0}, {0.025, 0}, {0.02, thick} } }
body { name = "foil", type = "static", at = { foil, 0.03 }, shape = box { width = 0.0004, height = 0.04 } }
local shot = body { name = "shot", at = { foil - 0.4, 0.04 }, velocity = { 500, 0 }, bullet = true, gravity_scale = 0,
                     shape = circle { radius = radius } }
-- A needle of half a millimetre flies at it point first.
local needle = body { name = "needle", at = { foil - 0.4, 0.025 },
                      velocity = { 500, 0 }, bullet = true, gravity_scale = 0,
                      shape = box { width = 0.05, height = 0.0005 } }

no_overlap(radius, 0.5)
measure("point above the sliver", function() return point:position().y - radius - thick / 2 end)
measure("flat above the sliver", function() return flat:position().y - thick / 2 end)
measure("shot", function() return shot:position().x end)
measure("needle", function() return needle:position().x end)
-- Free fall from 5 mm takes 31.6 ms: after one step of 16.7 ms it has fallen g t^2 / 2, untouched.
expect("the point falls freely until it touches", function()
  return math.abs(point:position().y - (thick / 2 + above + radius - 5 * time() ^ 2)) < 1e-9
end, { at = 1 / 60 })
expect("the point lies on the sliver", function()
  return math.abs(point:position().y - radius - thick / 2) < 0.1 * radius
end)
expect("quality: to a micrometre", function() return math.abs(point:position().y - radius - thick / 2) < 1e-6 end)
expect("the thin triangle lies still", function()
  local p = flat:position()
  return math.abs(p.y - thick / 2) < 0.1 * thick and math.abs(flat:angle()) < 1e-2 and math.abs(p.x + 0.028) < 1e-3
end, { always = true })
expect("the shot does not pass the foil", function() return shot:position().x < foil end, { always = true })
expect("the needle does not pass the foil", function()
  return needle:position().x + 0.025 < foil + 0.001
end, { always = true })
