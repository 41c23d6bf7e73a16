-- A hundred times as heavy as each of those that carry it.
scenario {
  title = "Pyramid with a heavy top, 100 to 1", duration = 8,
  rate = 60, fps = 60, gravity = {0, -10}, method = { substeps = 4 },
  description = "A box a hundred times as heavy falls on a pyramid: PEEL says of it that it needs more iterations.",
  view = { center = {0, 10.6}, height = 24 }, layers = { "bodies", "contacts" },
  golden = { frames = { 479 }, size = {480, 270} },
}
include "include/gates.lua"
include "include/topped_pyramid.lua"

topped_pyramid(100)
