#include "engine/rolling.h"

#include <algorithm>

#include "engine/contact_solver.h"

namespace proofreel {
inline namespace PROOFREEL_PRECISION {
namespace {

void turn_apart(const RollingRows::Row& row, std::vector<Motion>& motions, real impulse) {
  motions[row.body_a].spin -= motions[row.body_a].inv_inertia * impulse;
  motions[row.body_b].spin += motions[row.body_b].inv_inertia * impulse;
}

}  // namespace

void RollingRows::prepare(const std::vector<Contact>& contacts, const std::vector<ContactConstraint>& constraints,
                          const std::vector<Motion>& motions) {
  rows_.clear();
  for (std::uint32_t i = 0; i < constraints.size(); ++i) {
    const ContactConstraint& c = constraints[i];
    const Contact& contact = contacts[c.contact];
    const real inverse = motions[c.body_a].inv_inertia + motions[c.body_b].inv_inertia;
    if (contact.rolling_resistance <= 0 || inverse <= 0) continue;
    rows_.push_back({i, c.body_a, c.body_b, contact.rolling_resistance, 1 / inverse, contact.rolling_impulse, 0, 0});
  }
}

void RollingRows::begin_substep() {
  for (Row& row : rows_) {
    row.warm = row.impulse;
    row.impulse = 0;
  }
}

void RollingRows::add_share(std::vector<Motion>& motions, real share) {
  for (Row& row : rows_) {
    row.impulse += share * row.warm;
    turn_apart(row, motions, share * row.warm);
  }
}

void RollingRows::sweep(const std::vector<ContactConstraint>& constraints, std::vector<Motion>& motions) {
  for (Row& row : rows_) {
    const ContactConstraint& c = constraints[row.constraint];
    if (c.exact) continue;
    real pressed = 0;
    for (int k = 0; k < c.count; ++k) pressed += c.points[k].normal_impulse;
    const real rolling = motions[row.body_b].spin - motions[row.body_a].spin;
    const real limit = row.lever * pressed;
    const real impulse = std::clamp(row.impulse - row.inertia * rolling, -limit, limit);
    turn_apart(row, motions, impulse - row.impulse);
    row.impulse = impulse;
  }
}

void RollingRows::end_substep() {
  for (Row& row : rows_) row.total += row.impulse;
}

void RollingRows::store(const std::vector<ContactConstraint>& constraints, std::vector<Contact>& contacts) const {
  for (const Row& row : rows_) contacts[constraints[row.constraint].contact].rolling_impulse = row.impulse;
}

}  // namespace PROOFREEL_PRECISION
}  // namespace proofreel
