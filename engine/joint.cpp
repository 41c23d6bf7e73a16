#include "engine/joint.h"

#include <cmath>

namespace proofreel {
inline namespace PROOFREEL_PRECISION {

AnchorGap anchor_gap(const Joint& joint, const std::vector<Body>& bodies, const std::vector<Motion>& motions) {
  const Motion& a = motions[joint.body_a];
  const Motion& b = motions[joint.body_b];
  AnchorGap g;
  g.arm_a = rotate(a.rotation, joint.local_a);
  g.arm_b = rotate(b.rotation, joint.local_b);
  const Vec2 centers = (bodies[joint.body_b].center - bodies[joint.body_a].center) + (b.delta - a.delta);
  g.gap = centers + (g.arm_b - g.arm_a);
  return g;
}

real violation(const Joint& joint, Vec2 gap) {
  switch (joint.kind) {
    case JointKind::revolute:
      return length(gap);
    case JointKind::distance:
      return std::abs(length(gap) - joint.length);
    case JointKind::spring:
      return 0;
  }
  return 0;
}

void kick_spring(Joint& joint, const std::vector<Body>& bodies, std::vector<Motion>& motions, real h) {
  Motion& a = motions[joint.body_a];
  Motion& b = motions[joint.body_b];
  const AnchorGap g = anchor_gap(joint, bodies, motions);
  const real stretched = length(g.gap);
  if (stretched <= 0) return;  // no direction to push in; any other position has one
  const Vec2 along = (1 / stretched) * g.gap;
  const real speed = dot(b.velocity_at(g.arm_b) - a.velocity_at(g.arm_a), along);
  // The damper acts on the mean of the speeds before and after: second order, and stable however strong it is.
  const real lever_a = cross(g.arm_a, along);
  const real lever_b = cross(g.arm_b, along);
  const real inverse_mass =
      a.inv_mass + b.inv_mass + a.inv_inertia * lever_a * lever_a + b.inv_inertia * lever_b * lever_b;
  const real force = joint.stiffness * (stretched - joint.length) + joint.damping * speed;
  const Vec2 impulse = -h * force / (1 + real(0.5) * h * joint.damping * inverse_mass) * along;
  a.push(-impulse, g.arm_a);
  b.push(impulse, g.arm_b);
  joint.impulse += impulse;
}

}  // namespace PROOFREEL_PRECISION
}  // namespace proofreel
