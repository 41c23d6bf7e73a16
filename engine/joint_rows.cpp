#include "engine/joint_rows.h"

#include "engine/joints/kinds.h"

namespace proofreel {
inline namespace PROOFREEL_PRECISION {

std::vector<RowPlan> plan_rows(const Joint& joint, RowsWanted wanted) {
  RowPlans rows;
  switch (joint.kind) {
    case JointKind::revolute:
      plan_revolute(joint, wanted, rows);
      break;
    case JointKind::distance:
      plan_distance(joint, rows);
      break;
    case JointKind::rope:
      plan_rope(joint, wanted, rows);
      break;
    case JointKind::prismatic:
      plan_prismatic(joint, wanted, rows);
      break;
    case JointKind::weld:
      plan_weld(rows);
      break;
    case JointKind::wheel:
      plan_wheel(joint, wanted, rows);
      break;
    case JointKind::gear:
      plan_gear(joint, rows);
      break;
    case JointKind::pulley:
      plan_pulley(joint, rows);
      break;
    case JointKind::motor:
      plan_motor(joint, wanted, rows);
      break;
    case JointKind::spring:
    case JointKind::drag_to:
      break;
  }
  return rows;
}

Terms terms_of(Coordinate coordinate, const Joint& joint, const JointPlace& place, const JointedBodies& scene) {
  switch (coordinate) {
    case Coordinate::anchor_x:
      return {{anchor_term(joint, place, {1, 0}), {}}, 1};
    case Coordinate::anchor_y:
      return {{anchor_term(joint, place, {0, 1}), {}}, 1};
    case Coordinate::stretch:
      return {{stretch_term(joint, place), {}}, 1};
    case Coordinate::across:
      return {{axis_term(joint, place, perp(place.axis)), {}}, 1};
    case Coordinate::along:
      return {{axis_term(joint, place, place.axis), {}}, 1};
    case Coordinate::turn:
      return {{turn_term(joint), {}}, 1};
    case Coordinate::carried_x:
      return {{carried_term(joint, place, {1, 0}), {}}, 1};
    case Coordinate::carried_y:
      return {{carried_term(joint, place, {0, 1}), {}}, 1};
    case Coordinate::geared:
      return gear_terms(joint, scene);
    case Coordinate::roped:
      return pulley_terms(joint, place);
  }
  return {};
}

Terms bodies_of(const Joint& joint, const std::vector<Joint>& joints) {
  const auto pair = [](BodyIndex a, BodyIndex b) { return Term{a, b, {}, 0, 0}; };
  if (joint.kind == JointKind::pulley) return {{pair(0, joint.body_a), pair(0, joint.body_b)}, 2};
  if (joint.kind != JointKind::gear) return {{pair(joint.body_a, joint.body_b), {}}, 1};
  const Joint& first = joints[joint.first];
  const Joint& second = joints[joint.second];
  return {{pair(first.body_a, first.body_b), pair(second.body_a, second.body_b)}, 2};
}

}  // namespace PROOFREEL_PRECISION
}  // namespace proofreel
