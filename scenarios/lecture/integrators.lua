-- Six integrators on one pendulum, 30 steps a second, as phase portraits.
scenario {
  title = "Six integrators: phase portraits",
  description = "The same pendulum by six methods, 30 steps a second: its speed against its angle, turn after turn.",
  duration = 20, rate = 30, fps = 30, method = { substeps = 1 },
  view = { center = {2.15, 0}, height = 3.8 }, layers = { "bodies", "joints" }, golden = { frames = {0, 60, 300, 599}, size = {960, 540} },
}
include "include/six_pendulums.lua"

plot { title = "Speed against angle", unit = "rad/s", x = { phi = swing.phi }, x_unit = "rad", y = { omega = swing.omega }, seconds = 20 }
section { at = 0, name = "One swing" }
section { at = 6, name = "Many swings" }
caption { text = "One pendulum, six integrators, a step of 33 ms: a swing is a closed curve", from = 0, to = 6 }
caption { text = "Curves that stay closed keep their energy; that of symplectic Euler is a little tilted", from = 6 }

measure("energy off", swing.off)
local limits = { symplectic_euler = 0.1, verlet = 5e-3, implicit_midpoint = 1e-2, rk4 = 1e-3, suzuki4 = 1e-3, gauss_legendre6 = 1e-6 }
expect("the energy is off by less than " .. limits[swing.method], function() return math.abs(swing.off()) < limits[swing.method] end, { always = true })
