#include <algorithm>

#include "render/draw_layers.h"

namespace proofreel {
namespace {

/// An axis-aligned box of the world as a thin frame.
void draw_frame_of(const Stage& stage, const Aabbd& box, double width_px, Color color) {
  const Vec2d a = stage.camera.to_px(box.lower);
  const Vec2d b = stage.camera.to_px(box.upper);
  const Color none{color.r, color.g, color.b, 0};
  stage.canvas.rectangle({a.x, b.y}, {b.x, a.y}, 0, {none, color, width_px});
}

/// N s that a resting body hands down in one tick, about: what contact impulses are measured against, so that arrows
/// neither flicker with the largest impulse of the moment nor depend on the scene's units.
double usual_impulse(const Snapshot& snapshot) {
  constexpr double gravity = 10;
  double mass = 0;
  int count = 0;
  for (const BodyView& body : snapshot.bodies) {
    if (body.state.mass <= 0) continue;
    mass += body.state.mass;
    ++count;
  }
  if (count == 0 || snapshot.tick <= 0) return 0;
  return mass / count * gravity * snapshot.time / static_cast<double>(snapshot.tick);
}

/// Marks shrink when there are many, so that thousands stay readable.
double crowding(const std::vector<ContactView>& contacts) {
  constexpr double roomy = 300;
  return std::clamp(std::sqrt(roomy / static_cast<double>(contacts.size() + 1)), 0.35, 1.0);
}

struct ContactMarks {
  double dot_px;
  double normal_px;   ///< length of a normal without impulse
  double impulse_px;  ///< length that no impulse exceeds
  double width_px;
  double usual;  ///< N s drawn at half that length
};

void draw_contact_point(const Stage& stage, const ContactMarks& marks, Vec2d normal, const ContactPoint& contact) {
  const Color color = stage.palette.contact;
  const Vec2d point = stage.camera.to_px(contact.point);
  const double impulse = std::max(contact.normal_impulse, 0.0);
  const double share = impulse > 0 ? impulse / (impulse + marks.usual) : 0;
  const Vec2d along{normal.x, -normal.y};
  stage.canvas.line(point - marks.normal_px * along, point + marks.normal_px * along, 0.5 * marks.width_px, color);
  if (share * marks.impulse_px > marks.normal_px) {
    stage.canvas.arrow(point, point + share * marks.impulse_px * along, marks.width_px, color);
  }
  stage.canvas.disc(point, marks.dot_px, {color, stage.palette.background, 0.35 * marks.dot_px});
}

}  // namespace

void draw_tree(const Stage& stage) {
  stage.own(OwnerKind::bvh);
  for (const TreeBoxView& node : stage.frame.snapshot.tree) {
    Color color = stage.palette.tree;
    color.a = static_cast<std::uint8_t>(std::max(60, 255 - 28 * node.depth));
    draw_frame_of(stage, node.box, stage.sizes.thin, color);
  }
}

void draw_boxes(const Stage& stage) {
  stage.own(OwnerKind::aabbs);
  for (const Aabbd& box : stage.frame.snapshot.aabbs) {
    draw_frame_of(stage, box, stage.sizes.thin, stage.palette.box);
  }
}

void draw_contacts(const Stage& stage) {
  const Snapshot& snapshot = stage.frame.snapshot;
  const double scale = crowding(snapshot.contacts) * std::max(stage.sizes.unit, 0.6);
  const ContactMarks marks{4.5 * scale, 9 * scale, 46 * scale, 3 * scale, usual_impulse(snapshot)};
  for (const ContactView& contact : snapshot.contacts) {
    stage.own(OwnerKind::contact, contact.a, contact.b);
    for (int i = 0; i < contact.point_count; ++i) {
      if (contact.points[i].touching()) draw_contact_point(stage, marks, contact.normal, contact.points[i]);
    }
  }
}

}  // namespace proofreel
