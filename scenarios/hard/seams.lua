-- A box slides over thirty seams of ground boxes that lie flush: a smooth floor, if the seams are none.
local speed, mu, g, pieces = 12, 0.25, 10, 30
local way = speed ^ 2 / (2 * mu * g)   -- Coulomb: it brakes at mu g

scenario {
  title = "Thirty flat seams",
  description = "Ground boxes side by side: who takes each by itself trips at the seams; the way is v^2 / (2 mu g).",
  duration = 6, rate = 60, fps = 60, gravity = {0, -10}, method = { substeps = 4 }, effects = "auto",
  view = { center = {0, 1}, height = 4 }, layers = { "bodies", "contacts" },
  golden = { frames = { 359 }, size = {480, 270} },
}
include "include/gates.lua"

for i = 0, pieces + 2 do
  body { name = "piece " .. i, type = "static", at = { i - 1.5, -0.5 }, shape = box { width = 1, height = 1 },
         friction = mu }
end
local slider = body { name = "slider", at = {0, 0.25}, velocity = { speed, 0 }, friction = mu,
                      shape = box { width = 0.8, height = 0.5 } }
camera { follow = slider }

no_overlap(0.5, 0.25)
no_energy_gained({ slider }, speed ^ 2 / (2 * g))
measure("x", function() return slider:position().x end)
reference("x", function(t) local s = math.min(t, speed / (mu * g)) return speed * s - mu * g * s * s / 2 end)
measure("height", function() return slider:position().y - 0.25 end)
expect("it goes as far as on one smooth floor, to 5 percent", function()
  return math.abs(slider:position().x / way - 1) < 0.05
end)
expect("quality: to half a percent", function() return math.abs(slider:position().x / way - 1) < 0.005 end)
expect("it neither trips nor hops", function()
  return math.abs(slider:angle()) < 0.01 and math.abs(slider:position().y - 0.25) < 0.005
end, { always = true })
