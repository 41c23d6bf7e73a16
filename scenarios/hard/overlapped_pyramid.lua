-- Of Solver2D's own solvers PGS, Sticky and XPBD throw this one apart.
scenario {
  title = "Ten boxes that overlap", duration = 6, rate = 60, fps = 60, gravity = {0, -10}, method = { substeps = 4 },
  description = "A pyramid whose boxes overlap by a quarter: corrections by velocity throw it apart.",
  view = { center = {0, 2}, height = 4.8 }, layers = { "bodies", "contacts" },
  golden = { frames = { 0, 359 }, size = {480, 270} },
}
include "include/gates.lua"
include "include/overlapped.lua"

local boxes = overlapped_pyramid(4, 5)
no_overlap(1, 4)
