#include "engine/contact_goals.h"

#include <algorithm>
#include <cmath>

namespace proofreel {
inline namespace PROOFREEL_PRECISION {
namespace {

/// A point's gap now and after drifting on for a while, and how far the surfaces slide along each other meanwhile.
struct Way {
  real gap = 0;
  real gap_after = 0;
  real slide = 0;
};

/// Cores turn about their centres, roundings roll off: their points of contact are others all the time.
class Ways {
 public:
  Ways(const std::vector<Motion>& motions, real h) : motions_(motions), h_(h) {}

  /// Those of a contact's points, in turn; good until the next call.
  const Way* of(const ContactConstraint& c) {
    const Motion& a = motions_[c.body_a];
    const Motion& b = motions_[c.body_b];
    Motion later_a = a;
    Motion later_b = b;
    drift(later_a, h_);
    drift(later_b, h_);
    const real rolled = h_ * (c.radius_a * a.spin + c.radius_b * b.spin);
    for (int k = 0; k < c.count; ++k) {
      const Vec2 now = apart(c.points[k], a, b);
      const Vec2 after = apart(c.points[k], later_a, later_b);
      ways_[k] = {c.points[k].base_separation + dot(now, c.normal), c.points[k].base_separation + dot(after, c.normal),
                  dot(after - now, perp(c.normal)) - rolled};
    }
    return ways_;
  }

 private:
  static Vec2 apart(const ConstraintPoint& p, const Motion& a, const Motion& b) {
    return (b.delta - a.delta) + rotate(b.rotation, p.local_b) - rotate(a.rotation, p.local_a);
  }

  const std::vector<Motion>& motions_;
  real h_;
  Way ways_[2];
};

}  // namespace

real set_goals(std::vector<ContactRow>& rows, const ContactSolver& contacts, const std::vector<Motion>& motions, real h,
               bool closed_only) {
  const std::vector<real>& belts = contacts.surface_speeds();
  real largest = 0;
  Ways finder(motions, h);
  const Way* ways = nullptr;
  for (ContactRow& row : rows) {
    if (row.kind != RowKind::gap && row.kind != RowKind::slip) continue;
    const ContactConstraint& c = contacts.constraints()[row.constraint];
    if (row.kind == RowKind::gap && row.place == 0) ways = finder.of(c);  // a contact's gaps come first
    const Way& way = ways[row.place];
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
