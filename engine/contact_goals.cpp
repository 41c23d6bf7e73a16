#include "engine/contact_goals.h"

#include <algorithm>
#include <cmath>

namespace proofreel {
inline namespace PROOFREEL_PRECISION {

const ContactGoals::Later& ContactGoals::later(BodyIndex body, const std::vector<Motion>& motions, real h) {
  Later& found = later_[body];
  if (found.call == call_) return found;
  Motion moved = motions[body];
  drift(moved, h);
  found = {call_, moved.delta, moved.rotation};
  return found;
}

/// Cores turn about their centres, roundings roll off: their points of contact are others all the time.
void ContactGoals::find_ways(const ContactConstraint& c, const std::vector<Motion>& motions, real h) {
  const Motion& a = motions[c.body_a];
  const Motion& b = motions[c.body_b];
  const Later& later_a = later(c.body_a, motions, h);
  const Later& later_b = later(c.body_b, motions, h);
  const real rolled = h * (c.radius_a * a.spin + c.radius_b * b.spin);
  for (int k = 0; k < c.count; ++k) {
    const ConstraintPoint& p = c.points[k];
    const Vec2 now = (b.delta - a.delta) + rotate(b.rotation, p.local_b) - rotate(a.rotation, p.local_a);
    const Vec2 after =
        (later_b.delta - later_a.delta) + rotate(later_b.rotation, p.local_b) - rotate(later_a.rotation, p.local_a);
    ways_[k] = {p.base_separation + dot(now, c.normal), p.base_separation + dot(after, c.normal),
                dot(after - now, perp(c.normal)) - rolled};
  }
}

real ContactGoals::set(std::vector<ContactRow>& rows, const ContactSolver& contacts, const std::vector<Motion>& motions,
                       real h, bool closed_only) {
  const std::vector<real>& belts = contacts.surface_speeds();
  real largest = 0;
  later_.resize(motions.size());
  ++call_;
  for (ContactRow& row : rows) {
    if (row.kind != RowKind::gap && row.kind != RowKind::slip) continue;
    const ContactConstraint& c = contacts.constraints()[row.constraint];
    if (row.kind == RowKind::gap && row.place == 0) find_ways(c, motions, h);  // a contact's gaps come first
    const Way& way = ways_[row.place];
    const ConstraintPoint& p = c.points[row.place];
    row.expected = row.kind == RowKind::gap ? p.normal_impulse : p.tangent_impulse;
    row.closed = row.kind == RowKind::gap && way.gap <= c.closed;
    const real straight = speed_of(row.term, motions);
    const real before = row.bias;
    if (row.kind == RowKind::gap) {
      row.off = closed_only && way.gap > c.closed;
      row.bias = std::max(way.gap_after / h - straight, -push_rate * c.length);
    } else {
      row.bias = way.slide / h - straight - (belts.empty() ? real(0) : belts[row.constraint]);
    }
    if (!row.off && way.gap <= c.closed) largest = std::max(largest, h * std::abs(row.bias - before) / c.closed);
  }
  return largest;
}

}  // namespace PROOFREEL_PRECISION
}  // namespace proofreel
