scenario {
  title = "A box that just does not tip", duration = 5,
  rate = 60, fps = 60, gravity = {0, -10}, method = { substeps = 4 },
  description = "A tall box on a slope 1 percent below the angle at which it tips: one corner carries nearly all.",
  view = { center = {0, 0.2}, height = 2.8 }, layers = { "bodies", "contacts" },
  golden = { frames = { 299 }, size = {480, 270} },
}
include "include/gates.lua"
include "include/tilted_box.lua"

local turned, moved, away = tilted_box(0.99)
expect("it stands: it never turns by as much as it lacks to tipping", function() return math.abs(turned()) < away() end,
       { always = true })
expect("it stands: in the end it has moved by less than a millimetre", function() return moved() <= 1e-3 end)
expect("quality: it never turns by a thousandth", function() return math.abs(turned()) <= 1e-3 end, { always = true })
no_overlap(0.5, 0.5)
