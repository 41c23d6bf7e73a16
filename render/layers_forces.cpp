#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <string>

#include "render/draw_layers.h"
#include "render/draw_text.h"

namespace proofreel {
namespace {

enum class Force : std::uint8_t { normal, friction, joint };
constexpr std::array<const char*, 3> force_names{"normal", "friction", "joint"};

Color color_of(const Stage& stage, Force force) { return stage.palette.forces[static_cast<std::size_t>(force)]; }

/// Arrows are thinner where there are many.
double width_px(const Stage& stage, Force force) {
  constexpr double roomy = 60;
  const auto contacts = static_cast<double>(stage.frame.snapshot.contacts.size() + 1);
  const double crowding = std::clamp(std::sqrt(roomy / contacts), 0.4, 1.0);
  return (force == Force::friction ? 0.75 : 1) * std::max(1.5, 4 * crowding * stage.sizes.unit);
}

/// Arrows longer than this part of the picture's height are cut short and end in two heads.
constexpr double longest_part = 0.32;

/// `force` in N, world.
void draw_force(const Stage& stage, Vec2d at, Vec2d force, Force kind) {
  constexpr double least_px = 3;
  const double longest = longest_part * stage.picture().upper.y;
  const double whole = stage.camera.px(stage.frame.force_scale * length(force));
  if (!(whole >= least_px)) return;
  const Vec2d along = normalized(Vec2d{force.x, -force.y});
  const Vec2d from = stage.camera.to_px(at);
  const double width = width_px(stage, kind);
  const Vec2d to = from + std::min(whole, longest) * along;
  if (whole > longest) stage.canvas.arrow(from, to + 4 * width * along, width, color_of(stage, kind));
  stage.canvas.arrow(from, to, width, color_of(stage, kind));
}

/// Whether a contact's arrows show what acts on its body a: they are drawn on what can be moved, and of two such bodies
/// on the one that is pushed upwards, which the other carries.
bool acts_on_a(const Stage& stage, const ContactView& contact) {
  const auto is_moved = [&](BodyId id) {
    const BodyView* body = find_body(stage.frame.snapshot, id);
    return body != nullptr && body->type == BodyType::dynamic;
  };
  if (is_moved(contact.a) != is_moved(contact.b)) return is_moved(contact.a);
  constexpr double upwards = 0.1;
  return contact.normal.y < -upwards;
}

double seconds_per_tick(const Snapshot& snapshot) {
  return snapshot.tick > 0 ? snapshot.time / static_cast<double>(snapshot.tick) : 0;
}

void draw_contact_forces(const Stage& stage, const ContactView& contact, double dt) {
  const double side = (acts_on_a(stage, contact) ? -1 : 1) / dt;
  for (int i = 0; i < contact.point_count; ++i) {
    const ContactPoint& point = contact.points[i];
    if (!point.touching()) continue;
    draw_force(stage, point.point, side * point.tangent_impulse * perp(contact.normal), Force::friction);
    draw_force(stage, point.point, side * point.normal_impulse * contact.normal, Force::normal);
  }
}

/// What the joint does to b; to a where b cannot be moved.
void draw_reaction(const Stage& stage, const JointView& joint) {
  const BodyView* b = find_body(stage.frame.snapshot, joint.b);
  const bool on_b = b != nullptr && b->type == BodyType::dynamic;
  draw_force(stage, on_b ? joint.anchor_b : joint.anchor_a, (on_b ? 1 : -1) * joint.reaction, Force::joint);
}

/// A force of 1, 2 or 5 times a power of ten newtons whose arrow is not longer than `most_px`.
double round_force(const Stage& stage, double most_px) {
  const double most = most_px / stage.camera.px(stage.frame.force_scale);
  double power = 1;
  while (power > most) power *= 0.1;
  while (10 * power <= most) power *= 10;
  return power * (5 * power <= most ? 5 : 2 * power <= most ? 2 : 1);
}

/// What a line or an arrow of the key stands for.
struct KeyEntry {
  Color color;
  double width_px = 0;
  double length_px = 0;
  bool arrow = false;
  std::string text;
};

std::vector<KeyEntry> key_entries(const Stage& stage) {
  const double size = stage.sizes.small;
  const double newtons = round_force(stage, 4 * size);
  std::vector<KeyEntry> entries{{stage.palette.ink, width_px(stage, Force::normal),
                                 stage.camera.px(stage.frame.force_scale * newtons), true,
                                 number_text(newtons, newtons < 1 ? 3 : 0) + " N"}};
  const std::size_t kinds = stage.frame.snapshot.joints.empty() ? 2 : 3;
  for (std::size_t i = 0; i < kinds; ++i) {
    const auto kind = static_cast<Force>(i);
    entries.push_back({color_of(stage, kind), width_px(stage, kind), 1.1 * size, false, force_names[i]});
  }
  return entries;
}

}  // namespace

void draw_forces(const Stage& stage) {
  const Snapshot& snapshot = stage.frame.snapshot;
  const double dt = seconds_per_tick(snapshot);
  if (dt <= 0) return;  // before the first tick nobody knows them
  for (const JointView& joint : snapshot.joints) {
    if (joint.kind == JointKind::gear || joint.broken) continue;
    stage.own(OwnerKind::force, joint.a, joint.b);
    draw_reaction(stage, joint);
  }
  for (const ContactView& contact : snapshot.contacts) {
    stage.own(OwnerKind::force, contact.a, contact.b);
    draw_contact_forces(stage, contact, dt);
  }
}

void draw_force_key(const Stage& stage, Cards& cards) {
  if (stage.frame.force_scale <= 0) return;
  const int size = stage.sizes.small;
  const double gap = 0.9 * size, beside = 0.5 * size, padding = 0.7 * size;
  const std::vector<KeyEntry> entries = key_entries(stage);
  double width = 2 * padding - gap;
  for (const KeyEntry& entry : entries)
    width += gap + entry.length_px + beside + stage.canvas.text_width(entry.text, size);
  stage.own(OwnerKind::note, "forces");
  const Aabbd card = cards.place({width, 2.0 * size}, Corner::bottom_left);
  stage.canvas.rectangle(card.lower, card.upper, 0.3 * size, {stage.palette.plate, stage.palette.plate_edge, 1});
  Vec2d at{card.lower.x + padding, center(card).y};
  for (const KeyEntry& entry : entries) {
    const Vec2d end = at + Vec2d{entry.length_px, 0};
    if (entry.arrow) {
      stage.canvas.arrow(at, end, entry.width_px, entry.color);
    } else {
      stage.canvas.line(at, end, entry.width_px, entry.color);
    }
    const Vec2d baseline{end.x + beside, std::floor(at.y + 0.5 * cap_height * size)};
    stage.canvas.text(entry.text, baseline, size, Align::left, stage.palette.ink);
    at.x = baseline.x + stage.canvas.text_width(entry.text, size) + gap;
  }
}

}  // namespace proofreel
