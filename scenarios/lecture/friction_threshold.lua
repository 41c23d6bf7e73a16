-- Thesis, 3.5: friction follows the pull as long as it can. When it cannot any more, it gives way and becomes smaller.
local m, static, kinetic, g = 2, 0.6, 0.4, 9.81                    -- kg
local stiffness, hand_speed = 12, 0.7                              -- N/m, m/s: the pull grows by 8.4 N a second

scenario {
  title = "Static and kinetic friction",
  description = "A block is pulled by a spring: friction answers every pull up to its limit, then drops and the block jerks on.",
  duration = 5, gravity = {0, -g}, view = { center = {0.4, 1.05}, height = 4.6 },
  layers = { "bodies", "joints", "forces" }, force_scale = 0.07, golden = { frames = {160, 320, 480, 800, 1196}, size = {640, 360} },
}

ground { y = 0, friction = { static = static, kinetic = kinetic } }
local block = body { name = "block", at = {-2.6, 0.4}, mass = m, fixed_rotation = true, friction = { static = static, kinetic = kinetic },
                     shape = box { width = 0.9, height = 0.8 } }
local hand = body { name = "hand", type = "kinematic", at = {-1.1, 0.4}, velocity = {hand_speed, 0},
                    shape = circle { radius = 0.12 }, mask = 0 }
local pull = spring { block, hand, from = {-2.15, 0.4}, to = {-1.1, 0.4}, stiffness = stiffness }

-- What the spring does not turn into momentum, friction takes.
local before, now = 0, 0
local function tension() return math.abs(pull:reaction().x) end
every(1 / 240, function() before, now = now, block:velocity().x end)
local function friction() return tension() - m * (block:velocity().x - now) * 240 end

section { at = 0, name = "Friction follows the pull" }
section { at = 1.4, name = "It gives way" }
section { at = 3, name = "Stick and slip" }
slow { from = 0, to = 5, factor = 0.25 }
caption { text = "The block rests: friction equals the pull, up to $\\mu_s F_n$ = 11.8 N", from = 0, to = 1.4 }
caption { text = "It slides: friction is $\\mu_k F_n$ = 7.8 N, however strong the pull", from = 1.4, to = 3 }
caption { text = "Where it comes to rest it sticks again, and all begins anew", from = 3 }
plot { title = "Friction against pull", unit = "N", x = { pull = tension }, x_unit = "N", y = { friction = friction },
       seconds = 5, at = "top_right" }

local function mean_pull(t) return stiffness * hand_speed * (t - 1 / 480) end    -- over the tick that ends at t, while the block rests
measure("friction", friction)
reference("friction", { {0.5, mean_pull(0.5)}, {1, mean_pull(1)}, {1.3, mean_pull(1.3)}, {2, kinetic * m * g}, {2.4, kinetic * m * g} })
expect("friction never exceeds its static limit", function() return friction() < static * m * g + 0.1 end, { always = true })
