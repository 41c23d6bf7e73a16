#include <algorithm>

#include "render/draw_layers.h"

namespace proofreel {
namespace {

/// The trail in pixels, without points so close that they would cost time and show nothing.
std::vector<Vec2d> thinned(const Stage& stage, const std::vector<Vec2d>& points) {
  constexpr double apart_px = 1.5;
  std::vector<Vec2d> kept;
  for (const Vec2d point : points) {
    const Vec2d at = stage.camera.to_px(point);
    if (kept.empty() || distance(kept.back(), at) >= apart_px) kept.push_back(at);
  }
  if (kept.size() > 1) kept.back() = stage.camera.to_px(points.back());
  return kept;
}

Color trail_color(const Stage& stage, BodyId id) {
  const BodyView* body = find_body(stage.frame.snapshot, id);
  if (body == nullptr) return stage.palette.dynamic.outline;
  const Tone tone = tone_of(stage.palette, *body);
  return mixed(tone.fill, tone.outline, 0.4);
}

}  // namespace

void draw_trails(const Stage& stage) {
  for (const TrailView& trail : stage.frame.trails) {
    const std::vector<Vec2d> points = thinned(stage, trail.points);
    Color from = trail_color(stage, trail.body);
    Color to = from;
    from.a = 0;
    stage.own(OwnerKind::trail, trail.body);
    to.a = 230;
    stage.canvas.stroke(points, std::max(2.0, 4 * stage.sizes.unit), from, to);
  }
}

void draw_vectors(const Stage& stage) {
  const double width = std::max(2.0, 4 * stage.sizes.unit);
  for (const ArrowView& arrow : stage.frame.arrows) {
    const Color color = stage.palette.vectors[static_cast<std::size_t>(arrow.of)];
    stage.own(OwnerKind::vector, arrow.body);
    stage.canvas.arrow(stage.camera.to_px(arrow.from), stage.camera.to_px(arrow.to), width, color);
  }
}

}  // namespace proofreel
