// The parts of a step, each of which runs only where the scene calls for it (world.cpp puts them together).

#include <algorithm>
#include <cmath>

#include "engine/drag.h"
#include "engine/drift.h"
#include "engine/impact.h"
#include "engine/world.h"

namespace proofreel {
inline namespace PROOFREEL_PRECISION {

void World::find_pairs() {
  update_boxes();
  drop_parted_contacts();
  add_new_pairs();
}

void World::add_new_pairs() {
  for (const ShapePair pair : broad_phase_.new_pairs(shapes_, bodies_)) {
    Contact contact;
    contact.shape_a = pair.a;
    contact.shape_b = pair.b;
    contact.body_a = shapes_[pair.a].body;
    contact.body_b = shapes_[pair.b].body;
    contact.number = ++contacts_made_;
    contact.sensor = bodies_[contact.body_a].sensor || bodies_[contact.body_b].sensor;
    mix_materials(contact, shapes_[pair.a], shapes_[pair.b]);
    contacts_.push_back(contact);
  }
}

/// How far a body falls within a tick at most, m; also what only begins to.
real World::fall_of(BodyIndex i) const {
  return i < accelerations_.size() ? fall_within(dt_, accelerations_[i]) : real(0);
}

/// Boxes reach as far as their shapes may go within the tick, and as far as contacts are looked for.
void World::update_boxes() {
  for (ShapeIndex i = 0; i < shapes_.size(); ++i) {
    const Shape& shape = shapes_[i];
    if (!shape.alive || bodies_[shape.body].acts_as == BodyType::fixed) continue;
    const Motion& motion = motions_[shape.body];
    const real turn =
        std::min(dt_ * std::abs(motion.spin), real(2));  // no point moves farther by turning than twice its reach
    const real margin = turn * shape.reach + fall_of(shape.body) + near_part * shape.hull.thickness;
    broad_phase_.move(i, shape, expanded(bounds(shape.hull, center_pose(shape.body)), margin), dt_ * motion.velocity);
  }
}

void World::drop_parted_contacts() {
  std::erase_if(contacts_, [this](const Contact& c) {
    if (broad_phase_.boxes_overlap(shapes_[c.shape_a], shapes_[c.shape_b])) return false;
    broad_phase_.forget({c.shape_a, c.shape_b});
    if (c.touching) separation_events_.push_back(separation_of(c));
    return true;
  });
}

void World::update_manifolds(std::vector<Contact>& contacts) {
  const Foresight foresight{dt_, on(Effect::ccd), accelerations_};
  for (Contact& contact : contacts) {
    if (contact.sensor && !on(Effect::sensors)) continue;
    if (hinged_together(contact.body_a, contact.body_b)) {
      contact.manifold.count = 0;
      continue;
    }
    update_manifold(contact, shapes_, bodies_, motions_, foresight);
  }
}

void World::bounce(real h) {
  const real resting_speed = h * length(effective_gravity());
  resolve_impacts(contact_solver_.constraints(), accelerations_, motions_, h, resting_speed, on(Effect::friction),
                  contact_solver_.surface_speeds());
}

void World::fly_all() {
  fly({accelerations_, drags_, wind_in_force()}, method_.integrator, substeps_, h_, bodies_, motions_);
}

/// By gravity, and by what commands ask for during this tick.
void World::accelerate(real h) {
  for (BodyIndex i = 0; i < accelerations_.size(); ++i) motions_[i].velocity += h * accelerations_[i];
  for (const Push& push : pushed_) motions_[push.body].spin += h * (motions_[push.body].inv_inertia * push.torque);
}

void World::kick_springs(real h) {
  for (Joint& joint : joints_) {
    if (joint.acts && is_springy(joint.kind)) kick_spring(joint, bodies_, motions_, h);
  }
}

void World::damp_springs(real h) {
  for (Joint& joint : joints_) {
    if (joint.acts && is_springy(joint.kind)) damp_spring(joint, bodies_, motions_, h);
  }
}

void World::pull_all(real h) {
  for (Joint& joint : joints_) {
    if (joint.acts && joint.kind == JointKind::drag_to) booked_work_ += pull(joint, bodies_, motions_, h);
  }
}

/// What a rocket does is work from outside: its fuel holds energy that nobody counts.
void World::burn_rockets(real h) {
  for (Rocket& rocket : rockets_) {
    if (rocket.fuel <= 0) continue;
    const double before = potential_energy();
    booked_work_ += burn(rocket, bodies_[rocket.body], motions_[rocket.body], h);
    booked_work_ += potential_energy() - before;
  }
}

void World::drag_all(real h) {
  const Vec2 wind = wind_in_force();
  for (BodyIndex i = 1; i < drags_.size(); ++i) {
    if (drags_[i].acts()) apply_drag(motions_[i], drags_[i], wind, h);
  }
}

void World::drift_all(real h) { drift(motions_, h); }

}  // namespace PROOFREEL_PRECISION
}  // namespace proofreel
