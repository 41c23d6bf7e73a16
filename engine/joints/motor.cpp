/// Motor: drives b against a and holds nothing. Velocity rows only:
///
///   (v_b - v_a - w_a x (c_b - c_a)) . d = velocity . d    for d = x and y,    |lambda| <= max_force * time (each axis)
///   w_b - w_a = speed,                                                        |lambda| <= max_torque * time
///
/// c are the centres of mass: the velocity is that of b's centre as seen by somebody who turns with a. Seen so, force
/// and counterforce act at one point, b's centre, and the angular momentum of the pair is kept.

#include "engine/joints/kinds.h"

namespace proofreel {
inline namespace PROOFREEL_PRECISION {

Term carried_term(const Joint& joint, const JointPlace& place, Vec2 direction) {
  return {joint.body_a, joint.body_b, direction, cross(place.centers, direction), 0};
}

void plan_motor(const Joint& joint, RowsWanted wanted, RowPlans& rows) {
  if (!wanted.motors) return;
  if (joint.max_force > 0) {
    rows.push_back({Coordinate::carried_x, Bound::driven});
    rows.push_back({Coordinate::carried_y, Bound::driven});
  }
  if (joint.motor) rows.push_back({Coordinate::turn, Bound::driven});
}

}  // namespace PROOFREEL_PRECISION
}  // namespace proofreel
