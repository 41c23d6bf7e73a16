-- How far a stack sinks into itself: rigid boxes do not. The set-up of Solver2D's stack (E. Catto, 2024).
scenario {
  title = "The height of fifteen boxes", duration = 10, rate = 60, gravity = {0, -10},
  description = "A staggered stack at rest: its top stays where it is, 15 m above the ground.",
  view = { center = {0, 7.4}, height = 17 }, layers = { "bodies", "contacts" },
  golden = { frames = { 599 }, size = {480, 270} },
}

body { name = "floor", type = "static", at = {0, -0.5}, shape = box { width = 60, height = 1 }, friction = 0.6 }
local top
for i = 1, 15 do
  local side = (i % 2 == 0) and 0.01 or -0.01
  top = body { name = "box " .. i, at = { side, i - 0.5 }, shape = box { width = 1, height = 1 }, friction = 0.6 }
end

measure("top", function() return top:position().y + 0.5 end)
reference("top", function() return 15 end)
measure("sideways", function() return top:position().x end)
reference("sideways", function() return -0.01 end)
expect("it sinks by less than a micrometre", function() return math.abs(top:position().y - 14.5) < 1e-6 end)
expect("it leans by less than a micrometre", function() return math.abs(top:position().x + 0.01) < 1e-6 end)
