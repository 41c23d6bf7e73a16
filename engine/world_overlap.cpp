// Bodies that were put inside each other come apart at a bounded speed, however many of them there are: not by
// velocities, which add up from body to body and stay, but by position, and none of them faster than push_rate.

#include <algorithm>

#include "engine/world.h"

namespace proofreel {
inline namespace PROOFREEL_PRECISION {

bool World::is_settling() const {
  const auto parts = [](const Contact& contact) { return contact.parting; };
  const auto is_open = [this](const Joint& joint) {
    constexpr real open_part = real(1e-3);
    return joint.alive && !is_soft(joint.kind) && violation(joint, joints_, bodies_, motions_) > open_part * joint.size;
  };
  return std::any_of(contacts_.begin(), contacts_.end(), parts) ||
         (on(Effect::joints) && std::any_of(joints_.begin(), joints_.end(), is_open));
}

/// The part of the way from `before` to now that keeps every body within its speed: of two that part, the thinner one's
/// push_rate; of all that is moved by them, the fastest of these. The same part for all, since bodies that leave each
/// other as they should do so on any part of the way.
real World::speed_limit_of_parting(const std::vector<Motion>& before, real h) const {
  std::vector<real> limits(bodies_.size(), 0);
  real highest = 0;
  for (const ContactConstraint& c : contact_solver_.constraints()) {
    if (c.push_speed > 0) continue;
    const real limit = push_rate * c.length * h;
    for (const BodyIndex i : {c.body_a, c.body_b}) limits[i] = limits[i] > 0 ? std::min(limits[i], limit) : limit;
    highest = std::max(highest, limit);
  }
  real part = 1;
  for (BodyIndex i = 1; i < bodies_.size(); ++i) {
    const real limit = limits[i] > 0 ? limits[i] : highest;
    const real way = length(motions_[i].delta - before[i].delta);
    if (way * part > limit) part = limit / way;
  }
  return part;
}

/// What hangs on rigid joints is driven out by velocities, as ever: moving it would open them.
void World::part_jointed_by_velocity() {
  const std::vector<std::uint8_t> jointed = jointed_bodies();
  for (ContactConstraint& c : contact_solver_.constraints()) {
    if (jointed[c.body_a] != 0 || jointed[c.body_b] != 0) c.push_speed = push_rate * c.length;
  }
  contact_solver_.look_for_overlaps();
}

/// What lifts them is work from outside: nobody could have put them there without.
void World::part_overlaps(real h) {
  const std::vector<Motion> before = motions_;
  const double energy_before = potential_energy();
  contact_solver_.part(motions_, h);
  const real part = speed_limit_of_parting(before, h);
  const std::vector<std::uint8_t> jointed = jointed_bodies();
  for (BodyIndex i = 1; i < bodies_.size(); ++i) {
    Motion& m = motions_[i];
    if (jointed[i] != 0) m = before[i];
    const real turn = part * (m.angle - before[i].angle);
    m.delta = before[i].delta + part * (m.delta - before[i].delta);
    m.rotation = turned(before[i].rotation, turn);
    m.angle = before[i].angle + turn;
  }
  booked_work_ += potential_energy() - energy_before;
}

}  // namespace PROOFREEL_PRECISION
}  // namespace proofreel
