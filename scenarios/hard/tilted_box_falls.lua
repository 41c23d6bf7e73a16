scenario {
  title = "A box that just tips", duration = 5, rate = 60, fps = 60, gravity = {0, -10}, method = { substeps = 4 },
  description = "A tall box on a slope 1 percent above the angle at which it tips: what drags its feet holds it up.",
  view = { center = {0, 0.2}, height = 2.8 }, layers = { "bodies", "contacts" },
  golden = { frames = { 299 }, size = {480, 270} },
}
include "include/gates.lua"
include "include/tilted_box.lua"

local turned, moved = tilted_box(1.01)
expect("it falls: it has turned over by a quarter",
       function() return turned() >= math.rad(80) and turned() <= math.rad(100) end)
expect("it tips over its corner and does not slide away", function() return moved() <= 1.2 end)
