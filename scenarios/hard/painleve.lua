-- Painleve's paradox (1895) on a uniform rod. With friction above 4/3 there are angles where no finite force keeps the
-- sliding tip out of the ground: tan^2 - 3 mu tan + 4 < 0, here from 55.6 to 70.0 degrees. Only an impulse can.
scenario {
  title = "Painleve's rod", duration = 3, rate = 60, fps = 60, gravity = {0, -10}, method = { substeps = 4 },
  description = "A rod is pushed tip first over a rough floor: no finite force obeys Coulomb there, it must jam.",
  view = { center = {-0.2, 0.6}, height = 1.5 }, layers = { "bodies", "contacts" },
  golden = { frames = { 0, 12, 179 }, size = {480, 270} },
}
include "include/gates.lua"

local mu, tilt, speed, length, thin = 1.4, math.rad(60), 3, 1, 0.01
local tangent = math.tan(tilt)
assert(tangent^2 - 3 * mu * tangent + 4 < 0, "not a paradoxical angle")
ground { y = 0, friction = mu }
-- It leans to the right and goes to the left. Its lowest corner touches the ground.
local lowest = -length / 2 * math.sin(tilt) - thin / 2 * math.cos(tilt)
local rod = body { name = "rod", at = {0, -lowest}, angle = tilt, velocity = {-speed, 0}, friction = mu,
                   shape = box { width = length, height = thin } }
local m = rod:mass()

local most_impulse = 0
on_contact(rod, nil, function(c) most_impulse = math.max(most_impulse, c.impulse) end)
measure("largest impulse", function() return most_impulse end)
local function kinetic() return energy().kinetic end
measure("kinetic energy", kinetic)
measure("spin", function() return rod:spin() end)

-- What it can lose is what it has: no impulse is larger than what stops the rod and throws it back.
expect("the impulse is finite: no more than twice the rod's momentum",
       function() return most_impulse <= 2 * m * speed end, { always = true })
local first = kinetic()
expect("the impact takes energy and gives none", function()
  return time() > 0.05 or kinetic() <= first * (1 + 1e-9) + m * 10 * 0.01
end, { always = true })
expect("it jams: the tip stops and the rod turns over it", function() return rod:spin() >= 1 end, { at = 0.1 })
expect("the floor holds: no corner is deeper than half its thickness", function()
  for _, c in ipairs(contacts(rod)) do if c.separation < -thin / 2 then return false end end
  return true
end, { always = true })
expect("in the end it lies flat", function()
  local p = rod:position()
  return math.abs(p.y - thin / 2) <= 0.1 * thin
end)
no_energy_gained({ rod }, length / 2)
