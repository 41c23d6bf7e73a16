#include "engine/joint.h"

#include <algorithm>
#include <cmath>

#include "engine/joints/kinds.h"

namespace proofreel {
inline namespace PROOFREEL_PRECISION {

Joint make_joint(const JointDef& def) {
  Joint joint;
  joint.kind = def.kind;
  joint.body_a = static_cast<BodyIndex>(def.a);
  joint.body_b = static_cast<BodyIndex>(def.b);
  joint.local_axis = Vec2(def.axis);
  joint.length = static_cast<real>(def.length);
  joint.stiffness = static_cast<real>(def.stiffness);
  joint.damping = static_cast<real>(def.damping);
  joint.ratio = static_cast<real>(def.ratio);
  if (def.limits) joint.limits = {static_cast<real>(def.limits->lower), static_cast<real>(def.limits->upper)};
  if (def.motor) joint.motor = {static_cast<real>(def.motor->speed), static_cast<real>(def.motor->strongest)};
  joint.break_force = static_cast<real>(def.break_force.value_or(0));
  joint.first = static_cast<std::size_t>(def.first);
  joint.second = static_cast<std::size_t>(def.second);
  joint.pin_a = Vec2(def.pin_a);
  joint.pin_b = Vec2(def.pin_b);
  joint.target = Vec2(def.target);
  joint.velocity = Vec2(def.velocity);
  joint.max_force = static_cast<real>(def.max_force);
  return joint;
}

real joint_offset(const Joint& joint, const std::vector<Joint>& joints, const std::vector<Body>& bodies,
                  const std::vector<Motion>& motions) {
  if (joint.kind == JointKind::gear) return geared(joint, joints, bodies, motions);
  if (joint.kind == JointKind::pulley) return roped(joint, place_of(joint, bodies, motions));
  return 0;
}

void add_axis_and_ropes(JointPlace& p, const Joint& joint, const std::vector<Body>& bodies, const Motion& a,
                        const Motion& b) {
  if (has_axis(joint)) p.axis = rotate(a.rotation, joint.local_axis);
  if (joint.kind == JointKind::pulley) {
    p.rope_a = (bodies[joint.body_a].center - joint.pin_a) + (a.delta + p.arm_a);
    p.rope_b = (bodies[joint.body_b].center - joint.pin_b) + (b.delta + p.arm_b);
  }
}

real violation(const Joint& joint, const std::vector<Joint>& joints, const std::vector<Body>& bodies,
               const std::vector<Motion>& motions) {
  const JointPlace p = place_of(joint, bodies, motions);
  switch (joint.kind) {
    case JointKind::revolute:
      return length(p.gap);
    case JointKind::distance:
      return std::abs(length(p.gap) - joint.length);
    case JointKind::rope:
      return std::max(real(0), length(p.gap) - joint.length);
    case JointKind::prismatic:
      return std::max(std::abs(across(p)), joint.size * std::abs(p.turn));
    case JointKind::weld:
      return std::max(length(p.gap), joint.size * std::abs(p.turn));
    case JointKind::wheel:
      return std::abs(across(p));
    case JointKind::gear:
      return std::abs(geared(joint, joints, bodies, motions) - joint.offset);
    case JointKind::pulley:
      return std::abs(roped(joint, p) - joint.offset);
    case JointKind::spring:
    case JointKind::drag_to:
    case JointKind::motor:
      return 0;
  }
  return 0;
}

}  // namespace PROOFREEL_PRECISION
}  // namespace proofreel
