-- Which answer a simultaneous impact gets: of five touching discs the last takes all of the velocity when impacts are
-- handed on pair by pair (declared here); one linear complementarity problem for all gives another, as lawful one.
scenario {
  title = "Five discs in a row", duration = 2, rate = 240, gravity = {0, 0}, method = { contact_solver = "event" },
  description = "One disc meets four that touch each other: only the last one flies on.",
  view = { center = {0.4, 0}, height = 2.2 }, layers = { "bodies", "vectors" },
  golden = { frames = { 0, 60, 119 }, size = {480, 270} },
}

local radius, speed, discs = 0.125, 1, {}
for i = 1, 5 do
  discs[i] = body { name = "disc " .. i, at = { i == 1 and -1 or (i - 2) * 2 * radius, 0 }, restitution = 1,
                    friction = 0, velocity = { i == 1 and speed or 0, 0 }, shape = circle { radius = radius } }
  vector { body = discs[i], of = "velocity", scale = 0.4 }
end
local impact = (1 - 2 * radius) / speed
local starts = {}
for i, disc in ipairs(discs) do
  starts[i] = disc:position().x
  measure("x of disc " .. i, function() return disc:position().x end)
  reference("x of disc " .. i, function(t)
    if i == 1 then return starts[1] + speed * math.min(t, impact) end
    return starts[i] + (i == 5 and speed * math.max(0, t - impact) or 0)
  end)
end
expect("the last one takes all of the velocity, to 1e-9",
       function() return math.abs(discs[5]:velocity().x - speed) <= 1e-9 end)
expect("the others rest, to 1e-9 m/s", function()
  for i = 1, 4 do if math.abs(discs[i]:velocity().x) > 1e-9 then return false end end
  return true
end)
expect("it left in the moment of the impact, to 1e-8 m",
       function() return math.abs(discs[5]:position().x - starts[5] - speed * (time() - impact)) <= 1e-8 end)
