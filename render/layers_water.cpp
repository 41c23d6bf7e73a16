#include <algorithm>

#include "render/draw_layers.h"

namespace proofreel {

void draw_water(const Stage& stage) {
  if (!stage.frame.snapshot.water_level) return;
  stage.own(OwnerKind::water);
  const Aabbd picture = stage.picture();
  const double surface = stage.camera.to_px({0, *stage.frame.snapshot.water_level}).y;
  if (surface >= picture.upper.y) return;
  const Vec2d corner{0, std::max(surface, 0.0)};
  stage.canvas.rectangle(corner, picture.upper, 0, {stage.palette.water, stage.palette.water, 0});
}

void draw_water_line(const Stage& stage) {
  if (!stage.frame.snapshot.water_level) return;
  stage.own(OwnerKind::water);
  const Aabbd picture = stage.picture();
  const double surface = stage.camera.to_px({0, *stage.frame.snapshot.water_level}).y;
  if (surface < 0 || surface >= picture.upper.y) return;
  const Color line = stage.palette.water_line;
  stage.canvas.rectangle({0, surface}, {picture.upper.x, surface + stage.sizes.outline}, 0, {line, line, 0});
}

}  // namespace proofreel
