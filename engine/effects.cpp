#include "engine/effects.h"

#include <algorithm>

namespace proofreel {

EffectCensus::EffectCensus(const Scene& scene)
    : gravity_(!(scene.gravity == Vec2d{})),
      drag_(scene.drag.acts()),
      wind_(!(scene.wind == Vec2d{})),
      attractor_(!scene.attractors.empty()),
      nbody_(scene.gravitational_constant.has_value()),
      rocket_(!scene.rockets.empty()),
      buoyancy_(scene.water.has_value()),
      field_(!scene.fields.empty()),
      sleeping_(scene.sleeping) {}

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
    rolling_resistance_ |= shape.rolling_resistance > 0;
    restitution_ |= shape.restitution > 0;
    surface_speed_ |= shape.surface_speed != 0;
  }
}

void EffectCensus::add(const JointDef& joint) {
  spring_ |= is_springy(joint.kind);
  rigid_joint_ |= !is_soft(joint.kind);
  limit_ |= joint.limits.has_value() || joint.kind == JointKind::rope;
  motor_ |= joint.motor.has_value() || joint.kind == JointKind::motor || joint.kind == JointKind::drag_to;
  breakable_ |= joint.break_force.has_value();
}

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

std::vector<EffectDecision> EffectCensus::decisions() const {
  std::vector<EffectDecision> all;
  const auto decide = [&all](Effect effect, bool called_for, const char* reason_on, const char* reason_off) {
    all.push_back({effect, called_for, called_for ? reason_on : reason_off});
  };
  const bool contacts = anything_meets();
  const char* const nothing_meets = "no two bodies can meet";
  const auto at_contacts = [&](Effect effect, bool called_for, const char* reason_on, const char* reason_off) {
    decide(effect, contacts && called_for, reason_on, contacts ? reason_off : nothing_meets);
  };
  decide(Effect::gravity, gravity_, "gravity is not zero", "gravity is zero");
  decide(Effect::drag, drag_, "drag is given", "no drag is given");
  decide(Effect::wind, drag_ && wind_, "wind is given",
         wind_ ? "wind is given, but nothing drags" : "no wind is given");
  decide(Effect::attractor, attractor_, "an attractor is given", "no attractor is given");
  decide(Effect::nbody, nbody_, "bodies attract each other", "bodies do not attract each other");
  decide(Effect::buoyancy, buoyancy_, "there is water", "there is no water");
  decide(Effect::field, field_, "a force field is given", "no force field is given");
  decide(Effect::springs, spring_, "there is a spring", "there is no spring");
  decide(Effect::rocket, rocket_, "there is a rocket", "there is no rocket");
  decide(Effect::contacts, contacts, "bodies can meet", nothing_meets);
  at_contacts(Effect::friction, friction_, "bodies can meet, and a shape has friction", "no shape has friction");
  at_contacts(Effect::rolling_resistance, rolling_resistance_, "bodies can meet, and a shape resists rolling",
              "no shape has rolling resistance");
  at_contacts(Effect::restitution, restitution_, "bodies can meet, and a shape has restitution",
              "no shape has restitution");
  at_contacts(Effect::surface_speed, friction_ && surface_speed_, "bodies can meet, and a surface moves",
              surface_speed_ ? "a surface moves, but no shape has friction" : "no surface moves");
  at_contacts(Effect::ccd, true, "bodies can meet, and none may pass through another", "");
  decide(Effect::joints, rigid_joint_, "there is a rigid joint", "there is no rigid joint");
  decide(Effect::limits, limit_, "a joint has limits, or is a rope", "no joint has limits");
  decide(Effect::motors, motor_, "a joint is driven", "no joint is driven");
  decide(Effect::breakage, breakable_, "a joint can break", "no joint can break");
  at_contacts(Effect::sensors, sensor_, "bodies can meet, and one is a sensor", "no body is a sensor");
  decide(Effect::sleeping, sleeping_, "on_sleep is used", "no on_sleep is used, and no list of effects names it");
  return all;
}

std::vector<EffectDecision> EffectCensus::decisions(EffectSet listed) const {
  std::vector<EffectDecision> all = decisions();
  for (EffectDecision& decision : all) {
    const bool called_for = decision.on;
    decision.on = listed.has(decision.effect);
    if (decision.on == called_for) continue;
    if (decision.effect == Effect::sleeping && decision.on) {  // nothing else in a scene calls for it
      decision.why = "the list of effects names it";
      continue;
    }
    decision.why = decision.on ? "the list of effects names it, though " + decision.why
                               : "the list of effects omits it, though " + decision.why;
  }
  return all;
}

