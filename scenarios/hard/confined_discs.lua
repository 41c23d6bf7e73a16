-- Solver2D's Confined: one disc per tick, until 625 discs of 1 m fill a room of 20 m. They cover 491 of its 400 square
-- metres, so that they must overlap; gates on overlap and on energy (each new disc brings some) would ask too much.
scenario {
  title = "Six hundred and twenty-five discs in a room too small", duration = 16, rate = 60, fps = 60, gravity = {0, 0},
  method = { substeps = 4 },
  description = "More discs than the room can hold: who insists on no overlap shakes for ever or bursts the walls.",
  view = { center = {0, 10}, height = 22.5 }, layers = { "bodies" },
  golden = { frames = { 300, 959 }, size = {480, 270} },
}

for _, w in ipairs { { {0, -0.5}, 22, 1 }, { {0, 20.5}, 22, 1 }, { {-10.5, 10}, 1, 20 }, { {10.5, 10}, 1, 20 } } do
  body { name = "wall", type = "static", at = w[1], shape = box { width = w[2], height = w[3] } }
end
local side, discs = 25, {}
every(1 / 60, function()
  local i = #discs
  if i == side * side then return end
  discs[i + 1] = body { name = "disc " .. i + 1, at = { -9 + (i // side) * 18 / side, 1 + (i % side) * 18 / side },
                        shape = circle { radius = 0.5 } }
end)
local function over_all(start, fn)
  local most = start
  for _, d in ipairs(discs) do most = math.max(most, fn(d)) end
  return most
end
local function fastest()
  return over_all(0, function(d) local v = d:velocity() return math.sqrt(v.x^2 + v.y^2) end)
end
local function outermost()
  return over_all(0, function(d) local p = d:position() return math.max(math.abs(p.x), math.abs(p.y - 10)) end)
end
measure("fastest", fastest)
measure("outermost", outermost)
expect("all 625 are there", function() return #discs == side * side end)
expect("the room holds: no disc's centre ever reaches a wall",
       function() return outermost() < 10 end, { always = true })
expect("quality: no disc is ever faster than 10 m/s", function() return fastest() <= 10 end, { always = true })
expect("they come to rest: none is faster than 5 cm/s", function() return fastest() < 0.05 end)
