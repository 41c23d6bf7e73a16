/// Springs push by their length, not by an equation: the force along the line between the anchors is
///
///   F = -stiffness * (length now - length at rest) - damping * (speed along it)
///
/// and a wheel's suspension is the same along its axis (wheel.cpp). The damper acts on the mean of the speeds before
/// and after: second order, and stable however strong it is. It acts where positions and velocities belong to one
/// time, not between the halves of a kick, so that what hangs at rest on a damped spring hangs where its weight says.

#include "engine/joints/kinds.h"

namespace proofreel {
inline namespace PROOFREEL_PRECISION {
namespace {

/// What a spring sees: how far it is stretched, in which direction, and the arms it pulls at.
struct Stretch {
  Vec2 along;
  Vec2 arm_a;
  Vec2 arm_b;
  real by = 0;
  bool has_direction = true;
};

Stretch stretch_of(const Joint& joint, const JointPlace& place) {
  if (joint.kind == JointKind::wheel) return {place.axis, place.arm_a + place.gap, place.arm_b, along(place)};
  const real stretched = length(place.gap);
  // At one point there is no direction to push in; any other position has one.
  if (stretched <= 0) return {{}, {}, {}, -joint.length, false};
  return {(1 / stretched) * place.gap, place.arm_a, place.arm_b, stretched - joint.length};
}

void give(Joint& joint, const Stretch& s, real size, std::vector<Motion>& motions) {
  const Vec2 impulse = size * s.along;
  motions[joint.body_a].push(-impulse, s.arm_a);
  motions[joint.body_b].push(impulse, s.arm_b);
  joint.impulse += impulse;
  joint.soft_impulse += impulse;
}

}  // namespace

void kick_spring(Joint& joint, const std::vector<Body>& bodies, std::vector<Motion>& motions, real h) {
  const Stretch s = stretch_of(joint, place_of(joint, bodies, motions));
  if (s.has_direction) give(joint, s, -h * (joint.stiffness * s.by), motions);
}

void damp_spring(Joint& joint, const std::vector<Body>& bodies, std::vector<Motion>& motions, real h) {
  if (joint.damping <= 0) return;
  const Stretch s = stretch_of(joint, place_of(joint, bodies, motions));
  if (!s.has_direction) return;
  const Motion& a = motions[joint.body_a];
  const Motion& b = motions[joint.body_b];
  const real speed = dot(b.velocity_at(s.arm_b) - a.velocity_at(s.arm_a), s.along);
  const real lever_a = cross(s.arm_a, s.along);
  const real lever_b = cross(s.arm_b, s.along);
  const real inverse_mass =
      a.inv_mass + b.inv_mass + a.inv_inertia * lever_a * lever_a + b.inv_inertia * lever_b * lever_b;
  give(joint, s, -h * joint.damping * speed / (1 + real(0.5) * h * joint.damping * inverse_mass), motions);
}

Vec2 push_by_spring(const Joint& joint, const std::vector<Body>& bodies, const std::vector<Motion>& motions,
                    std::vector<Motion>& pushed, real h) {
  const Stretch s = stretch_of(joint, place_of(joint, bodies, motions));
  if (!s.has_direction) return {};
  const Motion& a = motions[joint.body_a];
  const Motion& b = motions[joint.body_b];
  const real speed = dot(b.velocity_at(s.arm_b) - a.velocity_at(s.arm_a), s.along);
  const Vec2 impulse = -h * (joint.stiffness * s.by + joint.damping * speed) * s.along;
  pushed[joint.body_a].push(-impulse, s.arm_a);
  pushed[joint.body_b].push(impulse, s.arm_b);
  return impulse;
}

double stored_energy(const Joint& joint, const std::vector<Body>& bodies, const std::vector<Motion>& motions) {
  const auto by = static_cast<double>(stretch_of(joint, place_of(joint, bodies, motions)).by);
  return 0.5 * static_cast<double>(joint.stiffness) * by * by;
}

}  // namespace PROOFREEL_PRECISION
}  // namespace proofreel
