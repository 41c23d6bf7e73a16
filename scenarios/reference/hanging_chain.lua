-- An equilibrium that does not depend on the step: twenty rigid links of 75 mm hang between points 1 m apart. Link k
-- leans by (k - 9.5) m g / H (J. Bernoulli 1691, here with links, so that it sags a little more than the cosh).
scenario {
  title = "Hanging chain", duration = 12, view = { center = {0, -0.3}, height = 1.05 },
  description = "Started as an arc of a circle, braked by drag, at rest on the catenary of links.",
  layers = { "bodies", "joints", "grid" }, golden = { frames = { 0, 20, 719 }, size = {480, 270} },
}
include "include/math_reference.lua"

local count, total, span, mass, g = 20, 1.5, 1, 0.1, 9.81
local length, middle = total / count, (count + 1) / 2
-- All links of a chain that leans by `lean(k)`: how far it reaches, and how deep its lowest pin hangs.
local function reach(lean)
  local x, deepest, y = 0, 0, 0
  for k = 1, count do
    local a = math.atan(lean(k))
    x, y = x + length * math.cos(a), y + length * math.sin(a)
    deepest = math.min(deepest, y)
  end
  return x, -deepest
end
local pull = root_between(function(h)                            -- H in weights of a link
  return reach(function(k) return (k - middle) / h end) - span
end, 0.1, 100)
local _, sag = reach(function(k) return (k - middle) / pull end)
local bend = root_between(function(b)                            -- of the arc it starts from
  return span - reach(function(k) return math.tan((k - middle) * b) end)
end, 0.01, 0.16)

local links, joints, before = {}, {}, world
local x, y = -span / 2, 0
for k = 1, count do
  local a = (k - middle) * bend
  local dx, dy = length * math.cos(a), length * math.sin(a)
  links[k] = body { name = "link " .. k, at = { x + dx / 2, y + dy / 2 }, angle = a, mass = mass, group = -1,
                    drag = { linear = 14 * mass }, shape = box { width = length, height = 0.02 } }
  joints[k] = revolute { before, links[k], at = {x, y} }
  before, x, y = links[k], x + dx, y + dy
end
joints[count + 1] = revolute { before, world, at = { span / 2, 0 } }

-- Drag takes part of the kick that gravity gives within a substep, and so of the reaction: without it in the end.
at(11, function() for _, link in ipairs(links) do link:set { drag = 0 } end end)

local function sagging()
  local l = links[count // 2]
  local p, a = l:position(), l:angle()
  return -(p.y + length / 2 * math.sin(a))
end
local function at_anchor()
  local force = joints[1]:reaction()
  return math.abs(force.x) / (mass * g), math.sqrt(force.x ^ 2 + force.y ^ 2) / (mass * g)
end
measure("sag", sagging)
reference("sag", { { 12, sag } })
measure("horizontal pull in weights of a link", function() return (at_anchor()) end)
reference("horizontal pull in weights of a link", { { 12, pull } })
measure("pull at the anchor in weights of a link", function() return (select(2, at_anchor())) end)
reference("pull at the anchor in weights of a link", { { 12, math.sqrt(pull ^ 2 + (count / 2) ^ 2) } })

expect("the closed form gives a sag of 0.50344663434 m and a pull of 4.10787898893", function()
  return math.abs(sag - 0.5034466343401927) <= 1e-12 and math.abs(pull - 4.107878988926029) <= 1e-11
end)
expect("in the end the middle hangs as deep, to 1e-8 m",
       function() return math.abs(sagging() - sag) <= 1e-8 end)
expect("and the chain pulls at its anchors as it should, to a millionth",
       function() return math.abs((at_anchor()) / pull - 1) <= 1e-6 end)
