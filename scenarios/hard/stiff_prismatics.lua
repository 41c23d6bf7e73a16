-- Two heavy discs on rails of a tiny one between them, with stiff, overdamped springs along the rails.
scenario {
  title = "Stiff springs on a tiny body",
  description = "A disc of 0.1 m on sprung rails between two of 2 m, 400:1: Box2D's sample says that it diverges.",
  duration = 5, rate = 60, fps = 60, gravity = {0, -10}, method = { substeps = 4 }, effects = "auto",
  view = { center = {0, 2.4}, height = 10.5 }, layers = { "bodies", "joints", "contacts" },
  golden = { frames = { 299 }, size = {480, 270} },
}
include "include/gates.lua"

ground { y = 0 }
local small = body { name = "small", at = {0, 3}, shape = circle { radius = 0.1 } }
local bodies, rails = { small }, {}
for i, x in ipairs { -3.5, 3.5 } do
  local large = body { name = "large " .. i, at = { x, 3 }, shape = circle { radius = 2 } }
  bodies[#bodies + 1] = large
  rails[i] = prismatic { small, large, at = {0, 3}, axis = {1, 0} }
  -- 10 Hz and twice the critical damping for the mass that moves along the rail: nearly the small disc's own. At four
  -- substeps of 60 Hz damping times step over the small mass is 2: pushed forward explicitly, each substep overshoots.
  local m = 1 / (1 / small:mass() + 1 / large:mass())
  local omega = 2 * math.pi * 10
  spring { small, large, from = {0, 3}, to = { x, 3 }, stiffness = m * omega ^ 2, damping = 2 * 2 * m * omega }
end

no_overlap(0.1, 2)
no_gap(rails, 0.1, 0)
no_energy_gained(bodies, 3)
local function fastest()
  local v = 0
  for _, b in ipairs(bodies) do v = math.max(v, math.sqrt(b:velocity().x ^ 2 + b:velocity().y ^ 2)) end
  return v
end
measure("fastest", fastest)
measure("off the middle", function()
  return math.abs(small:position().x - (bodies[2]:position().x + bodies[3]:position().x) / 2)
end)
measure("small height", function() return small:position().y end)
-- They fall one metre: 4.5 m/s.
expect("nothing is faster than its fall, by more than a tenth", function()
  return fastest() < 4.95
end, { always = true })
expect("the small disc stays between the large ones", function()
  return math.abs(small:position().x - (bodies[2]:position().x + bodies[3]:position().x) / 2) < 0.1
end, { always = true })
expect("the large discs rest on the ground", function()
  return math.abs(bodies[2]:position().y - 2) < 0.02 and math.abs(bodies[3]:position().y - 2) < 0.02
end)
expect("the rails hold the small disc up", function() return math.abs(small:position().y - 2) < 0.02 end)
