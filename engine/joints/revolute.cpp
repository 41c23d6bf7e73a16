/// Revolute: a pin through both bodies.
///
///   C = p_b - p_a = 0        two rows, for x and y (m)
///   dC/dt = (v_b + w_b x r_b) - (v_a + w_a x r_a)
///
/// r are the arms from the centres of mass to the anchors. Along a direction d the spins count by cross(r, d), since
/// (w x r) . d = w cross(r, d). What is left free is the angle of b against a, counter-clockwise positive: its stops
/// and its motor act on that (weld.cpp has its row).

#include "engine/joints/kinds.h"

namespace proofreel {
inline namespace PROOFREEL_PRECISION {

Term anchor_term(const Joint& joint, const JointPlace& place, Vec2 direction) {
  return {joint.body_a, joint.body_b, direction, cross(place.arm_a, direction), cross(place.arm_b, direction)};
}

void plan_revolute(const Joint& joint, RowsWanted wanted, RowPlans& rows) {
  rows.push_back({Coordinate::anchor_x});
  rows.push_back({Coordinate::anchor_y});
  if (wanted.limits) plan_limits(joint, Coordinate::turn, rows);
  if (wanted.motors && joint.motor) rows.push_back({Coordinate::turn, Bound::driven});
}

/// The upper stop looks at upper - coordinate: both stops then read C >= 0 and push by lambda >= 0. What meets a stop
/// stays there (no restitution), so that a stop never adds energy.
void plan_limits(const Joint& joint, Coordinate coordinate, RowPlans& rows) {
  if (!joint.limits) return;
  if (joint.limits->lower == joint.limits->upper) {
    rows.push_back({coordinate, Bound::equal, 1, joint.limits->lower});
    return;
  }
  rows.push_back({coordinate, Bound::at_least, 1, joint.limits->lower});
  rows.push_back({coordinate, Bound::at_least, -1, joint.limits->upper});
}

}  // namespace PROOFREEL_PRECISION
}  // namespace proofreel
