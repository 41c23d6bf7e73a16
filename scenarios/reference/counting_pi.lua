-- Impacts counted exactly: one missed, or one too many, is a wrong digit. G. Galperin 2003: with masses 1 and 100^k
-- there are ceil(pi / atan(10^-k)) - 1 of them, 3, 31, 314 and 3141.
scenario {
  title = "Four digits of pi", duration = 9, rate = 240, gravity = {0, 0},
  method = { contact_solver = "event", substeps = 16 },
  description = "A light block between a wall and blocks 1, 100, 10,000 and 1,000,000 times as heavy.",
  view = { center = {3.9, 2.4}, height = 6 }, layers = { "bodies", "vectors", "labels" },
  golden = { frames = { 0, 120, 539 }, size = {480, 270} },
}

body { name = "wall", type = "static", friction = 0, restitution = 1,
       shape = box { width = 0.4, height = 5.6, at = {-0.2, 2.4} } }
local speed, side = 1, 0.5
local masses = { [0] = "1 kg", "100 kg", "10,000 kg", "1,000,000 kg" }
for k = 0, 3 do
  local y, mass = 0.6 + 1.2 * (3 - k), 100 ^ k
  local function block(name, x, size, m, v)
    return body { name = name, at = {x, y}, mass = m, velocity = {v, 0}, fixed_rotation = true, friction = 0,
                  restitution = 1, shape = box { width = size, height = size } }
  end
  local light = block("1 kg in lane " .. k, 1, side, 1, 0)
  local heavy = block(masses[k], 2.5, side * (1 + k / 4), mass, -speed)
  local count = 0
  local exact = math.ceil(math.pi / math.atan(10.0 ^ -k)) - 1
  on_contact(light, nil, function() count = count + 1 end)
  label { body = heavy, text = masses[k] }
  vector { body = heavy, of = "velocity", scale = 0.6 }
  measure(("impacts, mass ratio %d"):format(mass), function() return count end)
  reference(("impacts, mass ratio %d"):format(mass), { { 9, exact } })
  expect(("with masses of 1 and %d there are %d impacts"):format(mass, exact), function() return count == exact end)
  -- In the plane of sqrt(mass) times place it is a ray between two mirrors: every second impact turns it by twice their
  -- angle.
  local turn = 2 * math.ceil(exact / 2) * math.atan(10.0 ^ -k)
  measure(("last velocity, mass ratio %d"):format(mass), function() return heavy:velocity().x end)
  reference(("last velocity, mass ratio %d"):format(mass), { { 9, -speed * math.cos(turn) } })
end
local first = energy().total
expect("the energy stays, to 1e-9", function() return math.abs(energy().total / first - 1) <= 1e-9 end,
       { always = true })
