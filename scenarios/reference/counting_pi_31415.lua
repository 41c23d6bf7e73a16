-- Five digits of pi: with masses of 1 and 100,000,000 there are ceil(pi / atan(10^-4)) - 1 = 31415 impacts (G. Galperin
-- 2003), most of them within the fifth of a millisecond in which the heavy block turns; substeps are short for these.
scenario {
  title = "Five digits of pi", duration = 4, rate = 3000, fps = 60, gravity = {0, 0},
  method = { contact_solver = "event", substeps = 100 },
  description = "A block a hundred million times as heavy: 31415 impacts, a hundred million of them to the second.",
  view = { center = {2, 0.8}, height = 3.2 }, layers = { "bodies", "vectors", "labels" },
  golden = { frames = { 0, 78, 239 }, size = {480, 270} },
}

local speed, mass = 1, 1e8
body { name = "floor", type = "static", mask = 0, shape = box { width = 4.9, height = 0.2, at = {2.05, -0.1} } }
body { name = "wall", type = "static", friction = 0, restitution = 1,
       shape = box { width = 0.4, height = 1.7, at = {-0.2, 0.65} } }
local function block(name, x, side, m, v)
  return body { name = name, at = { x, side / 2 + 0.002 }, mass = m, velocity = {v, 0}, fixed_rotation = true,
                friction = 0, restitution = 1, shape = box { width = side, height = side } }
end
local light, heavy = block("1 kg", 1, 0.5, 1, 0), block("100,000,000 kg", 2, 1, mass, -speed)
label { body = light, text = "1 kg" }
label { body = heavy, text = "100,000,000 kg" }
vector { body = heavy, of = "velocity", scale = 0.4 }

local count = 0
on_contact(light, nil, function() count = count + 1 end)
local exact = math.ceil(math.pi / math.atan(1e-4)) - 1
measure("impacts", function() return count end)
reference("impacts", { { 4, exact } })
-- As between two mirrors: every second impact turns the ray by twice their angle.
local last = -speed * math.cos(2 * math.ceil(exact / 2) * math.atan(1e-4))
measure("velocity of the heavy block", function() return heavy:velocity().x end)
reference("velocity of the heavy block", { { 0, -speed }, { 4, last } })
local first = energy().total
expect("there are exactly 31415 impacts", function() return count == exact and exact == 31415 end)
expect("the heavy block goes back as fast as the mirrors say, to 1e-9",
       function() return math.abs(heavy:velocity().x - last) <= 1e-9 end)
expect("the energy stays, to 1e-9", function() return math.abs(energy().total / first - 1) <= 1e-9 end)
