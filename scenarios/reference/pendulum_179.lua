-- From nearly upright: what an integrator errs by at first grows e^(omega t) while the pendulum hesitates.
-- Jacobi's sn with the complementary modulus given, since k = sin 89.5 degrees leaves few digits of 1 - k^2.
scenario {
  title = "Pendulum from 179 degrees", duration = 10, view = { center = {0, 0}, height = 2.6 },
  description = "Let go one degree beside the unstable equilibrium: a period takes 7.8 s.",
  layers = { "bodies", "joints", "trails", "vectors" }, golden = { frames = { 0, 117, 599 }, size = {480, 270} },
}
include "include/pendulum.lua"

local swing = swinging_point(179)
expect("its period is 7.82579683754 s", function() return math.abs(swing.period - 7.82579683753768270) <= 1e-12 end)
expect("after 10 s it is where Jacobi says, to 0.5 mm", function() return swing.off() <= 5e-4 end)
expect("the energy stays within 1e-4 m g l", function() return swing.energy_off() <= 1e-4 end, { always = true })
