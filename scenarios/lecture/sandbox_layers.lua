-- Thesis, 6.1: one scene, looked at through one layer after the other.
scenario {
  title = "One scene, many layers",
  description = "A small sandbox of falling and resting bodies, seen through one layer after another.",
  duration = 12, seed = 3, view = { center = {0, 2.65}, height = 8.4 }, layers = { "bodies", "joints" },
  force_scale = 0.07, golden = { frames = {180, 420, 660, 900, 1140, 1380, 1620, 1880}, size = {640, 360} },
}

ground { y = 0 }
wall { a = {-6.6, 0}, b = {-6.6, 9} }
wall { a = {6.6, 0}, b = {6.6, 9} }
body { name = "hill", type = "static", shape = polygon { {-5.5, 0}, {-1.9, 0}, {-3.7, 1.2} } }
body { name = "paddle", type = "kinematic", at = {3.2, 2.2}, spin = 0.8, shape = box { width = 2.6, height = 0.25 } }
local bob = body { name = "bob", at = {2.6, 5.8}, shape = circle { radius = 0.4 }, density = 2 }
local pivot = {0.4, 5.8}
revolute { world, bob, at = pivot }
local made = 0
every(0.35, function()
  if made == 26 then return end
  made = made + 1
  local x = -5 + 9 * math.random()
  local what = math.random() < 0.4 and circle { radius = 0.2 + 0.2 * math.random() } or
               regular { sides = math.random(3, 6), radius = 0.3 + 0.2 * math.random() }
  body { at = {x, 7.8}, angle = 6 * math.random(), shape = what, friction = 0.5 }
end)

local shown = {
  { "Bodies", "static sand, moving blue, driven green", "bodies", "joints" },
  { "bvh", "the tree of boxes that finds who may touch", "bodies", "bvh" },
  { "aabbs", "the tight box of every shape", "bodies", "aabbs" },
  { "contacts", "where shapes touch, and how hard", "bodies", "joints", "contacts" },
  { "forces", "what contacts and joints do, in newtons", "bodies", "joints", "forces" },
  { "islands", "what touches is solved together", "bodies", "islands" },
  { "ids, mass", "who is who, and where it balances", "bodies", "ids", "mass" },
  { "energy", "every body that is dropped in brings its own", "bodies", "joints", "energy" },
}
slow { from = 0, to = 12, factor = 0.5 }
for i, layer in ipairs(shown) do
  local from, to = 1.5 * (i - 1), i < #shown and 1.5 * i or nil
  section { at = from, name = layer[1] }
  freeze { at = from + 0.75, seconds = 1 }
  caption { text = layer[1] .. ": " .. layer[2], from = from, to = to }
  if i > 1 then layers { at = from, table.unpack(layer, 3) } end
end

expect("the pendulum's arm keeps its length", function()
  local p = bob:position()
  return math.abs(((p.x - pivot[1]) ^ 2 + (p.y - pivot[2]) ^ 2) ^ 0.5 - 2.2) < 1e-6
end, { always = true })
