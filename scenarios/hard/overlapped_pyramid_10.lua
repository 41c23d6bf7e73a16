-- Fifty-five boxes at once; 3 m/s is the speed to which Box2D limits what it pushes apart.
scenario {
  title = "Fifty-five boxes that overlap", duration = 8,
  rate = 60, fps = 60, gravity = {0, -10}, method = { substeps = 4 },
  description = "Ten rows whose boxes overlap by a quarter, as in Box2D's samples: they have to part gently.",
  view = { center = {0, 5}, height = 11.5 }, layers = { "bodies", "contacts" },
  golden = { frames = { 0, 479 }, size = {480, 270} },
}
include "include/gates.lua"
include "include/overlapped.lua"

local boxes = overlapped_pyramid(10, 3)
no_overlap(1, 6)
