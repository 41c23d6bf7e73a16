#include "engine/effects.h"

namespace proofreel {

void EffectCensus::add(const BodyDef& body) {
  if (body.shapes.empty()) return;
  ++bodies_with_shapes_;
  dynamic_shape_ |= body.type == BodyType::dynamic;
  sensor_ |= body.sensor;
  for (const ShapeDef& shape : body.shapes) {
    friction_ |= shape.friction.at_rest > 0 || shape.friction.sliding > 0;
    restitution_ |= shape.restitution > 0;
  }
}

void EffectCensus::add(const JointDef& joint) { (joint.kind == JointKind::spring ? spring_ : rigid_joint_) = true; }

EffectSet EffectCensus::inferred() const {
  EffectSet set;
  const auto add_if = [&set](bool called_for, Effect effect) {
    if (called_for) set.add(effect);
  };
  const bool contacts = dynamic_shape_ && bodies_with_shapes_ > 1;
  add_if(!(gravity_ == Vec2d{}), Effect::gravity);
  add_if(spring_, Effect::springs);
  add_if(contacts, Effect::contacts);
  add_if(contacts && friction_, Effect::friction);
  add_if(contacts && restitution_, Effect::restitution);
  add_if(contacts, Effect::ccd);
  add_if(rigid_joint_, Effect::joints);
  add_if(contacts && sensor_, Effect::sensors);
  return set;
}

EffectSet effects_of(const Scene& scene) {
  if (scene.effects) return *scene.effects;
  EffectCensus census(scene.gravity);
  for (const BodyDef& body : scene.bodies) census.add(body);
  for (const JointDef& joint : scene.joints) census.add(joint);
  return census.inferred();
}

const char* name_of(Effect effect) {
  switch (effect) {
    case Effect::gravity:
      return "gravity";
    case Effect::springs:
      return "springs";
    case Effect::contacts:
      return "contacts";
    case Effect::friction:
      return "friction";
    case Effect::restitution:
      return "restitution";
    case Effect::ccd:
      return "ccd";
    case Effect::joints:
      return "joints";
    case Effect::sensors:
      return "sensors";
  }
  return "";
}

}  // namespace proofreel
