-- G. Galperin 2003: with masses of 1 and 100^k the impacts count the digits of pi. Most of them fall into the moment
-- when the heavy block turns, where the light one rattles in a gap a hundred times narrower.
scenario {
  title = "Three digits of pi", duration = 6, rate = 60, fps = 60, gravity = {0, 0},
  method = { substeps = 4, contact_solver = "event" },
  description = "A block 10,000 times as heavy pushes another one against a wall: 314 impacts.",
  view = { center = {5.4, 2}, height = 7.2 }, layers = { "bodies", "vectors" },
  golden = { frames = { 0, 359 }, size = {480, 270} },
}

local mass, speed = 10000, 2
body { name = "floor", type = "static", shape = box { width = 12.1, height = 0.3, at = {5.45, -0.15} }, friction = 0 }
body { name = "wall", type = "static", friction = 0, restitution = 1,
       shape = box { width = 0.6, height = 3.3, at = {-0.3, 1.35} } }
local function block(name, x, side, m, v)
  return body { name = name, at = {x, side / 2 + 0.002}, mass = m, velocity = {v, 0}, fixed_rotation = true,
                shape = box { width = side, height = side, friction = 0, restitution = 1 } }
end
local light, heavy = block("1 kg", 1.6, 0.6, 1, 0), block("10,000 kg", 5, 2, mass, -speed)

local impacts = 0
on_contact(light, nil, function() impacts = impacts + 1 end)
measure("impacts", function() return impacts end)
local digits = math.ceil(math.pi / math.atan(math.sqrt(1 / mass))) - 1
expect("there are exactly 314 impacts", function() return impacts == digits and digits == 314 end)
-- In the plane of sqrt(mass) times place the blocks are one ray of light between two mirrors: two reflections turn it
-- by twice the angle between them.
local turn = digits * math.atan(math.sqrt(1 / mass))
expect("quality: the heavy block goes back as fast as the mirrors say, to a millionth", function()
  return math.abs(heavy:velocity().x + speed * math.cos(turn)) <= 1e-6 * speed
end)
expect("in the end the blocks part from each other and from the wall",
       function() return light:velocity().x >= 0 and heavy:velocity().x >= light:velocity().x end)
local first = energy().total
expect("quality: the energy stays to a part in a thousand million",
       function() return math.abs(energy().total - first) <= 1e-9 * first end, { always = true })
vector { body = heavy, of = "velocity", scale = 0.3 }
