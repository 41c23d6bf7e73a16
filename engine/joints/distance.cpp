/// Distance: a massless rod between two anchors.
///
///   C = |p_b - p_a| - length = 0        one row (m)
///   dC/dt = u . (velocity of anchor b - velocity of anchor a),    u = (p_b - p_a) / |p_b - p_a|
///
/// The derivative of a length is the speed along it. A rod pushes as well as it pulls; lambda > 0 pushes.

#include "engine/joints/kinds.h"

namespace proofreel {
inline namespace PROOFREEL_PRECISION {

Term stretch_term(const Joint& joint, const JointPlace& place) {
  return anchor_term(joint, place, normalized(place.gap));
}

void plan_distance(const Joint& joint, RowPlans& rows) {
  rows.push_back({Coordinate::stretch, Bound::equal, 1, joint.length});
}

}  // namespace PROOFREEL_PRECISION
}  // namespace proofreel
