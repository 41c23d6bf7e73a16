// The contact solver "event": impacts at their own times. A substep is tried out; if something has met on the way, it
// is taken back and made only until then, the impacts of that moment change the velocities, and the rest of the substep
// follows. What touches already rests and slides as the exact solver says.

#include <algorithm>
#include <cmath>
#include <limits>

#include "engine/closing.h"
#include "engine/impact.h"
#include "engine/world.h"

namespace proofreel {
inline namespace PROOFREEL_PRECISION {
namespace {

/// A ball that bounces lower and lower bounces infinitely often before it rests (Zeno). After so many impacts within a
/// substep what is left of it is made as if nothing bounced any more.
constexpr int most_impacts = 500;
/// Below this part of what gravity gives in a substep nothing bounces: a ball has come to rest.
constexpr real resting_part = real(1e-3);

}  // namespace

void World::pass_impacts(real h) {
  real left = h;
  for (int impacts = 0; left > 0; ++impacts) {
    begin_portion();
    locating_ = impacts < most_impacts;
    if (locating_ && on(Effect::restitution)) bounce_what_touches(h);
    look_ahead();  // what was struck may fly elsewhere now
    const Trial before = keep_state();
    substep(left);
    const real impact = locating_ ? first_impact(before.motions, left) : left;
    if (impact < left) {
      go_back_to(before);
      if (impact > 0) substep(impact);
    }
    end_portion();
    left = impact < left ? left - impact : 0;
  }
}

/// Contacts as they are at this moment. No pair is dropped before the tick is over: those that have met are told then.
void World::begin_portion() {
  look_ahead();
  timed(StepStage::narrow_phase, [this] { update_manifolds(contacts_); });
  prepare_solvers();
}

/// A gap that is closed: next to nothing beside the shapes, and no less than coordinates can tell.
real World::closed_gap(const Contact& contact) const {
  constexpr real epsilon = std::numeric_limits<real>::epsilon();
  constexpr real part = sizeof(real) == sizeof(double) ? real(1e-9) : real(1e-6);
  const auto size = [this](BodyIndex body, ShapeIndex shape) {
    const Vec2 center = bodies_[body].center;
    return std::abs(center.x) + std::abs(center.y) + shapes_[shape].reach;
  };
  const real sizes = size(contact.body_a, contact.shape_a) + size(contact.body_b, contact.shape_b);
  return part * pair_length(shapes_[contact.shape_a], shapes_[contact.shape_b]) + 4 * epsilon * sizes;
}

void World::look_ahead() {
  timed(StepStage::broad_phase, [this] {
    update_boxes();
    add_new_pairs();
  });
}

World::Trial World::keep_state() const { return {motions_, joints_, joint_solver_, contact_solver_, booked_work_}; }

void World::go_back_to(const Trial& trial) {
  motions_ = trial.motions;
  joints_ = trial.joints;
  joint_solver_ = trial.joint_solver;
  contact_solver_ = trial.contact_solver;
  booked_work_ = trial.booked_work;
}

/// Every one of these impacts is told, however many of them a pair has within a tick.
void World::bounce_what_touches(real h) {
  for (ContactConstraint& c : contact_solver_.constraints()) {
    for (int k = 0; k < c.count; ++k) {
      const auto gap = [&] { return separation_of(c, c.points[k], motions_[c.body_a], motions_[c.body_b]); };
      if (gap() > c.closed) continue;
      c.points[k].base_separation -= std::max(gap(), real(0));
      if (gap() > 0) c.points[k].base_separation -= 2 * gap();  // what rounding has left
    }
  }
  for (Contact& contact : contacts_) {
    if (contact.manifold.count == 0) continue;
    contact.approach = approach_speed(contact, motions_[contact.body_a], motions_[contact.body_b]);
  }
  const real resting_speed = resting_part * h * length(effective_gravity());
  timed(StepStage::restitution, [&] {
    resolve_impacts(contact_solver_.constraints(), accelerations_, motions_, 0, resting_speed, on(Effect::friction),
                    contact_solver_.surface_speeds());
  });
  for (const ContactConstraint& c : contact_solver_.constraints()) {
    const real impulse = c.points[0].normal_total + c.points[1].normal_total;
    if (impulse <= 0) continue;
    events_.push_back(event_of(contacts_[c.contact], impulse));
    contacts_[c.contact].touching = true;
  }
}

/// Books and keeps what the portion has done, and lets the next one start from where the bodies are.
void World::end_portion() {
  book_work();
  for (Push& push : pushed_) push.angle_before = motions_[push.body].angle;
  for (Joint& joint : joints_) joint.soft_impulse = {};
  contact_solver_.store(contacts_);
  touches_.resize(contacts_.size());
  for (std::size_t i = 0; i < contacts_.size(); ++i) add_touch(touches_[i], contacts_[i]);
  for (Contact& contact : contacts_) {
    for (PointImpulse& impulse : contact.impulses) impulse.normal_total = impulse.tangent_total = 0;
  }
  take_positions();
}

/// The impulses of one contact during the tick, at the points where it pressed last.
void World::add_touch(Touch& touch, const Contact& contact) {
  const auto pressed = [&contact](int k) { return contact.impulses[k].normal_total > 0; };
  if (contact.manifold.count == 0 || !(pressed(0) || pressed(1))) return;
  Touch sum{contact.manifold, {contact.impulses[0], contact.impulses[1]}};
  for (int k = 0; k < touch.manifold.count; ++k) {
    const bool second = sum.manifold.count > 1 && sum.manifold.points[1].feature == touch.manifold.points[k].feature;
    sum.impulses[second ? 1 : 0].normal_total += touch.impulses[k].normal_total;
    sum.impulses[second ? 1 : 0].tangent_total += touch.impulses[k].tangent_total;
  }
  touch = sum;
}

/// After a tick contacts tell all that happened during it, also those that have parted again.
void World::show_touches() {
  for (std::size_t i = 0; i < touches_.size(); ++i) {
    const Touch& touch = touches_[i];
    Contact& contact = contacts_[i];
    if (touch.manifold.count == 0) continue;
    if (contact.manifold.count == 0) contact.manifold = touch.manifold;
    for (int k = 0; k < 2; ++k) {
      contact.impulses[k].normal_total = touch.impulses[k].normal_total;
      contact.impulses[k].tangent_total = touch.impulses[k].tangent_total;
    }
  }
  touches_.clear();
}

/// Seconds until something meets that did not touch before; infinite when nothing does within `span`.
real World::first_impact(const std::vector<Motion>& before, real span) const {
  std::vector<const ContactConstraint*> constraint_of(contacts_.size());
  for (const ContactConstraint& c : contact_solver_.constraints()) constraint_of[c.contact] = &c;
  real first = std::numeric_limits<real>::infinity();
  for (std::size_t i = 0; i < contacts_.size(); ++i) {
    const Contact& contact = contacts_[i];
    if (contact.sensor || hinged_together(contact.body_a, contact.body_b)) continue;
    const Flight a(before[contact.body_a], motions_[contact.body_a], span);
    const Flight b(before[contact.body_b], motions_[contact.body_b], span);
    first = std::min(first, time_of_contact(contact, constraint_of[i], a, b, std::min(span, first)));
  }
  return first;
}

/// Of a pair that touches already the points that are open yet may close; of any other pair all of the outlines.
real World::time_of_contact(const Contact& contact, const ContactConstraint* constraint, const Flight& a,
                            const Flight& b, real span) const {
  const Shape& shape_a = shapes_[contact.shape_a];
  const Shape& shape_b = shapes_[contact.shape_b];
  const real speed = length(b.velocity() - a.velocity()) + span * length(b.acceleration() - a.acceleration()) +
                     shape_a.reach * a.fastest_turn(span) + shape_b.reach * b.fastest_turn(span);
  const real closed = closed_gap(contact);
  real first = std::numeric_limits<real>::infinity();
  bool touches = false;
  for (int k = 0; constraint != nullptr && k < constraint->count; ++k) {
    const auto gap = [&](real t) { return separation_of(*constraint, constraint->points[k], a.at(t), b.at(t)); };
    touches |= gap(0) <= closed;
    if (gap(0) > closed) first = std::min(first, time_of_closing(gap, speed, span, closed));
  }
  if (touches) return first;
  const auto pose = [this](BodyIndex body, const Motion& m) {
    return Pose{bodies_[body].center + m.delta, m.rotation};
  };
  const auto gap = [&](real t) {
    return gap_between(shape_a, pose(contact.body_a, a.at(t)), shape_b, pose(contact.body_b, b.at(t)),
                       2 * span * speed + closed);
  };
  return time_of_closing(gap, speed, span, closed);
}

}  // namespace PROOFREEL_PRECISION
}  // namespace proofreel
