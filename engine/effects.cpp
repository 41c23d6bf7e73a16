#include "engine/effects.h"

#include <algorithm>

namespace proofreel {

EffectCensus::EffectCensus(const Scene& scene)
    : gravity_(!(scene.gravity == Vec2d{})),
      drag_(scene.drag.acts()),
      wind_(!(scene.wind == Vec2d{})),
      attractor_(!scene.attractors.empty()),
      nbody_(scene.gravitational_constant.has_value()),
      rocket_(!scene.rockets.empty()) {}

void EffectCensus::add(const BodyDef& body) {
  drag_ |= body.drag && body.drag->acts();
  if (body.shapes.empty()) return;
  const bool dynamic = body.type == BodyType::dynamic;
  const auto is_alike = [&](const MeetingClass& c) { return c.dynamic == dynamic && c.filter == body.filter; };
  const auto known = std::find_if(classes_.begin(), classes_.end(), is_alike);
  if (known == classes_.end()) {
    classes_.push_back({body.filter, dynamic, 1});
  } else {
    ++known->bodies;
  }
  sensor_ |= body.sensor;
  for (const ShapeDef& shape : body.shapes) {
    friction_ |= shape.friction.at_rest > 0 || shape.friction.sliding > 0;
    restitution_ |= shape.restitution > 0;
  }
}

void EffectCensus::add(const JointDef& joint) { (joint.kind == JointKind::spring ? spring_ : rigid_joint_) = true; }

bool EffectCensus::anything_meets() const {
  for (std::size_t i = 0; i < classes_.size(); ++i) {
    for (std::size_t j = i; j < classes_.size(); ++j) {
      const bool moves = classes_[i].dynamic || classes_[j].dynamic;
      const bool two_bodies = i != j || classes_[i].bodies > 1;
      if (moves && two_bodies && filters_agree(classes_[i].filter, classes_[j].filter)) return true;
    }
  }
  return false;
}

EffectSet EffectCensus::inferred() const {
  EffectSet set;
  const auto add_if = [&set](bool called_for, Effect effect) {
    if (called_for) set.add(effect);
  };
  const bool contacts = anything_meets();
  add_if(gravity_, Effect::gravity);
  add_if(drag_, Effect::drag);
  add_if(drag_ && wind_, Effect::wind);
  add_if(attractor_, Effect::attractor);
  add_if(nbody_, Effect::nbody);
  add_if(rocket_, Effect::rocket);
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
  EffectCensus census(scene);
  for (const BodyDef& body : scene.bodies) census.add(body);
  for (const JointDef& joint : scene.joints) census.add(joint);
  return census.inferred();
}

const char* name_of(Effect effect) {
  switch (effect) {
    case Effect::gravity:
      return "gravity";
    case Effect::drag:
      return "drag";
    case Effect::wind:
      return "wind";
    case Effect::attractor:
      return "attractor";
    case Effect::nbody:
      return "nbody";
    case Effect::rocket:
      return "rocket";
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
