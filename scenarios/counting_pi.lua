-- Two blocks and a wall count the digits of pi (Galperin 2003), if every impact is made at its own time.
scenario {
  title = "Blocks that count pi", duration = 10, gravity = {0, 0}, view = { center = {4.2, 1.4}, height = 6 },
  description = "A block a hundred times as heavy pushes another one against a wall: 31 impacts, and not one more.",
  method = { contact_solver = "event", substeps = 1 }, layers = { "bodies", "vectors", "labels" },
  golden = { frames = { 0, 180, 270, 599 } },
}

ground { y = 0, friction = 0 }
body { name = "wall", type = "static", shape = box { width = 1, height = 4, at = {-0.5, 2} }, friction = 0, restitution = 1 }
local function block(name, x, side, mass, v)
  return body { name = name, at = {x, side / 2 + 0.002}, mass = mass, velocity = {v, 0}, fixed_rotation = true,
                shape = box { width = side, height = side, friction = 0, restitution = 1 } }
end
local light = block("1 kg", 1.8, 0.7, 1, 0)
local heavy = block("100 kg", 6, 1.6, 100, -1.4)

local impacts = 0
on_contact(light, nil, function() impacts = impacts + 1 end)

label { body = light, text = "1 kg" }
label { body = heavy, text = "100 kg" }
vector { body = heavy, of = "velocity", scale = 0.5 }
caption { text = "Impacts count the digits of pi: 3, 31, 314 for 1, 100, 10,000 kg", from = 0, to = 10 }
plot { title = "Impacts", y = { count = function() return impacts end }, seconds = 10, at = "top_right" }

measure("impacts", function() return impacts end)
measure("energy", function() return energy().total end)
reference("energy", function() return 0.5 * 100 * 1.4^2 end)
expect("there are 31 impacts", function() return impacts == 31 end)
expect("in the end the blocks part from each other and from the wall",
       function() return light:velocity().x >= 0 and heavy:velocity().x >= light:velocity().x end)
