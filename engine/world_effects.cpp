// Water, force fields, and surfaces that move or resist rolling: what these effects do in a step, and the work they put
// into the scene.

#include "engine/world.h"

namespace proofreel {
inline namespace PROOFREEL_PRECISION {

/// At the begin and at the end of a substep's way; lifting and wading in between change velocities only.
void World::look_at_water() {
  if (!water_) return;
  wetted_.assign(bodies_.size(), {});
  for (BodyIndex i = 1; i < bodies_.size(); ++i) {
    if (bodies_[i].acts_as == BodyType::dynamic) wetted_[i] = wetted_part(*water_, bodies_[i], motions_[i], shapes_);
  }
}

void World::float_all(std::vector<Motion>& motions, real h) const {
  const auto gravity = -static_cast<double>(effective_gravity().y);
  if (!water_ || gravity <= 0) return;
  for (BodyIndex i = 1; i < bodies_.size(); ++i) lift(motions[i], *water_, wetted_[i], gravity, h);
}

void World::wade_all(real h) {
  if (!water_ || water_->drag <= 0) return;
  for (BodyIndex i = 1; i < bodies_.size(); ++i) resist(motions_[i], *water_, wetted_[i], h);
}

double World::potential_of_water() const {
  const auto gravity = -static_cast<double>(effective_gravity().y);
  if (!water_ || gravity <= 0) return 0;
  double sum = 0;
  for (BodyIndex i = 1; i < bodies_.size(); ++i) {
    if (bodies_[i].type != BodyType::dynamic) continue;
    const double depth = water_->level - static_cast<double>(bodies_[i].center.y + motions_[i].delta.y);
    sum += water_potential(*water_, wetted_part(*water_, bodies_[i], motions_[i], shapes_), depth, gravity);
  }
  return sum;
}

double World::field_time() const {
  const std::int64_t substeps = (tick_ - 1) * substeps_ + drifts_;
  return static_cast<double>(substeps) / (static_cast<double>(rate_) * substeps_);
}

void World::book_fields(real h, real share) {
  ++drifts_;
  booked_work_ += static_cast<double>(share) * fields_.drifted(motions_, h);
}

/// Under verlet the kick at the end of a drift completes the work along it.
void World::finish_fields(real h) {
  booked_work_ += 0.5 * fields_.kick_at_end(bodies_, motions_, field_time(), real(0.5) * h);
}

/// A belt's motor gives what friction takes from one side and does not give to the other: impulse times belt speed.
/// What a kinematic body turns against rolling resistance is work as well.
void World::book_surfaces() {
  const std::vector<real>& speeds = contact_solver_.surface_speeds();
  for (std::size_t i = 0; i < speeds.size(); ++i) {
    const ContactConstraint& c = contact_solver_.constraints()[i];
    for (int k = 0; k < c.count; ++k) booked_work_ += static_cast<double>(c.points[k].tangent_total * speeds[i]);
  }
  for (const RollingRows::Row& row : contact_solver_.rolling()) {
    if (bodies_[row.body_a].type == BodyType::kinematic)
      booked_work_ += static_cast<double>(row.total * motions_[row.body_a].spin);
    if (bodies_[row.body_b].type == BodyType::kinematic)
      booked_work_ -= static_cast<double>(row.total * motions_[row.body_b].spin);
  }
}

}  // namespace PROOFREEL_PRECISION
}  // namespace proofreel
