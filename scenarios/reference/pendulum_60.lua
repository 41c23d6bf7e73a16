-- The order of an integrator with one rigid joint: this is the angle to assert it at (see pendulum_90).
-- Jacobi's sn by the arithmetic-geometric mean (C. G. J. Jacobi 1829; E. T. Whittaker 1904).
scenario {
  title = "Pendulum from 60 degrees", duration = 10, view = { center = {0, -0.45}, height = 1.6 },
  description = "A point mass on a rod, beside the exact solution of the large swing.",
  layers = { "bodies", "joints", "trails", "vectors" }, golden = { frames = { 0, 33, 599 }, size = {480, 270} },
}
include "include/pendulum.lua"

local swing = swinging_point(60)
expect("its period is 2.15287466688 s", function() return math.abs(swing.period - 2.15287466688051570) <= 1e-12 end)
expect("after 10 s it is where Jacobi says, to 0.3 mm", function() return swing.off() <= 3e-4 end)
expect("the energy stays within 2e-5 m g l", function() return swing.energy_off() <= 2e-5 end, { always = true })
