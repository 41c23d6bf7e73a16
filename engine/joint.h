#pragma once

/// Joints inside the engine. Every rigid joint comes down to rows: one row is one number that must stay zero, with the
/// direction in which a force keeps it there.

#include <vector>

#include "engine/body.h"

namespace proofreel {
inline namespace PROOFREEL_PRECISION {

struct Joint {
  JointKind kind = JointKind::revolute;
  bool alive = true;
  BodyIndex body_a = 0;
  BodyIndex body_b = 0;
  Vec2 local_a;  ///< anchors in the bodies' axes, from their centres of mass
  Vec2 local_b;
  real length = 0;
  real size = 1;  ///< what its errors are measured by, m
  real stiffness = 0;
  real damping = 0;
  Vec2 impulse;       ///< on b, N s over the tick so far
  Vec2 warm_impulse;  ///< of a rigid joint's rows in the last position stage
};

inline bool is_rigid(const Joint& joint) { return joint.kind != JointKind::spring; }
/// Scalar equations: a revolute joint keeps two coordinates together, a distance joint one length.
inline int row_count(const Joint& joint) {
  return joint.kind == JointKind::revolute ? 2 : joint.kind == JointKind::distance ? 1 : 0;
}

/// From anchor a to anchor b, world axes, with the arms from the centres of mass.
struct AnchorGap {
  Vec2 arm_a;
  Vec2 arm_b;
  Vec2 gap;
};
AnchorGap anchor_gap(const Joint& joint, const std::vector<Body>& bodies, const std::vector<Motion>& motions);

/// How far the joint is from what it should be, in metres; 0 for springs.
real violation(const Joint& joint, Vec2 gap);

/// Adds a spring's force, times `h`, to the velocities of its bodies: stiffness along the line between the anchors and
/// damping of the speed along it.
void kick_spring(Joint& joint, const std::vector<Body>& bodies, std::vector<Motion>& motions, real h);

}  // namespace PROOFREEL_PRECISION
}  // namespace proofreel
