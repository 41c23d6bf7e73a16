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

namespace {

Terms terms_along(Coordinate coordinate, const Joint& joint, const JointPlace& place, const JointedBodies& scene) {
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

}  // namespace

real coordinate_of(const RowPlan& plan, const Joint& joint, const JointPlace& place, const JointedBodies& scene,
                   real ahead) {
  switch (plan.coordinate) {
    case Coordinate::anchor_x:
      return place.gap.x;
    case Coordinate::anchor_y:
      return place.gap.y;
    case Coordinate::stretch:
      return length(place.gap);
    case Coordinate::across:
      return across(place);
    case Coordinate::along:
      return along(place);
    case Coordinate::turn:
      return place.turn;
    case Coordinate::geared:
      return geared(joint, scene.joints, scene.bodies, scene.motions, ahead);
    case Coordinate::roped:
      return roped(joint, place);
    case Coordinate::carried_x:
    case Coordinate::carried_y:
      return 0;
  }
  return 0;
}

Terms terms_of(const RowPlan& plan, const Joint& joint, const JointPlace& place, const JointedBodies& scene) {
  Terms terms = terms_along(plan.coordinate, joint, place, scene);
  if (plan.sign > 0) return terms;
  for (Term& term : terms.terms) term = {term.body_a, term.body_b, -term.direction, -term.arm_a, -term.arm_b};
  return terms;
}

real driven_speed(const RowPlan& plan, const Joint& joint) {
  if (plan.coordinate == Coordinate::carried_x) return joint.velocity.x;
  if (plan.coordinate == Coordinate::carried_y) return joint.velocity.y;
  return joint.motor->speed;
}

real strongest(const RowPlan& plan, const Joint& joint) {
  const bool carries = plan.coordinate == Coordinate::carried_x || plan.coordinate == Coordinate::carried_y;
  return carries ? joint.max_force : joint.motor->strongest;
}

double work_of_movers(const Terms& terms, real impulse, const JointedBodies& scene) {
  const auto is_mover = [&](BodyIndex body) { return scene.bodies[body].type == BodyType::kinematic; };
  double work = 0;
  for (int t = 0; t < terms.count; ++t) {
    const Term& term = terms.terms[t];
    const Motion& a = scene.motions[term.body_a];
    const Motion& b = scene.motions[term.body_b];
    real speed = 0;
    if (is_mover(term.body_a)) speed += dot(a.velocity, term.direction) + term.arm_a * a.spin;
    if (is_mover(term.body_b)) speed -= dot(b.velocity, term.direction) + term.arm_b * b.spin;
    work += static_cast<double>(impulse * speed);
  }
  return work;
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
