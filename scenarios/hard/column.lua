-- Twice as high as the stack of fifteen: four times as far for the news of the ground to travel up by sweeps.
scenario {
  title = "Thirty boxes", duration = 20, rate = 60, fps = 60, gravity = {0, -10}, method = { substeps = 4 },
  description = "A staggered column of thirty boxes: sweeps and soft contacts let it buckle.",
  view = { center = {0, 15.4}, height = 33 }, layers = { "bodies", "contacts" },
  golden = { frames = { 1199 }, size = {480, 270} },
}
include "include/gates.lua"
include "include/stacking.lua"

stack_of(30, 0.01)
