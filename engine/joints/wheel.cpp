/// Wheel: b on the chassis a, free to turn, sprung along an axis u that is fixed in a.
///
///   C = n . (p_b - p_a) = 0        across the axis (m), as of a prismatic joint
///   force on b along u: -stiffness * x - damping * dx/dt,    x = u . (p_b - p_a)
///
/// The spring is at rest where the joint was made; a body of mass m on it sags by m g / stiffness. The motor drives the
/// wheel's spin against the chassis.

#include "engine/joints/kinds.h"

namespace proofreel {
inline namespace PROOFREEL_PRECISION {

void plan_wheel(const Joint& joint, RowsWanted wanted, RowPlans& rows) {
  rows.push_back({Coordinate::across});
  if (wanted.motors && joint.motor) rows.push_back({Coordinate::turn, Bound::driven});
}

}  // namespace PROOFREEL_PRECISION
}  // namespace proofreel
