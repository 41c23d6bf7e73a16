-- Ten centimetres of wall, and discs that pass thirty of them in one step; once at home, once ten thousand km away.
scenario {
  title = "Bullets at a thin wall",
  description = "200 m/s against 0.1 m of wall, at home and at x = 1e7 m, where a float knows whole metres only.",
  duration = 0.5, rate = 60, fps = 60, gravity = {0, 0}, method = { substeps = 4 }, effects = "auto",
  view = { center = {1.6, 0}, height = 4 }, layers = { "bodies", "contacts" },
  golden = { frames = { 29 }, size = {480, 270} },
}

local radius, thin, speed = 0.1, 0.1, 200
local shots = {}
for i, home in ipairs { 0, 1e7 } do
  body { name = "wall at " .. home, type = "static", at = { home - thin / 2, 0 },
         shape = box { width = thin, height = 3 } }
  for k = 1, 3 do   -- at different phases of the step, so that one of them would jump the wall whatever the rate is
    shots[#shots + 1] = { home = home, handle = body {
      name = ("bullet %d.%d"):format(i, k), at = { home + 4 + 1.1 * k, k - 2 }, velocity = { -speed, 0 }, bullet = true,
      shape = circle { radius = radius } } }
  end
end
local function extreme(pick, home)
  local x
  for _, s in ipairs(shots) do
    if s.home == home then x = pick(x or s.handle:position().x - home, s.handle:position().x - home) end
  end
  return x
end
for _, home in ipairs { 0, 1e7 } do
  local where = home == 0 and "at the origin" or "at 1e7 m"
  measure("least x " .. where, function() return extreme(math.min, home) end)
  expect("nothing passes the wall " .. where, function() return extreme(math.min, home) > 0 end, { always = true })
  expect("the bullets have stopped " .. where, function() return extreme(math.max, home) < 0.5 end)
end
expect("quality: they touch the wall to a hundredth of their radius", function()
  for _, s in ipairs(shots) do
    if math.abs(s.handle:position().x - s.home - radius) > 0.01 * radius then return false end
  end
  return true
end)
