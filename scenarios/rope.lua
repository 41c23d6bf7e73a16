-- A ball on a slack rope: it falls freely, is caught where the rope ends, and swings.
scenario {
  title = "Caught by a rope",
  description = "While the rope is slack the ball falls freely; taut, the rope is a rod that cannot push.",
  duration = 6, view = { center = {0, -0.75}, height = 2.9 },
  layers = { "bodies", "joints", "trails" },
  golden = { frames = { 0, 80, 177, 476 } },
}

local reach_of_rope, g = 1.6, 9.81
local ball = body { name = "ball", at = {-0.9, 0.1}, velocity = {1.1, 0.6}, shape = circle { radius = 0.12 }, density = 20 }
local tie = rope { world, ball, from = {0, 0}, to = ball:position(), length = reach_of_rope }

local function reach() return math.sqrt(ball:position().x ^ 2 + ball:position().y ^ 2) end
measure("distance from the hook", reach)
measure("tension", function() local f = tie:reaction() return math.sqrt(f.x ^ 2 + f.y ^ 2) end)
measure("height", function() return ball:position().y end)
reference("height", { { 0.25, 0.1 + 0.6 * 0.25 - g * 0.25 ^ 2 / 2 }, { 0.5, 0.1 + 0.6 * 0.5 - g * 0.5 ^ 2 / 2 } })
expect("the rope is never longer than it is", function() return reach() < reach_of_rope + 1e-9 end, { always = true })
expect("until the rope is taut the ball falls freely", function()
  return math.abs(ball:position().x - (-0.9 + 1.1 * 0.5)) < 1e-9 and math.abs(ball:velocity().y - (0.6 - g * 0.5)) < 1e-9
end, { at = 0.5 })
expect("at the end the ball swings on the taut rope", function() return math.abs(reach() - reach_of_rope) < 1e-9 end)
trail { body = ball, seconds = 1.5 }
body { name = "beam", type = "static", at = {0, 0.05}, shape = box { width = 0.8, height = 0.1 }, group = -1 }
plot { title = "Tension (N)", seconds = 6, at = "top_right", y = { tension = function() local f = tie:reaction() return math.sqrt(f.x ^ 2 + f.y ^ 2) end } }
slow { from = 0, to = 0.65, factor = 0.25 }
caption { text = "Slack: the ball falls freely", from = 0, to = 0.65 }
caption { text = "Taut: it swings like a pendulum", from = 0.65 }
