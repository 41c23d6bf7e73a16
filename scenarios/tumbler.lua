-- A drum turns; what is inside climbs, slides and tumbles for ever.
scenario {
  title = "Tumbler", duration = 8, seed = 3, view = { center = {0, 0}, height = 6.6 },
  description = "Two hundred small bodies in a slowly turning drum.",
  golden = { frames = { 0, 120, 479 } }, layers = { "bodies" },
}

local sides, radius, thick = 12, 2.9, 0.16
local walls = {}
for i = 1, sides do
  local a = (i - 0.5) * 2 * math.pi / sides
  walls[i] = box { width = 2 * (radius + thick) * math.tan(math.pi / sides), height = thick,
                   at = { (radius + thick / 2) * math.sin(a), -(radius + thick / 2) * math.cos(a) }, angle = a }
end
for i = 1, 3 do
  local a = i * 2 * math.pi / 3
  walls[#walls + 1] = box { width = 0.12, height = 0.7, at = { (radius - 0.3) * math.sin(a), -(radius - 0.3) * math.cos(a) }, angle = a }
end
body { name = "drum", type = "kinematic", spin = 0.8, shapes = walls, friction = 0.6 }

local all = {}
for i = 1, 200 do
  local at = { ((i - 1) % 16 - 7.5) * 0.25, math.floor((i - 1) / 16) * 0.25 - 1.3 }
  local shape = i % 3 == 0 and circle { radius = 0.11 } or regular { sides = math.random(3, 6), radius = 0.12 }
  all[i] = body { name = "grain " .. i, at = at, angle = 6 * math.random(), shape = shape, friction = 0.5 }
end
expect("nothing leaves the drum", function()
  for _, b in ipairs(all) do
    local p = b:position()
    if p.x^2 + p.y^2 > (radius + 0.3)^2 then return false end
  end
  return true
end, { always = true })
