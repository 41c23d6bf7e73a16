#include "engine/joint_tension.h"

#include <algorithm>
#include <cmath>

namespace proofreel {
inline namespace PROOFREEL_PRECISION {
namespace {

bool is_line(JointKind kind) { return kind == JointKind::distance || kind == JointKind::rope; }

/// What stands open by so many times its size per second of a tick is about to be closed, or cannot be: what it pulls
/// with means nothing.
constexpr real far_open = 1;

bool holds_by_anchors(JointKind kind) {
  return kind == JointKind::revolute || kind == JointKind::weld || is_line(kind);
}

/// A group that contradicts itself is given up and keeps no impulses (JointGroup::close_gently): no step is too long
/// for what it pulls with, nor short enough.
bool was_solved(const Joint& joint) {
  return std::any_of(joint.memory.begin(), joint.memory.end(), [](const RowMemory& m) { return m.impulse != 0; });
}

}  // namespace

real JointTension::fastest_swing(const std::vector<std::uint32_t>& ids, const JointedBodies& scene, real dt) {
  holds_.assign(scene.motions.size(), {});
  for (const std::uint32_t i : ids) {
    if (scene.joints[i].acts && holds_by_anchors(scene.joints[i].kind)) add(scene.joints[i], scene, dt);
  }
  real fastest = 0;
  for (const Hold& hold : holds_) fastest = std::max(fastest, hold.across + std::max(real(0), hold.turning));
  return std::sqrt(fastest);
}

void JointTension::add(const Joint& joint, const JointedBodies& scene, real dt) {
  const Vec2 force = (1 / dt) * (joint.impulse - joint.soft_impulse);  // on b
  if (force == Vec2{} || !was_solved(joint)) return;
  const JointPlace place = place_of(joint, scene.bodies, scene.motions);
  const real reach = length(place.gap);
  const real rest = is_line(joint.kind) ? joint.length : real(0);
  if (reach - rest > far_open * joint.size * dt) return;
  holds_[joint.body_a].turning -= scene.motions[joint.body_a].inv_inertia * dot(force, place.arm_a);
  holds_[joint.body_b].turning += scene.motions[joint.body_b].inv_inertia * dot(force, place.arm_b);
  if (is_line(joint.kind) && reach > 0) add_line(joint, place, -dot(force, place.gap) / (reach * reach), scene.motions);
}

/// What moves one end across holds the other: two ends that move against each other feel it twice.
void JointTension::add_line(const Joint& joint, const JointPlace& place, real tension_per_length,
                            const std::vector<Motion>& motions) {
  if (tension_per_length <= 0) return;
  const Vec2 across = perp(normalized(place.gap));
  const auto response = [across](const Motion& m, Vec2 arm) {
    const real turn = cross(arm, across);
    return m.inv_mass + m.inv_inertia * turn * turn;
  };
  const real a = response(motions[joint.body_a], place.arm_a);
  const real b = response(motions[joint.body_b], place.arm_b);
  const real both = a > 0 && b > 0 ? real(2) : real(1);
  holds_[joint.body_a].across += both * tension_per_length * a;
  holds_[joint.body_b].across += both * tension_per_length * b;
}

}  // namespace PROOFREEL_PRECISION
}  // namespace proofreel
