#pragma once

/// Joints inside the engine: what each of them is, and where it stands at present. Rigid joints are made of rows
/// (joint_rows.h); soft ones push by forces. What a kind does lies in the file of its name in engine/joints/.

#include <array>
#include <vector>

#include "engine/body.h"

namespace proofreel {
inline namespace PROOFREEL_PRECISION {

/// What the solver remembers of one row from substep to substep.
struct RowMemory {
  real impulse = 0;      ///< of the last substep, to start the next one from
  bool engaged = false;  ///< a one-sided row: whether it holds at present; a motor: whether it runs at its speed
  real missed = 0;       ///< a motor: the way it is behind its speed, rad or m
};

/// The most rows a joint has: a hinge, its two stops and its motor.
inline constexpr std::size_t most_rows = 5;

struct JointLimits {
  real lower = 0;
  real upper = 0;
};

struct JointMotor {
  real speed = 0;
  real strongest = 0;
};

struct Joint {
  JointKind kind = JointKind::revolute;
  bool alive = true;
  bool broken = false;
  bool acts = true;  ///< it is alive, and its bodies are awake
  BodyIndex body_a = 0;
  BodyIndex body_b = 0;
  Vec2 local_a;  ///< anchors in the bodies' axes, from their centres of mass
  Vec2 local_b;
  Vec2 local_axis;  ///< in a's axes
  real length = 0;
  real angle = 0;   ///< of b against a when the joint was made
  real offset = 0;  ///< gear, pulley: what the coupled coordinates add up to
  real size = 1;    ///< what its errors are measured by, m
  real stiffness = 0;
  real damping = 0;
  real ratio = 1;
  std::optional<JointLimits> limits;
  std::optional<JointMotor> motor;
  real break_force = 0;   ///< N; 0 for what never breaks
  std::size_t first = 0;  ///< gear: the joints it couples
  std::size_t second = 0;
  Vec2 pin_a;
  Vec2 pin_b;
  Vec2 target;
  Vec2 velocity;
  real max_force = 0;
  Vec2 impulse;       ///< on b, N s over the tick so far
  Vec2 soft_impulse;  ///< the part of it that springs gave
  real twist = 0;     ///< on b beside `impulse`, N m s over the tick so far
  std::array<RowMemory, most_rows> memory;
};

/// The joint of a definition, without what depends on where its bodies are: anchors, angle, size, offset.
Joint make_joint(const JointDef& def);

/// Whether it keeps an axis that is fixed in a.
inline bool has_axis(const Joint& joint) {
  return joint.kind == JointKind::prismatic || joint.kind == JointKind::wheel;
}

/// Where a joint stands: world axes, arms from the centres of mass.
struct JointPlace {
  Vec2 arm_a;
  Vec2 arm_b;
  Vec2 centers;   ///< from centre to centre
  Vec2 gap;       ///< from anchor a to anchor b
  real turn = 0;  ///< angle of b against a since the joint was made
  Vec2 axis;      ///< of prismatic joints and wheels
  Vec2 rope_a;    ///< of pulleys: from the pins to the anchors
  Vec2 rope_b;
};
/// What only few kinds look at.
void add_axis_and_ropes(JointPlace& place, const Joint& joint, const std::vector<Body>& bodies, const Motion& a,
                        const Motion& b);
/// Whether there is something for `add_axis_and_ropes` to add.
inline bool has_axis_or_ropes(const Joint& joint) { return has_axis(joint) || joint.kind == JointKind::pulley; }

/// What of a joint and its bodies stays during a tick and tells, with their motions, where the joint stands. Those who
/// ask several times in every substep keep it at hand: joints and bodies are large.
struct Anchors {
  Vec2 local_a;
  Vec2 local_b;
  Vec2 centers;  ///< from centre to centre at the start of the tick
  real angle = 0;
};
inline Anchors anchors_of(const Joint& joint, const std::vector<Body>& bodies) {
  return {joint.local_a, joint.local_b, bodies[joint.body_b].center - bodies[joint.body_a].center, joint.angle};
}
/// Without axes and ropes.
inline JointPlace place_of(const Anchors& anchors, const Motion& a, const Motion& b) {
  JointPlace p;
  p.arm_a = rotate(a.rotation, anchors.local_a);
  p.arm_b = rotate(b.rotation, anchors.local_b);
  p.centers = anchors.centers + (b.delta - a.delta);
  p.gap = p.centers + (p.arm_b - p.arm_a);
  p.turn = (b.angle - a.angle) - anchors.angle;
  return p;
}
inline JointPlace place_of(const Joint& joint, const std::vector<Body>& bodies, const Motion& a, const Motion& b) {
  JointPlace p = place_of(anchors_of(joint, bodies), a, b);
  if (has_axis_or_ropes(joint)) add_axis_and_ropes(p, joint, bodies, a, b);
  return p;
}
inline JointPlace place_of(const Joint& joint, const std::vector<Body>& bodies, const std::vector<Motion>& motions) {
  return place_of(joint, bodies, motions[joint.body_a], motions[joint.body_b]);
}

/// Everything joints act on.
struct JointedBodies {
  std::vector<Joint>& joints;
  const std::vector<Body>& bodies;
  std::vector<Motion>& motions;
};

/// What the coupled coordinates of a gear or a pulley add up to now; 0 for all others.
real joint_offset(const Joint& joint, const std::vector<Joint>& joints, const std::vector<Body>& bodies,
                  const std::vector<Motion>& motions);

/// How far the joint is from what it should be, in metres; 0 for soft ones. Angles count by the joint's size.
real violation(const Joint& joint, const std::vector<Joint>& joints, const std::vector<Body>& bodies,
               const std::vector<Motion>& motions);

/// At the begin of a tick.
inline void forget_reaction(Joint& joint) {
  joint.impulse = {};
  joint.soft_impulse = {};
  joint.twist = 0;
}

/// Energy held by its spring, J.
double stored_energy(const Joint& joint, const std::vector<Body>& bodies, const std::vector<Motion>& motions);

/// Adds the force of a spring, or of a wheel's suspension, times `h` to the velocities of its bodies.
void kick_spring(Joint& joint, const std::vector<Body>& bodies, std::vector<Motion>& motions, real h);
/// The same with the force of its damper.
void damp_spring(Joint& joint, const std::vector<Body>& bodies, std::vector<Motion>& motions, real h);

/// Spring and damper as one force, for integrators that take all forces together: adds to the velocities in `pushed`
/// what it does in `h` seconds to the bodies as they are in `motions`. Returns the impulse on b.
Vec2 push_by_spring(const Joint& joint, const std::vector<Body>& bodies, const std::vector<Motion>& motions,
                    std::vector<Motion>& pushed, real h);

/// Adds the pull of a drag_to over `h` to the velocity of its body. The work it does comes back, J.
double pull(Joint& joint, const std::vector<Body>& bodies, std::vector<Motion>& motions, real h);

}  // namespace PROOFREEL_PRECISION
}  // namespace proofreel
