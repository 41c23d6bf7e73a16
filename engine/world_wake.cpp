// Whom a command wakes, before it is carried out: what it acts on, with all of its island, and what rests or hangs on a
// body that is no part of an island and goes away, moves or changes.

#include "engine/world.h"

namespace proofreel {
inline namespace PROOFREEL_PRECISION {
namespace {

BodyIndex index_of(BodyId id) { return static_cast<BodyIndex>(id); }

/// Whether the body only looks different afterwards.
bool only_recolours(const ChangeBody& c) {
  return !c.type && !c.position && !c.angle && !c.velocity && !c.spin && !c.shapes && !c.mass && !c.inertia &&
         !c.friction && !c.restitution && !c.rolling_resistance && !c.surface_speed && !c.density && !c.gravity_scale &&
         !c.fixed_rotation && !c.bullet && !c.sensor && !c.filter && !c.drag;
}

void add_bodies(const Terms& terms, std::vector<BodyIndex>& bodies) {
  for (int t = 0; t < terms.count; ++t) {
    bodies.push_back(terms.terms[t].body_a);
    bodies.push_back(terms.terms[t].body_b);
  }
}

}  // namespace

/// The sleeper, or those that lie on, hang from or are pulled by what does not sleep.
void World::wake_at(BodyIndex index) {
  std::vector<BodyIndex> bodies{index};
  for (const AttractorDef& attractor : attractors_) {
    if (attractor.body != static_cast<BodyId>(index)) continue;
    for (BodyIndex i = 1; i < bodies_.size(); ++i) bodies.push_back(i);
  }
  for (const Contact& c : sleep_.contacts) {
    if (c.body_a != index && c.body_b != index) continue;
    bodies.push_back(c.body_a);
    bodies.push_back(c.body_b);
  }
  for (const Joint& joint : joints_) {
    if (joint.alive && (joint.body_a == index || joint.body_b == index)) add_bodies(bodies_of(joint, joints_), bodies);
  }
  wake(bodies, Moment::before);
}

void World::wake_at(const Joint& joint) {
  std::vector<BodyIndex> bodies;
  add_bodies(bodies_of(joint, joints_), bodies);
  wake(bodies, Moment::before);
}

void World::wake_for(const CreateJoint& command) {
  wake({index_of(command.def.a), index_of(command.def.b)}, Moment::before);
  if (command.def.kind != JointKind::gear) return;
  for (const JointId id : {command.def.first, command.def.second}) wake_at(joints_[static_cast<std::size_t>(id)]);
}

void World::wake_for(const ChangeBody& command) {
  if (!only_recolours(command)) wake_at(index_of(command.body));
}

void World::wake_for(const RemoveBody& command) { wake_at(index_of(command.body)); }
void World::wake_for(const ApplyImpulse& command) { wake({index_of(command.body)}, Moment::before); }
void World::wake_for(const ApplyForce& command) { wake({index_of(command.body)}, Moment::before); }
void World::wake_for(const ApplyTorque& command) { wake({index_of(command.body)}, Moment::before); }
void World::wake_for(const WakeBody& command) { wake({index_of(command.body)}, Moment::before); }
void World::wake_for(const RemoveJoint& command) { wake_at(joints_[static_cast<std::size_t>(command.joint)]); }
void World::wake_for(const ChangeJoint& command) { wake_at(joints_[static_cast<std::size_t>(command.joint)]); }

}  // namespace PROOFREEL_PRECISION
}  // namespace proofreel
