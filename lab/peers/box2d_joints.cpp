#include "lab/peers/box2d_joints.h"

#include "lab/peers/box2d_shapes.h"
#include "lab/peers/peer_problems.h"

namespace proofreel {
namespace {

constexpr double least_length = static_cast<double>(b2_linearSlop);

float to_float(double x) { return static_cast<float>(x); }

/// A definition with what all joints have.
template <typename Def>
Def between(const Box2dJointEnds& ends, const JointDef& joint) {
  Def def;
  def.bodyA = ends.a;
  def.bodyB = ends.b;
  def.collideConnected = !lets_overlap(joint.kind);
  return def;
}

/// And anchors in the bodies' coordinates.
template <typename Def>
Def anchored(const Box2dJointEnds& ends, const JointDef& joint) {
  auto def = between<Def>(ends, joint);
  def.localAnchorA = to_b2(joint.anchor_a);
  def.localAnchorB = to_b2(joint.anchor_b);
  return def;
}

b2RevoluteJointDef revolute(const Box2dJointEnds& ends, const JointDef& joint) {
  auto def = anchored<b2RevoluteJointDef>(ends, joint);
  def.referenceAngle = to_float(ends.turn);
  if (joint.limits) {
    def.enableLimit = true;
    def.lowerAngle = to_float(joint.limits->lower);
    def.upperAngle = to_float(joint.limits->upper);
  }
  if (joint.motor) {
    def.enableMotor = true;
    def.motorSpeed = to_float(joint.motor->speed);
    def.maxMotorTorque = to_float(joint.motor->strongest);
  }
  return def;
}

b2PrismaticJointDef prismatic(const Box2dJointEnds& ends, const JointDef& joint) {
  auto def = anchored<b2PrismaticJointDef>(ends, joint);
  def.localAxisA = to_b2(joint.axis);
  def.referenceAngle = to_float(ends.turn);
  if (joint.limits) {
    def.enableLimit = true;
    def.lowerTranslation = to_float(joint.limits->lower);
    def.upperTranslation = to_float(joint.limits->upper);
  }
  if (joint.motor) {
    def.enableMotor = true;
    def.motorSpeed = to_float(joint.motor->speed);
    def.maxMotorForce = to_float(joint.motor->strongest);
  }
  return def;
}

b2WheelJointDef wheel(const Box2dJointEnds& ends, const JointDef& joint) {
  auto def = anchored<b2WheelJointDef>(ends, joint);
  def.localAxisA = to_b2(joint.axis);
  def.stiffness = to_float(joint.stiffness);
  def.damping = to_float(joint.damping);
  if (joint.motor) {
    def.enableMotor = true;
    def.motorSpeed = to_float(joint.motor->speed);
    def.maxMotorTorque = to_float(joint.motor->strongest);
  }
  return def;
}

/// Rods, ropes and springs are one joint in Box2D.
b2DistanceJointDef distance_joint(const Box2dJointEnds& ends, const JointDef& joint) {
  auto def = anchored<b2DistanceJointDef>(ends, joint);
  def.length = to_float(joint.length);
  if (joint.kind == JointKind::spring) {
    def.stiffness = to_float(joint.stiffness);
    def.damping = to_float(joint.damping);
  } else {
    def.maxLength = def.length;
    if (joint.kind == JointKind::distance) def.minLength = def.length;
  }
  return def;
}

b2WeldJointDef weld(const Box2dJointEnds& ends, const JointDef& joint) {
  auto def = anchored<b2WeldJointDef>(ends, joint);
  def.referenceAngle = to_float(ends.turn);
  return def;
}

b2PulleyJointDef pulley(const Box2dJointEnds& ends, const JointDef& joint) {
  auto def = anchored<b2PulleyJointDef>(ends, joint);
  def.groundAnchorA = to_b2(joint.pin_a);
  def.groundAnchorB = to_b2(joint.pin_b);
  def.lengthA = b2Distance(ends.a->GetWorldPoint(def.localAnchorA), def.groundAnchorA);
  def.lengthB = b2Distance(ends.b->GetWorldPoint(def.localAnchorB), def.groundAnchorB);
  def.ratio = to_float(joint.ratio);
  return def;
}

b2GearJointDef gear(const Box2dJointEnds& ends, const JointDef& joint) {
  auto def = between<b2GearJointDef>({ends.first->GetBodyB(), ends.second->GetBodyB(), 0, nullptr, nullptr}, joint);
  def.joint1 = ends.first;
  def.joint2 = ends.second;
  def.ratio = to_float(joint.ratio);
  return def;
}

template <typename Def>
b2Joint* create(b2World& world, const Def& def) {
  return world.CreateJoint(&def);
}

}  // namespace

b2Joint* add_joint(b2World& world, const JointDef& def, const Box2dJointEnds& ends) {
  switch (def.kind) {
    case JointKind::revolute:
      return create(world, revolute(ends, def));
    case JointKind::prismatic:
      return create(world, prismatic(ends, def));
    case JointKind::wheel:
      return create(world, wheel(ends, def));
    case JointKind::weld:
      return create(world, weld(ends, def));
    case JointKind::gear:
      return create(world, gear(ends, def));
    case JointKind::pulley:
      return create(world, pulley(ends, def));
    case JointKind::distance:
    case JointKind::rope:
    case JointKind::spring:
      return create(world, distance_joint(ends, def));
    case JointKind::drag_to:
    case JointKind::motor:
      break;  // refused before
  }
  return nullptr;
}

void set_motor_speed(b2Joint& joint, double speed) {
  if (joint.GetType() == e_revoluteJoint) static_cast<b2RevoluteJoint&>(joint).SetMotorSpeed(to_float(speed));
  if (joint.GetType() == e_prismaticJoint) static_cast<b2PrismaticJoint&>(joint).SetMotorSpeed(to_float(speed));
  if (joint.GetType() == e_wheelJoint) static_cast<b2WheelJoint&>(joint).SetMotorSpeed(to_float(speed));
}

Problem problem_for_box2d(const JointDef& joint) {
  const bool long_enough =
      joint.kind != JointKind::distance && joint.kind != JointKind::rope && joint.kind != JointKind::spring;
  if (long_enough || joint.length >= least_length) return {};
  return "it is shorter than 5 mm, the least Box2D allows";
}

}  // namespace proofreel
