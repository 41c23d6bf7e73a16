-- Solver2D's HighMassRatio2 (E. Catto, 2024): 400 tons for every ton that carries them, after a fall of 15 m.
scenario {
  title = "Four hundred on one", duration = 10, rate = 60, fps = 60, gravity = {0, -10}, method = { substeps = 4 },
  description = "A 20 m box falls on two boxes of 1 m: sweeps that pass on impulses pair by pair crush the small ones.",
  view = { center = {0, 16.5}, height = 40 }, layers = { "bodies", "contacts" },
  golden = { frames = { 0, 599 }, size = {480, 270} },
}
include "include/gates.lua"
include "include/heavy.lua"

heavy_box_on(box { width = 1, height = 1, at = {0, 0.5} }, 15)
