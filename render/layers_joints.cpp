#include <algorithm>

#include "render/draw_layers.h"

namespace proofreel {
namespace {

double line_px(const Stage& stage) { return std::max(1.5, 2.5 * stage.sizes.unit); }

/// A ring, filled where it is nailed to the world.
void draw_pivot(const Stage& stage, Vec2d at, bool in_world) {
  const double radius = std::max(2.5, 5.5 * stage.sizes.unit);
  const Color inside = in_world ? stage.palette.joint : stage.palette.background;
  stage.canvas.disc(at, radius, {inside, stage.palette.joint, std::max(1.25, 2 * stage.sizes.unit)});
}

/// A small solid end of a rod or spring.
void draw_end(const Stage& stage, Vec2d at) {
  stage.canvas.disc(at, std::max(2.0, 3.5 * stage.sizes.unit), {stage.palette.joint, stage.palette.joint, 0});
}

/// Which body a pivot turns: a line from its centre, so that a bob far from its pivot hangs on something.
void draw_lever(const Stage& stage, BodyId id, Vec2d pivot) {
  const BodyView* body = find_body(stage.frame.snapshot, id);
  if (body == nullptr || body->type == BodyType::fixed) return;
  Color color = stage.palette.joint;
  color.a = 150;
  stage.canvas.line(pivot, stage.camera.to_px(body->state.center), 0.6 * line_px(stage), color);
}

void draw_revolute(const Stage& stage, const JointView& joint, Vec2d a, Vec2d b) {
  draw_lever(stage, joint.a, a);
  draw_lever(stage, joint.b, b);
  if (distance(a, b) > 1) stage.canvas.line(a, b, line_px(stage), stage.palette.contact);  // torn open
  draw_pivot(stage, 0.5 * (a + b), joint.a == BodyId::world || joint.b == BodyId::world);
}

void draw_rod(const Stage& stage, const JointView& joint, Vec2d a, Vec2d b) {
  stage.canvas.line(a, b, line_px(stage), stage.palette.joint);
  for (const auto& [id, at] : {std::pair{joint.a, a}, std::pair{joint.b, b}}) {
    if (id == BodyId::world) {
      draw_pivot(stage, at, true);
    } else {
      draw_end(stage, at);
    }
  }
}

/// Always as many coils, so that stretching shows as coils further apart.
void draw_spring(const Stage& stage, Vec2d a, Vec2d b) {
  constexpr int half_coils = 16;
  constexpr double straight = 0.12;  // of the length, at either end
  const double swing = std::max(3.0, 8 * stage.sizes.unit);
  const Vec2d side = swing * perp(normalized(b - a));
  std::vector<Vec2d> points{a, lerp(a, b, straight)};
  for (int i = 0; i < half_coils; ++i) {
    const double part = straight + (1 - 2 * straight) * (i + 0.5) / half_coils;
    points.push_back(lerp(a, b, part) + (i % 2 == 0 ? 1.0 : -1.0) * side);
  }
  points.push_back(lerp(a, b, 1 - straight));
  points.push_back(b);
  stage.canvas.stroke(points, 0.8 * line_px(stage), stage.palette.joint, stage.palette.joint);
  draw_end(stage, a);
  draw_end(stage, b);
}

}  // namespace

void draw_joints(const Stage& stage) {
  for (const JointView& joint : stage.frame.snapshot.joints) {
    const Vec2d a = stage.camera.to_px(joint.anchor_a);
    const Vec2d b = stage.camera.to_px(joint.anchor_b);
    switch (joint.kind) {
      case JointKind::revolute:
        draw_revolute(stage, joint, a, b);
        break;
      case JointKind::distance:
        draw_rod(stage, joint, a, b);
        break;
      case JointKind::spring:
        draw_spring(stage, a, b);
        break;
    }
  }
}

}  // namespace proofreel
