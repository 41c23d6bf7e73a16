/// Prismatic: b slides along an axis u that is fixed in a, and does not turn against a.
///
///   C1 = n . (p_b - p_a) = 0,    n = u turned a quarter counter-clockwise        across the rail (m)
///   C2 = angle_b - angle_a - angle at the start = 0                              no turning (rad)
///
/// The axis turns with a, du/dt = w_a x u, which adds w_a cross(u, gap) to the derivative:
///   d(u . gap)/dt = u . (v_b - v_a) + w_b cross(r_b, u) - w_a cross(r_a + gap, u)
/// and the same with n. So the force on a acts where b's anchor is, not at a's own. What is left free is the
/// translation u . gap, positive along the axis: its stops and its motor act on that.

#include "engine/joints/kinds.h"

namespace proofreel {
inline namespace PROOFREEL_PRECISION {

Term axis_term(const Joint& joint, const JointPlace& place, Vec2 direction) {
  return {joint.body_a, joint.body_b, direction, cross(place.arm_a + place.gap, direction),
          cross(place.arm_b, direction)};
}

void plan_prismatic(const Joint& joint, RowsWanted wanted, RowPlans& rows) {
  rows.push_back({Coordinate::across});
  rows.push_back({Coordinate::turn});
  if (wanted.limits) plan_limits(joint, Coordinate::along, rows);
  if (wanted.motors && joint.motor) rows.push_back({Coordinate::along, Bound::driven});
}

}  // namespace PROOFREEL_PRECISION
}  // namespace proofreel
