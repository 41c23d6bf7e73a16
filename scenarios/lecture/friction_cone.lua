-- Thesis chapter 3.4, friction: the force on a block tilts, inside and outside of the cone of friction.
scenario {
  title = "Friction cone", description = "Static friction holds inside the cone; outside, kinetic friction brakes.",
  golden = { frames = { 540, 1040, 1571, 2602, 3100 }, size = { 960, 540 } },
}

demonstrate {
  algorithm = "friction_cone",
  shapes = { box { width = 1.6, height = 0.8, friction = { static = 0.6, kinetic = 0.4 } } },
}
