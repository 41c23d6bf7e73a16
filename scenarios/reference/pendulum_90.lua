-- A large swing, and the trap in it: the angle of a drift-kick-drift verlet converges by the fourth order here, the
-- velocity by the second, so that no order may be asserted (60 degrees has none of this). Jacobi's sn, as there.
scenario {
  title = "Pendulum from 90 degrees", duration = 10, view = { center = {0, -0.4}, height = 1.7 },
  description = "A point mass let go level with its pivot; at the bottom the rod bears three times its weight.",
  layers = { "bodies", "joints", "trails", "vectors" }, golden = { frames = { 0, 35, 599 }, size = {480, 270} },
}
include "include/pendulum.lua"

local swing = swinging_point(90)
expect("its period is 2.36784194758 s", function() return math.abs(swing.period - 2.36784194757623745) <= 1e-12 end)
expect("after 10 s it is where Jacobi says, to 0.5 mm", function() return swing.off() <= 5e-4 end)
expect("the energy stays within 5e-5 m g l", function() return swing.energy_off() <= 5e-5 end, { always = true })
expect("at the bottom the rod bears three times the weight, to a thousandth", function()
  local pull = swing.rod:reaction()
  return math.abs(math.sqrt(pull.x ^ 2 + pull.y ^ 2) / 9.81 - 3) <= 1e-3
end, { at = swing.period / 4 })
