/// Rope: a rod that cannot push.
///
///   C = length - |p_b - p_a| >= 0,    lambda >= 0        one row (m)
///
/// Slack, it is not there at all; taut, it is a rod. What pulls it taut loses the speed along it, as with a rope that
/// does not stretch.

#include "engine/joints/kinds.h"

namespace proofreel {
inline namespace PROOFREEL_PRECISION {

void plan_rope(const Joint& joint, RowsWanted wanted, RowPlans& rows) {
  if (wanted.limits) rows.push_back({Coordinate::stretch, Bound::at_least, -1, joint.length});
}

}  // namespace PROOFREEL_PRECISION
}  // namespace proofreel
