-- Solver2D's stack (E. Catto, 2024): a hundredth of a metre to the left, a hundredth to the right, and so on.
scenario {
  title = "Fifteen boxes", duration = 20, rate = 60, fps = 60, gravity = {0, -10}, method = { substeps = 4 },
  description = "A staggered stack that has to stand without sleeping: a sweep hands the load down by one contact.",
  view = { center = {0, 7.8}, height = 17 }, layers = { "bodies", "contacts" },
  golden = { frames = { 1199 }, size = {480, 270} },
}
include "include/gates.lua"
include "include/stacking.lua"

stack_of(15, 0.01)
