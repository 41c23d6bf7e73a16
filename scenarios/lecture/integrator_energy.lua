-- Six integrators on one pendulum, 30 steps a second, and what becomes of its energy.
scenario {
  title = "Six integrators: energy",
  description = "The same pendulum by six methods, 30 steps a second: symplectic ones let the energy ripple, rk4 loses it.",
  duration = 20, rate = 30, fps = 30, method = { substeps = 1 },
  view = { center = {2.15, 0}, height = 3.8 }, layers = { "bodies", "joints" }, golden = { frames = {0, 60, 300, 599}, size = {960, 540} },
}
include "include/six_pendulums.lua"

plot { title = "Energy off, parts of 2 m g l", y = { energy = swing.off }, seconds = 20 }
section { at = 0, name = "One swing" }
section { at = 6, name = "Ripple or drift" }
caption { text = "How far the energy is off, every method at a scale of its own", from = 0, to = 6 }
caption { text = "Symplectic methods let it ripple about its value; rk4 loses a little in every swing", from = 6 }

measure("energy off", swing.off)
if swing.method == "rk4" then
  expect("rk4 has lost energy", function() return swing.off() < -1e-5 end)
end
