-- Four balls of different restitution: after n bounces e^(2 n) of the height is left.
scenario {
  title = "Four restitutions",
  description = "e = 0.3 to 0.95 from 2 m: contacts that act before they touch eat bounces, as users of Rapier saw.",
  duration = 6, rate = 60, fps = 60, gravity = {0, -10}, method = { substeps = 4 }, effects = "auto",
  view = { center = {0, 1.25}, height = 3.4 }, layers = { "bodies", "trails", "labels" },
  golden = { frames = { 359 }, size = {480, 270} },
}
include "include/gates.lua"

ground { y = 0 }
local radius, height, g = 0.2, 2, 10
local fall = math.sqrt(2 * height / g)
local balls = {}
for i, e in ipairs { 0.3, 0.5, 0.8, 0.95 } do
  local ball = body { name = ("e = %.2f"):format(e), at = { i - 2.5, height + radius }, restitution = e,
                      shape = circle { radius = radius } }
  balls[i] = ball
  label { body = ball, text = ("e = %.2f"):format(e) }
  trail { body = ball, seconds = 0.3 }
  measure(("height, e = %.2f"):format(e), function() return ball:position().y - radius end)
  -- The n-th apex comes after the fall and n whole bounces less the last half: fall (1 + 2 e + ... + 2 e^(n-1) + e^n).
  local t, left = fall, 1
  for n = 1, 2 do
    local rise = fall * e ^ n
    left = left * e * e
    local apex = left * height
    expect(("e = %.2f: apex %d is e^%d of the start, to 0.05"):format(e, n, 2 * n), function()
      return math.abs(ball:position().y - radius - apex) < 0.05 * height
    end, { at = t + rise })
    expect(("quality: e = %.2f: apex %d, to a millimetre"):format(e, n), function()
      return math.abs(ball:position().y - radius - apex) < 1e-3
    end, { at = t + rise })
    t = t + 2 * rise
  end
end

no_energy_gained(balls, height)
-- e = 0.3 bounces for fall (1 + e) / (1 - e) = 1.2 s in all.
expect("what bounces little has come to rest", function()
  return math.abs(balls[1]:velocity().y) < 1e-3 and math.abs(balls[1]:position().y - radius) < 1e-3
end, { at = 4 })
