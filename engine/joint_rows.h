#pragma once

/// Every rigid joint comes down to rows: one row is one number with a bound on the force that keeps it, so that one
/// solver serves all joints.
///
/// A row's number C (its coordinate) changes at the rate dC/dt = J v, linear in the velocities of the bodies; its
/// impulse lambda pushes them by M^-1 J^T lambda, along the very same directions, so that it does no work as long as C
/// stays (d'Alembert 1743). Three bounds are enough:
///   equal     C = 0, lambda as it comes:      pins, rods, rails, gears
///   at_least  C >= 0, lambda >= 0, and one of the two is 0 (Signorini 1933):      stops, ropes
///   driven    J v = speed, |lambda| <= strongest * time:      motors, which steer velocities and never positions

#include "engine/joint.h"

namespace proofreel {
inline namespace PROOFREEL_PRECISION {

/// The numbers that rows keep.
enum class Coordinate : std::uint8_t {
  anchor_x,  ///< of the gap between the anchors, m
  anchor_y,
  stretch,    ///< distance of the anchors, m
  across,     ///< of the gap, across the axis of a, m
  along,      ///< of the gap, along the axis of a, m
  turn,       ///< angle of b against a, rad
  carried_x,  ///< only a speed: of b's centre as seen from a, m/s
  carried_y,
  geared,  ///< two other joints' coordinates, coupled
  roped    ///< two ropes' lengths, coupled, m
};

enum class Bound : std::uint8_t { equal, at_least, driven };

/// What a joint asks of the solver: sign * (coordinate - offset) is kept within its bound.
struct RowPlan {
  Coordinate coordinate{};
  Bound bound = Bound::equal;
  real sign = 1;
  real offset = 0;
};

/// The joint's rows in a fixed order. Stops and motors only where they are wanted.
struct RowsWanted {
  bool limits = true;
  bool motors = true;
};
std::vector<RowPlan> plan_rows(const Joint& joint, RowsWanted wanted);

/// One pair of bodies in a row: it sees b move against a along `direction`, and turn.
struct Term {
  BodyIndex body_a = 0;
  BodyIndex body_b = 0;
  Vec2 direction;  ///< of the force on b
  real arm_a = 0;  ///< torque about the centre of mass per unit of force, a's with the opposite sign
  real arm_b = 0;

  bool operator==(const Term&) const = default;
};

inline real speed_of(const Term& t, const std::vector<Motion>& motions) {
  const Motion& a = motions[t.body_a];
  const Motion& b = motions[t.body_b];
  return dot(b.velocity - a.velocity, t.direction) + t.arm_b * b.spin - t.arm_a * a.spin;
}

inline void push(const Term& t, real impulse, std::vector<Motion>& motions) {
  Motion& a = motions[t.body_a];
  Motion& b = motions[t.body_b];
  a.velocity -= impulse * a.inv_mass * t.direction;
  a.spin -= impulse * a.inv_inertia * t.arm_a;
  b.velocity += impulse * b.inv_mass * t.direction;
  b.spin += impulse * b.inv_inertia * t.arm_b;
}

/// The pairs of bodies a coordinate sees: one, but for gears and pulleys.
struct Terms {
  Term terms[2];
  int count = 1;

  bool operator==(const Terms& other) const {
    return count == other.count && terms[0] == other.terms[0] && (count == 1 || terms[1] == other.terms[1]);
  }
};

inline real speed_of(const Terms& terms, const std::vector<Motion>& motions) {
  const real speed = speed_of(terms.terms[0], motions);
  return terms.count == 1 ? speed : speed + speed_of(terms.terms[1], motions);
}

inline void push(const Terms& terms, real impulse, std::vector<Motion>& motions) {
  push(terms.terms[0], impulse, motions);
  if (terms.count > 1) push(terms.terms[1], impulse, motions);
}

/// dC/dt of a row, from where the joint stands.
Terms terms_of(const RowPlan& plan, const Joint& joint, const JointPlace& place, const JointedBodies& scene);

/// The number a row keeps: at the place that the joint has or, what is not seen from there, `ahead` seconds from now.
real coordinate_of(const RowPlan& plan, const Joint& joint, const JointPlace& place, const JointedBodies& scene,
                   real ahead);

/// C of a row. Most rows are those of pins, and of rods.
inline real value_of(const RowPlan& plan, const Joint& joint, const JointPlace& place, const JointedBodies& scene,
                     real ahead) {
  const real now = plan.coordinate == Coordinate::anchor_x   ? place.gap.x
                   : plan.coordinate == Coordinate::anchor_y ? place.gap.y
                   : plan.coordinate == Coordinate::turn     ? place.turn
                   : plan.coordinate == Coordinate::stretch  ? length(place.gap)
                                                             : coordinate_of(plan, joint, place, scene, ahead);
  return plan.sign * (now - plan.offset);
}

/// The speed a driven row is to have.
real driven_speed(const RowPlan& plan, const Joint& joint);
/// The speed a row is to have: 0 unless it is driven.
inline real wanted_speed(const RowPlan& plan, const Joint& joint) {
  return plan.bound == Bound::driven ? driven_speed(plan, joint) : real(0);
}
/// The most that a driven row may give, N or N m.
real strongest(const RowPlan& plan, const Joint& joint);

/// The joint keeps a row's impulse for its reaction.
inline void book_reaction(Joint& joint, const Terms& terms, real impulse) {
  const Term& on_b = terms.terms[terms.count - 1];
  joint.impulse += impulse * on_b.direction;
  if (on_b.direction == Vec2{}) joint.twist += impulse * on_b.arm_b;
}

/// A kinematic body goes its way whatever pushes back: what it pushes the others with is work, J.
double work_of_movers(const Terms& terms, real impulse, const JointedBodies& scene);

/// The bodies its terms move, without looking where they are.
Terms bodies_of(const Joint& joint, const std::vector<Joint>& joints);

}  // namespace PROOFREEL_PRECISION
}  // namespace proofreel
