-- Box2D's HighMassRatio3: the same box on the tips of two triangles, each an eight-hundredth of its mass.
scenario {
  title = "Eight hundred on two tips", duration = 8, rate = 60, fps = 60, gravity = {0, -10}, method = { substeps = 4 },
  description = "A 20 m box falls on the tips of two triangles of 1 m: one point of contact carries it on either side.",
  view = { center = {0, 12.5}, height = 29 }, layers = { "bodies", "contacts" },
  golden = { frames = { 0, 479 }, size = {480, 270} },
}
include "include/gates.lua"
include "include/heavy.lua"

heavy_box_on(polygon { {-0.5, 0}, {0.5, 0}, {0, 1} }, 3)
