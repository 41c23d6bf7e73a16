/// Pulley: a rope from a over two fixed pins to b, with `ratio` falls of rope on b's side (a block and tackle).
///
///   C = |p_a - pin_a| + ratio * |p_b - pin_b| - (what it was at the start) = 0        one row (m)
///   dC/dt = u_a . (velocity of anchor a) + ratio * u_b . (velocity of anchor b)
///
/// u lead from the pins to the anchors. The rope is held taut throughout: it pulls a by its tension and b by ratio
/// times as much, so that two weights hang at rest when m_b = ratio * m_a.

#include "engine/joints/kinds.h"

namespace proofreel {
inline namespace PROOFREEL_PRECISION {
namespace {

/// The world is what the rope runs against; it does not move.
Term rope_term(BodyIndex body, Vec2 arm, Vec2 rope, real falls) {
  const Vec2 direction = falls * normalized(rope);
  return {0, body, direction, 0, cross(arm, direction)};
}

}  // namespace

real roped(const Joint& pulley, const JointPlace& place) {
  return length(place.rope_a) + pulley.ratio * length(place.rope_b);
}

Terms pulley_terms(const Joint& joint, const JointPlace& place) {
  Terms t;
  t.count = 2;
  t.terms[0] = rope_term(joint.body_a, place.arm_a, place.rope_a, 1);
  t.terms[1] = rope_term(joint.body_b, place.arm_b, place.rope_b, joint.ratio);
  return t;
}

void plan_pulley(const Joint& joint, RowPlans& rows) {
  rows.push_back({Coordinate::roped, Bound::equal, 1, joint.offset});
}

}  // namespace PROOFREEL_PRECISION
}  // namespace proofreel
