-- Momentum and energy together leave only one answer: as many balls out as went in.
scenario {
  title = "Newton's cradle: two in, two out", duration = 6, rate = 960, view = { center = {0, 0.8}, height = 3.4 },
  description = "Elastic impacts handed on pair by pair along a row of five balls.",
  effects = { "gravity", "joints", "contacts", "restitution" },
  layers = { "bodies", "joints", "trails", "clock" }, golden = { frames = { 0, 44, 50, 90 } },
}

local n, radius, rod = 5, 0.2, 2
local lifted = math.rad(35)
local balls = {}
for i = 1, n do
  local pivot = { (i - (n + 1) / 2) * 2 * radius, rod }
  local swing = i <= 2 and lifted or 0
  local at = { pivot[1] - rod * math.sin(swing), pivot[2] - rod * math.cos(swing) }
  balls[i] = body { name = "ball " .. i, at = at, density = 20, restitution = 1, friction = 0, shape = circle { radius = radius } }
  distance { world, balls[i], from = pivot, to = at, length = rod }
end
trail { body = balls[1], seconds = 0.4 }
trail { body = balls[n], seconds = 0.4 }

local total = energy().total
measure("energy lost", function() return total - energy().total end)
local met
on_contact(balls[2], balls[3], function() met = met or time() end)
expect("after the first impact the first three balls hang still", function()
  if not met or time() < met + 0.01 or time() > met + 0.05 then return true end
  for i = 1, 3 do
    local v = balls[i]:velocity()
    if math.sqrt(v.x^2 + v.y^2) > 0.02 then return false end
  end
  return balls[4]:velocity().x > 1 and balls[5]:velocity().x > 1
end, { always = true })
expect("less than a thousandth of the energy is lost", function() return total - energy().total < 1e-3 * total end,
       { finally = true })

caption { text = "Two in, two out", from = 0, to = 2.2 }
slow { from = 0.65, to = 0.95, factor = 0.25 }
