// What is kept of a tick when it is over: the work done from outside, joints that broke, contacts that began, numbers
// that are none.

#include <algorithm>
#include <cmath>

#include "engine/world.h"

namespace proofreel {
inline namespace PROOFREEL_PRECISION {

/// What went into the bodies from outside during the tick: forces of commands, and whatever a moving kinematic body
/// pushed.
void World::book_work() {
  for (const Push& push : pushed_) {
    const real turned_by = motions_[push.body].angle - push.angle_before;
    booked_work_ += static_cast<double>(dot(push.force, motions_[push.body].delta) + push.torque * turned_by);
  }
  const auto book = [this](BodyIndex pusher, Vec2 impulse, Vec2 arm) {
    if (bodies_[pusher].type != BodyType::kinematic) return;
    booked_work_ += static_cast<double>(dot(impulse, motions_[pusher].velocity_at(arm)));
  };
  book_surfaces();
  if (on(Effect::contacts)) {
    for (const ContactConstraint& c : contact_solver_.constraints()) {
      for (int k = 0; k < c.count; ++k) {
        const ConstraintPoint& p = c.points[k];
        const Vec2 on_b = p.normal_total * c.normal + p.tangent_total * perp(c.normal);
        book(c.body_a, on_b, p.arm_a);
        book(c.body_b, -on_b, p.arm_b);
      }
    }
  }
  for (const Joint& joint : joints_) {
    if (!joint.alive || joint.soft_impulse == Vec2{}) continue;
    const JointPlace place = place_of(joint, bodies_, motions_);
    book(joint.body_a, joint.soft_impulse, place.arm_a + place.gap);
    book(joint.body_b, -joint.soft_impulse, place.arm_b);
  }
  if (on(Effect::joints)) booked_work_ += joint_solver_.take_work(jointed());
}

/// Of whatever moves a kinematic body that attracts: it gives what the others are pulled after it with.
double World::work_of_center(const AttractorDef& attractor, Vec2 impulse) const {
  const auto center = static_cast<BodyIndex>(attractor.body.value_or(BodyId::world));
  return bodies_[center].type == BodyType::kinematic ? static_cast<double>(dot(impulse, motions_[center].velocity)) : 0;
}

/// By the reaction of the whole tick, which a single substep's jolt hardly moves. What a suspension holds is lost with
/// it, to nothing the energy counts.
void World::break_joints() {
  break_events_.clear();
  if (!on(Effect::breakage)) return;
  for (std::size_t i = 0; i < joints_.size(); ++i) {
    Joint& joint = joints_[i];
    const Vec2 reaction = static_cast<real>(rate_) * joint.impulse;
    if (!joint.alive || joint.break_force <= 0 || length(reaction) <= joint.break_force) continue;
    const Vec2 arm = place_of(joint, bodies_, motions_).arm_b;
    break_events_.push_back({static_cast<JointId>(i), Vec2d(bodies_[joint.body_b].center + arm), Vec2d(reaction)});
    if (on(Effect::springs) && is_springy(joint.kind)) booked_work_ -= stored_energy(joint, bodies_, motions_);
    remove_joint(i);
    joint.broken = true;
  }
}

ContactEvent World::event_of(const Contact& contact, real impulse) const {
  const ContactView view = view_of(contact);
  return {view.a,
          view.b,
          view.points[0].point,
          view.normal,
          static_cast<double>(impulse),
          std::max(static_cast<double>(contact.approach), 0.0)};
}

void World::collect_events() {
  if (!on(Effect::contacts)) return;
  for (Contact& contact : contacts_) {
    const bool before = contact.touching;
    real impulse = 0;
    contact.touching = false;
    for (int k = 0; k < contact.manifold.count; ++k) {
      contact.touching |= contact.manifold.points[k].separation <= 0 || contact.impulses[k].normal_total > 0;
      impulse += contact.impulses[k].normal_total;
    }
    if (contact.touching && !before) events_.push_back(event_of(contact, impulse));
    if (before && !contact.touching) separation_events_.push_back(separation_of(contact));
  }
}

void World::detect_failure() {
  if (diverged_) {
    failure_ = Failure{tick_, BodyId::world, "integration", "cannot be found: its equations do not converge"};
    return;
  }
  for (BodyIndex i = 0; i < bodies_.size(); ++i) {
    if (bodies_[i].type != BodyType::dynamic) continue;
    const Motion& m = motions_[i];
    const real energy = bodies_[i].mass * length_squared(m.velocity) + bodies_[i].inertia * m.spin * m.spin;
    if (is_finite(bodies_[i].center) && std::isfinite(energy) && std::isfinite(m.angle)) continue;
    failure_.emplace();
    failure_->tick = tick_;
    failure_->body = static_cast<BodyId>(i);
    failure_->stage = stage_of_failure(i);
    const bool overflowed = is_finite(bodies_[i].center) && is_finite(m.velocity) && std::isfinite(m.spin);
    if (overflowed && std::isfinite(m.angle)) failure_->what = "became too fast for its energy to be a number";
    return;
  }
}

const char* World::stage_of_failure(BodyIndex body) const {
  for (const Joint& joint : joints_) {
    const bool here = joint.body_a == body || joint.body_b == body;
    if (here && !is_finite(joint.impulse)) return is_soft(joint.kind) ? "springs" : "joints";
  }
  for (const Contact& contact : contacts_) {
    if (contact.body_a != body && contact.body_b != body) continue;
    for (const PointImpulse& p : contact.impulses) {
      if (!std::isfinite(p.normal) || !std::isfinite(p.tangent)) return "contacts";
    }
  }
  return "integration";
}

}  // namespace PROOFREEL_PRECISION
}  // namespace proofreel
