#include "lab/peers/chipmunk_joints.h"

#include <chipmunk/chipmunk_structs.h>  // impulses have directions only in there

#include "engine/rot.h"
#include "lab/peers/chipmunk_shapes.h"
#include "lab/peers/peer_problems.h"

namespace proofreel {
namespace {

/// Chipmunk's grooves have ends: so far away, m, that nothing gets there.
constexpr double groove_reach = 1e4;
/// A wheel's spring begins so far from the axle, m, so that it always pushes along its axis.
constexpr double suspension_reach = 100;

cpConstraint* groove(const JointDef& def, cpBody* a, cpBody* b, double lower, double upper) {
  return cpGrooveJointNew(a, b, to_cp(def.anchor_a + lower * def.axis), to_cp(def.anchor_a + upper * def.axis),
                          to_cp(def.anchor_b));
}

/// Drives the angle of b against a; Chipmunk's rates are of a against b.
cpConstraint* motor(const MotorDef& def, cpBody* a, cpBody* b) {
  cpConstraint* made = cpSimpleMotorNew(a, b, -def.speed);
  cpConstraintSetMaxForce(made, def.strongest);
  return made;
}

ChipmunkParts revolute(const JointDef& def, cpBody* a, cpBody* b, double turn) {
  ChipmunkParts parts{cpPivotJointNew2(a, b, to_cp(def.anchor_a), to_cp(def.anchor_b))};
  if (def.limits) parts.push_back(cpRotaryLimitJointNew(a, b, turn + def.limits->lower, turn + def.limits->upper));
  if (def.motor) parts.push_back(motor(*def.motor, a, b));
  return parts;
}

/// A groove and the gear converge only where the groove goes through the centre of mass of b; since b does not turn in
/// it, any point of b slides alike.
ChipmunkParts prismatic(const JointDef& def, cpBody* a, cpBody* b, double turn) {
  const LimitsDef limits = def.limits.value_or(LimitsDef{-groove_reach, groove_reach});
  JointDef centred = def;
  centred.anchor_b = from_cp(cpBodyGetCenterOfGravity(b));
  centred.anchor_a += rotate(Rotd(turn), centred.anchor_b - def.anchor_b);
  return {groove(centred, a, b, limits.lower, limits.upper), cpGearJointNew(a, b, turn, 1)};
}

ChipmunkParts wheel(const JointDef& def, cpBody* a, cpBody* b) {
  const Vec2d far_end = def.anchor_a - suspension_reach * def.axis;
  ChipmunkParts parts{
      groove(def, a, b, -groove_reach, groove_reach),
      cpDampedSpringNew(a, b, to_cp(far_end), to_cp(def.anchor_b), suspension_reach, def.stiffness, def.damping)};
  if (def.motor) parts.push_back(motor(*def.motor, a, b));
  return parts;
}

ChipmunkParts rod(const JointDef& def, cpBody* a, cpBody* b) {
  cpConstraint* made = cpPinJointNew(a, b, to_cp(def.anchor_a), to_cp(def.anchor_b));
  cpPinJointSetDist(made, def.length);
  return {made};
}

ChipmunkParts parts_of(const JointDef& def, cpBody* a, cpBody* b, double turn) {
  const cpVect from = to_cp(def.anchor_a);
  const cpVect to = to_cp(def.anchor_b);
  switch (def.kind) {
    case JointKind::revolute:
      return revolute(def, a, b, turn);
    case JointKind::distance:
      return rod(def, a, b);
    case JointKind::rope:
      return {cpSlideJointNew(a, b, from, to, 0, def.length)};
    case JointKind::spring:
      return {cpDampedSpringNew(a, b, from, to, def.length, def.stiffness, def.damping)};
    case JointKind::prismatic:
      return prismatic(def, a, b, turn);
    case JointKind::weld:
      return {cpPivotJointNew2(a, b, from, to), cpGearJointNew(a, b, turn, 1)};
    case JointKind::wheel:
      return wheel(def, a, b);
    case JointKind::gear:
    case JointKind::pulley:
    case JointKind::drag_to:
    case JointKind::motor:
      break;  // refused before
  }
  return {};
}

template <typename T>
const T& as(const cpConstraint* c) {
  return *reinterpret_cast<const T*>(c);  // as Chipmunk does it: a constraint is what all of them begin with
}

Vec2d impulse_of(const cpConstraint* c) {
  if (cpConstraintIsPivotJoint(c)) return from_cp(as<cpPivotJoint>(c).jAcc);
  if (cpConstraintIsGrooveJoint(c)) return from_cp(as<cpGrooveJoint>(c).jAcc);
  if (cpConstraintIsPinJoint(c)) return from_cp(cpvmult(as<cpPinJoint>(c).n, as<cpPinJoint>(c).jnAcc));
  if (cpConstraintIsSlideJoint(c)) return from_cp(cpvmult(as<cpSlideJoint>(c).n, as<cpSlideJoint>(c).jnAcc));
  if (cpConstraintIsDampedSpring(c)) return from_cp(cpvmult(as<cpDampedSpring>(c).n, as<cpDampedSpring>(c).jAcc));
  return {};
}

double angular_impulse_of(const cpConstraint* c) {
  if (cpConstraintIsRotaryLimitJoint(c)) return as<cpRotaryLimitJoint>(c).jAcc;
  if (cpConstraintIsGearJoint(c)) return as<cpGearJoint>(c).jAcc;
  if (cpConstraintIsSimpleMotor(c)) return as<cpSimpleMotor>(c).jAcc;
  return 0;
}

}  // namespace

ChipmunkParts make_joint(const JointDef& def, cpBody* a, cpBody* b, double turn) {
  ChipmunkParts parts = parts_of(def, a, b, turn);
  for (cpConstraint* part : parts) cpConstraintSetCollideBodies(part, lets_overlap(def.kind) ? cpFalse : cpTrue);
  return parts;
}

void set_motor_speed(const ChipmunkParts& joint, double speed) {
  for (cpConstraint* part : joint) {
    if (cpConstraintIsSimpleMotor(part)) cpSimpleMotorSetRate(part, -speed);
  }
}

PeerReaction reaction_of(const ChipmunkParts& joint, double dt) {
  PeerReaction sum;
  if (dt <= 0) return sum;
  for (const cpConstraint* part : joint) {
    sum.force += 1 / dt * impulse_of(part);
    sum.torque += angular_impulse_of(part) / dt;
  }
  return sum;
}

Problem problem_for_chipmunk(const JointDef& joint) {
  if (joint.kind == JointKind::gear) return "Chipmunk gears bodies, not joints";
  if (joint.kind == JointKind::pulley) return "Chipmunk has no pulleys";
  if (joint.kind == JointKind::prismatic && joint.motor) return "Chipmunk's motors only turn";
  return {};
}

}  // namespace proofreel
