-- Rigid boxes that lie flat on each other cannot buckle, however many there are; springs between them can.
scenario {
  title = "Eighty boxes", duration = 20, rate = 60, fps = 60, gravity = {0, -10}, method = { substeps = 4 },
  description = "A straight column of eighty boxes (Rapier's debug_vertical_column2): soft contacts let it buckle.",
  view = { center = {0, 41}, height = 88 }, layers = { "bodies" },
  golden = { frames = { 1199 }, size = {480, 270} },
}
include "include/gates.lua"
include "include/stacking.lua"

stack_of(80, 0)
