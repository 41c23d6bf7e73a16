/// Gear: couples the coordinates of two other joints, the angle of a revolute or the translation of a prismatic joint.
///
///   C = c1 + ratio * c2 - (what it was at the start) = 0        one row (rad, or m)
///   dC/dt = dc1/dt + ratio * dc2/dt
///
/// so its directions are those of the two coordinates side by side, and up to four bodies feel it. Ratio 1 turns the
/// second wheel backwards as fast as the first one forwards, as two equal toothed wheels do; a rack and a pinion of
/// radius r are a prismatic and a revolute joint with ratio r.

#include "engine/joints/kinds.h"

namespace proofreel {
inline namespace PROOFREEL_PRECISION {
namespace {

real coordinate_of(const Joint& joint, const std::vector<Body>& bodies, const std::vector<Motion>& motions,
                   real ahead) {
  Motion a = motions[joint.body_a];
  Motion b = motions[joint.body_b];
  if (ahead != 0) {
    drift(a, ahead);
    drift(b, ahead);
  }
  const JointPlace place = place_of(joint, bodies, a, b);
  return joint.kind == JointKind::prismatic ? along(place) : place.turn;
}

Term coordinate_term(const Joint& joint, const JointedBodies& scene) {
  if (joint.kind != JointKind::prismatic) return turn_term(joint);
  const JointPlace place = place_of(joint, scene.bodies, scene.motions);
  return axis_term(joint, place, place.axis);
}

}  // namespace

real geared(const Joint& gear, const std::vector<Joint>& joints, const std::vector<Body>& bodies,
            const std::vector<Motion>& motions, real ahead) {
  return coordinate_of(joints[gear.first], bodies, motions, ahead) +
         gear.ratio * coordinate_of(joints[gear.second], bodies, motions, ahead);
}

Terms gear_terms(const Joint& joint, const JointedBodies& scene) {
  Terms t;
  t.count = 2;
  t.terms[0] = coordinate_term(scene.joints[joint.first], scene);
  t.terms[1] = coordinate_term(scene.joints[joint.second], scene);
  t.terms[1].direction *= joint.ratio;
  t.terms[1].arm_a *= joint.ratio;
  t.terms[1].arm_b *= joint.ratio;
  return t;
}

void plan_gear(const Joint& joint, RowPlans& rows) {
  rows.push_back({Coordinate::geared, Bound::equal, 1, joint.offset});
}

}  // namespace PROOFREEL_PRECISION
}  // namespace proofreel
