-- A leaf, a ball and a stone fall through a side wind: the lighter for its size, the more the air decides.
scenario {
  title = "Side wind", duration = 6, view = { center = {6, 5}, height = 13 },
  description = "Drag against weight: three bodies of one size and different mass in the same wind.",
  layers = { "bodies", "trails", "labels", "grid" }, golden = { frames = { 0, 120, 359 } },
}

ground { y = 0 }
wind { velocity = {4, 0} }
drag { linear = 0.02, quadratic = 0.16 }

local masses = { leaf = 0.08, ball = 0.5, stone = 6 }
local height = { leaf = 10, ball = 10, stone = 10 }
local place = { leaf = -1.5, ball = 1.5, stone = 4.5 }
local bodies = {}
for _, name in ipairs { "leaf", "ball", "stone" } do
  local shape = name == "leaf" and hull { {-0.45, 0}, {0, -0.14}, {0.45, 0}, {0, 0.14} } or circle { radius = 0.4 }
  bodies[name] = body { name = name, at = { place[name], height[name] }, mass = masses[name], shape = shape,
                        angle = name == "leaf" and 0.5 or 0 }
  trail { body = bodies[name], seconds = 6 }
  label { body = bodies[name], text = name }
end

-- Falling straight, drag carries the weight at this speed: c v + c2 v^2 = m g.
local function terminal(m) return (-0.02 + math.sqrt(0.0004 + 4 * 0.16 * m * 9.81)) / 0.32 end
measure("fall of the leaf", function() return -bodies.leaf:velocity().y end)
expect("the leaf never falls faster than its terminal speed", function()
  return -bodies.leaf:velocity().y < terminal(masses.leaf) + 1e-6
end, { always = true })
expect("the stone lands first", function() return bodies.stone:position().y < 0.5 end, { at = 1.6 })
