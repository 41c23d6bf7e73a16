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

/// A pivot where the world holds it, else a dot.
void draw_held_end(const Stage& stage, BodyId body, Vec2d at) {
  if (body == BodyId::world) {
    draw_pivot(stage, at, true);
  } else {
    draw_end(stage, at);
  }
}

void draw_rod(const Stage& stage, const JointView& joint, Vec2d a, Vec2d b) {
  stage.canvas.line(a, b, line_px(stage), stage.palette.joint);
  draw_held_end(stage, joint.a, a);
  draw_held_end(stage, joint.b, b);
}

/// Always as many coils, so that stretching shows as coils further apart.
void draw_spring(const Stage& stage, Vec2d a, Vec2d b, int half_coils = 16) {
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

/// The axis of a prismatic joint or a wheel in the picture, whose y points down.
Vec2d axis_px(const JointView& joint) { return {joint.axis.x, -joint.axis.y}; }

double reach_px(const Stage& stage) { return std::max(10.0, 26 * stage.sizes.unit); }

/// A rail as long as the slider's way so far and a little more, with an end at either side.
void draw_rail(const Stage& stage, const JointView& joint, Vec2d a, Vec2d b) {
  const Vec2d axis = axis_px(joint);
  const double along = dot(b - a, axis);
  const Vec2d from = a + (std::min(0.0, along) - reach_px(stage)) * axis;
  const Vec2d to = a + (std::max(0.0, along) + reach_px(stage)) * axis;
  const Vec2d side = 0.3 * reach_px(stage) * perp(axis);
  const double width = 0.8 * line_px(stage);
  stage.canvas.line(from, to, width, stage.palette.joint);
  for (const Vec2d end : {from, to}) stage.canvas.line(end - side, end + side, width, stage.palette.joint);
  // The shoe that slides: two short lines beside the rail.
  const Vec2d half = 0.45 * reach_px(stage) * axis;
  for (const double sign : {-1.0, 1.0}) {
    const Vec2d beside = b + 0.7 * sign * side;
    stage.canvas.line(beside - half, beside + half, line_px(stage), stage.palette.joint);
  }
}

/// A seam across the line between what is welded.
void draw_weld(const Stage& stage, Vec2d at) {
  const double arm = std::max(3.0, 6 * stage.sizes.unit);
  for (const double sign : {-1.0, 1.0}) {
    stage.canvas.line(at - Vec2d{arm, sign * arm}, at + Vec2d{arm, sign * arm}, line_px(stage), stage.palette.joint);
  }
}

/// The suspension from as high as the middle of the chassis down to the wheel, and the wheel's pin.
void draw_wheel(const Stage& stage, const JointView& joint, Vec2d a, Vec2d b) {
  const Vec2d axis = axis_px(joint);
  const BodyView* chassis = find_body(stage.frame.snapshot, joint.a);
  const Vec2d middle = chassis != nullptr ? stage.camera.to_px(chassis->state.center) : a;
  draw_spring(stage, a + dot(middle - a, axis) * axis, b, 7);
  draw_pivot(stage, b, false);
}

/// A parabola from a to b that hangs `sag` pixels below the line between them.
std::vector<Vec2d> hanging(Vec2d a, Vec2d b, double sag) {
  constexpr int parts = 24;
  std::vector<Vec2d> points;
  for (int i = 0; i <= parts; ++i) {
    const double t = static_cast<double>(i) / parts;
    points.push_back(lerp(a, b, t) + Vec2d{0, 4 * t * (1 - t) * sag});
  }
  return points;
}

double length_of(const std::vector<Vec2d>& points) {
  double sum = 0;
  for (std::size_t i = 1; i < points.size(); ++i) sum += distance(points[i - 1], points[i]);
  return sum;
}

/// A rope keeps its length, so the sag is found by bisection.
void draw_rope(const Stage& stage, const JointView& joint, Vec2d a, Vec2d b) {
  const double whole = stage.camera.px(joint.length);
  double least = 0;
  double most = whole;
  for (int i = 0; i < 20; ++i) {
    const double middle = 0.5 * (least + most);
    (length_of(hanging(a, b, middle)) < whole ? least : most) = middle;
  }
  stage.canvas.stroke(hanging(a, b, least), 0.8 * line_px(stage), stage.palette.joint, stage.palette.joint);
  draw_held_end(stage, joint.a, a);
  draw_held_end(stage, joint.b, b);
}

void draw_pulley(const Stage& stage, const JointView& joint, Vec2d a, Vec2d b) {
  const Vec2d pin_a = stage.camera.to_px(joint.pin_a);
  const Vec2d pin_b = stage.camera.to_px(joint.pin_b);
  const std::vector<Vec2d> rope{a, pin_a, pin_b, b};
  stage.canvas.stroke(rope, 0.8 * line_px(stage), stage.palette.joint, stage.palette.joint);
  for (const Vec2d pin : {pin_a, pin_b}) draw_pivot(stage, pin, true);
  for (const Vec2d end : {a, b}) draw_end(stage, end);
}

/// Teeth where two wheels of this ratio, which turn against each other, would meet. Wheels that turn the same way, by a
/// belt say, and rails meet nowhere: theirs are halfway, on a line from one to the other.
void draw_gear(const Stage& stage, const JointView& joint, Vec2d a, Vec2d b) {
  const bool meet = joint.ratio > 0;
  if (!meet) stage.canvas.line(a, b, 0.6 * line_px(stage), stage.palette.joint);
  const Vec2d along = normalized(b - a);
  const Vec2d row = meet ? perp(along) : along;
  const Vec2d middle = lerp(a, b, meet ? 1 / (1 + joint.ratio) : 0.5);
  const double pitch = std::max(3.0, 5 * stage.sizes.unit);
  for (int tooth = -2; tooth <= 2; ++tooth) {
    const Vec2d at = middle + tooth * pitch * row;
    const Vec2d side = (tooth % 2 == 0 ? 1.0 : -1.0) * pitch * perp(row);
    stage.canvas.line(at, at + side, 0.8 * line_px(stage), stage.palette.joint);
  }
}

/// A thin line to a target of cross hairs.
void draw_pull(const Stage& stage, Vec2d target, Vec2d at) {
  const double arm = std::max(5.0, 14 * stage.sizes.unit);
  const double width = 0.6 * line_px(stage);
  stage.canvas.line(at, target, width, stage.palette.joint);
  stage.canvas.line(target - Vec2d{arm, 0}, target + Vec2d{arm, 0}, width, stage.palette.joint);
  stage.canvas.line(target - Vec2d{0, arm}, target + Vec2d{0, arm}, width, stage.palette.joint);
  draw_end(stage, at);
}

/// Three quarters of a circle with an arrow head, at the centre of what is driven.
void draw_motor(const Stage& stage, const JointView& joint) {
  const BodyView* body = find_body(stage.frame.snapshot, joint.b);
  if (body == nullptr) return;
  const Vec2d center = stage.camera.to_px(body->state.center);
  const double radius = std::max(5.0, 10 * stage.sizes.unit);
  std::vector<Vec2d> points;
  for (int i = 0; i <= 18; ++i) {
    const Rotd turn(0.25 * i);
    points.push_back(center + radius * Vec2d{turn.c, -turn.s});
  }
  stage.canvas.stroke(points, 0.7 * line_px(stage), stage.palette.joint, stage.palette.joint);
  draw_end(stage, points.back());
}

}  // namespace

void draw_joints(const Stage& stage) {
  for (const JointView& joint : stage.frame.snapshot.joints) {
    const Vec2d a = stage.camera.to_px(joint.anchor_a);
    const Vec2d b = stage.camera.to_px(joint.anchor_b);
    stage.own(OwnerKind::joint, joint.a, joint.b);
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
      case JointKind::rope:
        draw_rope(stage, joint, a, b);
        break;
      case JointKind::prismatic:
        draw_rail(stage, joint, a, b);
        break;
      case JointKind::weld:
        draw_weld(stage, 0.5 * (a + b));
        break;
      case JointKind::wheel:
        draw_wheel(stage, joint, a, b);
        break;
      case JointKind::gear:
        draw_gear(stage, joint, a, b);
        break;
      case JointKind::pulley:
        draw_pulley(stage, joint, a, b);
        break;
      case JointKind::drag_to:
        draw_pull(stage, a, b);
        break;
      case JointKind::motor:
        draw_motor(stage, joint);
        break;
    }
  }
}

}  // namespace proofreel
