/// Weld: two bodies as one. A pin (revolute.cpp) that does not turn:
///
///   C1, C2 = p_b - p_a = 0                                    (m)
///   C3 = angle_b - angle_a - angle at the start = 0           (rad)
///   dC3/dt = w_b - w_a: a pure torque, no force along anything

#include "engine/joints/kinds.h"

namespace proofreel {
inline namespace PROOFREEL_PRECISION {

Term turn_term(const Joint& joint) { return {joint.body_a, joint.body_b, {}, 1, 1}; }

void plan_weld(RowPlans& rows) {
  rows.push_back({Coordinate::anchor_x});
  rows.push_back({Coordinate::anchor_y});
  rows.push_back({Coordinate::turn});
}

}  // namespace PROOFREEL_PRECISION
}  // namespace proofreel