EffectSet EffectCensus::inferred() const {
  EffectSet set;
  for (const EffectDecision& decision : decisions()) {
    if (decision.on) set.add(decision.effect);
  }
  return set;
}

EffectSet effects_of(const Scene& scene) {
  if (scene.effects) return *scene.effects;
  EffectCensus census(scene);
  for (const BodyDef& body : scene.bodies) census.add(body);
  for (const JointDef& joint : scene.joints) census.add(joint);
  return census.inferred();
}

const char* name_of(Integrator integrator) {
  switch (integrator) {
    case Integrator::symplectic_euler:
      return "symplectic_euler";
    case Integrator::verlet:
      return "verlet";
    case Integrator::suzuki4:
      return "suzuki4";
    case Integrator::rk4:
      return "rk4";
    case Integrator::implicit_midpoint:
      return "implicit_midpoint";
    case Integrator::gauss_legendre6:
      return "gauss_legendre6";
  }
  return "";
}

bool steps_everything(Integrator integrator) {
  return integrator == Integrator::symplectic_euler || integrator == Integrator::verlet;
}

bool steps_everything(const Method& method) {
  return steps_everything(method.integrator) && method.contact_solver != ContactMethod::event;
}

namespace {

bool is_pulled(const JointDef& joint) { return joint.kind == JointKind::drag_to; }

/// Whether something in the scene may look at velocities, or at the time.
bool brakes_or_drives(const Scene& scene, EffectSet effects) {
  if (effects.has(Effect::drag) || effects.has(Effect::field) || effects.has(Effect::motors)) return true;
  if (effects.has(Effect::buoyancy) && scene.water && scene.water->drag > 0) return true;
  return std::any_of(scene.joints.begin(), scene.joints.end(),
                     [](const JointDef& joint) { return joint.damping > 0 || joint.kind == JointKind::drag_to; });
}

}  // namespace

std::optional<std::string> problem_with_method(const Scene& scene) {
  const Integrator integrator = scene.method.integrator;
  const EffectSet effects = effects_of(scene);
  const bool divides_time = scene.method.contact_solver == ContactMethod::event && effects.has(Effect::contacts);
  if (divides_time && (effects.has(Effect::rocket) || effects.has(Effect::field)))
    return std::string("contact_solver \"event\" makes steps of any length, which rockets and fields cannot follow: ") +
           "use \"exact\"";
  if (divides_time && effects.has(Effect::sleeping))
    return std::string("contact_solver \"event\" makes steps of any length, which nobody sleeps through: ") +
           "use \"exact\", or take \"sleeping\" out of the effects";
  if (steps_everything(integrator)) return std::nullopt;
  const std::string method = std::string("integrator \"") + name_of(integrator) + "\" ";
  if (effects.has(Effect::contacts))
    return method + "cannot step bodies that may meet, whose velocities jump: use \"verlet\" or " +
           "\"symplectic_euler\", or give the bodies one negative group";
  if (effects.has(Effect::rocket))
    return method + "cannot step a rocket, whose mass changes on the way: use \"verlet\" or \"symplectic_euler\"";
  if (effects.has(Effect::sleeping))
    return method + "cannot leave out bodies that sleep: use \"verlet\" or \"symplectic_euler\"";
  if (integrator == Integrator::suzuki4) {
    if (effects.has(Effect::joints) && scene.method.joint_solver == JointMethod::iterative)
      return method + "composes steps that joints must not spoil: use joint_solver \"direct\"";
    if (!brakes_or_drives(scene, effects)) return std::nullopt;
    return method + "steps backwards inside, where what brakes would drive (drag, dampers, motors, fields): " +
           "use another one";
  }
  const bool rigid = effects.has(Effect::joints) || std::any_of(scene.joints.begin(), scene.joints.end(), is_pulled);
  if (!rigid) return std::nullopt;
  return method + "cannot step joints other than springs: use \"verlet\" or \"symplectic_euler\"";
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
    case Effect::buoyancy:
      return "buoyancy";
    case Effect::field:
      return "field";
    case Effect::springs:
      return "springs";
    case Effect::contacts:
      return "contacts";
    case Effect::friction:
      return "friction";
    case Effect::rolling_resistance:
      return "rolling_resistance";
    case Effect::restitution:
      return "restitution";
    case Effect::surface_speed:
      return "surface_speed";
    case Effect::ccd:
      return "ccd";
    case Effect::joints:
      return "joints";
    case Effect::limits:
      return "limits";
    case Effect::motors:
      return "motors";
    case Effect::breakage:
      return "breakage";
    case Effect::sensors:
      return "sensors";
    case Effect::sleeping:
      return "sleeping";
  }
  return "";
}

}  // namespace proofreel
