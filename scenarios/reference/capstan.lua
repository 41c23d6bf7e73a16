-- Friction that multiplies along a chain of contacts: a weightless rope lies on a turning drum with sixteen beads, all
-- sliding, half a turn. L. Euler 1769: e^(mu pi) for a rope; with n beads, each turning it by d = pi / n, it is
-- ((cos d/2 + mu sin d/2) / (cos d/2 - mu sin d/2))^n, from the balance of forces on a bead.
scenario {
  title = "Capstan", duration = 1, rate = 240, view = { center = {0, -0.05}, height = 2.8 },
  description = "A drum turns under a rope with a weight on one side: on the other it pulls 2.575 times as much.",
  layers = { "bodies", "joints", "contacts", "labels" }, golden = { frames = { 0, 59 }, size = {480, 270} },
}

local mu, g, count, radius, bead = 0.3, 9.81, 16, 0.8, 0.03
local turn = math.pi / count
body { name = "drum", type = "kinematic", at = {0, 0}, spin = -1, friction = mu, shape = circle { radius = radius } }
local function place(k)
  local a = (k - 0.5) * turn
  return { (radius + bead) * math.cos(a), (radius + bead) * math.sin(a) }
end
-- Its weight is that of nothing, and what mass it has does not matter to what does not move.
local beads = {}
for k = 1, count do
  beads[k] = body { name = "bead " .. k, at = place(k), mass = 1e-3, gravity_scale = 0, fixed_rotation = true,
                    group = -1, friction = mu, shape = circle { radius = bead } }
  if k > 1 then distance { beads[k - 1], beads[k], from = place(k - 1), to = place(k) } end
end
local right, left = place(1), place(count)
local weight = body { name = "weight", at = { right[1], -1.1 }, mass = 1, shape = box { width = 0.25, height = 0.25 } }
distance { beads[1], weight, from = right, to = weight:position() }
local anchor = distance { world, beads[count], from = { left[1], -1.1 }, to = left }
label { body = weight, text = "1 kg" }

local exact = ((math.cos(turn / 2) + mu * math.sin(turn / 2)) / (math.cos(turn / 2) - mu * math.sin(turn / 2))) ^ count
local function ratio()
  local pull = anchor:reaction()
  return math.sqrt(pull.x ^ 2 + pull.y ^ 2) / (weight:mass() * g)
end
measure("pull of the anchor by the weight's", ratio)
reference("pull of the anchor by the weight's", { { 0.5, exact }, { 1, exact } })   -- once they all slide
local start = weight:position().y
measure("sinking of the weight", function() return start - weight:position().y end)
reference("sinking of the weight", function() return 0 end)
expect("sixteen beads multiply it by 2.57485385670", function() return math.abs(exact - 2.574853856704819) <= 1e-12 end)
expect("so they do here, to a millionth", function() return math.abs(ratio() / exact - 1) <= 1e-6 end)
expect("from 0.05 s on the weight hangs still, to 1e-6 m",
       function() return time() < 0.05 or math.abs(start - weight:position().y) <= 1e-6 end, { always = true })
