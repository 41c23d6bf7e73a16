scenario {
  title = "Bricks over the edge, just falling", duration = 6,
  rate = 60, fps = 60, gravity = {0, -10}, method = { substeps = 4 },
  description = "Four bricks reach 1 percent further over the edge of the table than they may.",
  view = { center = {-0.1, 0.15}, height = 1.9 }, layers = { "bodies", "contacts" },
  golden = { frames = { 0, 60 }, size = {480, 270} },
}
include "include/gates.lua"
include "include/overhang.lua"

local _, sunk = overhanging(1.01)
expect("it falls: the top brick is below the table", function() return sunk() >= 1 end)
