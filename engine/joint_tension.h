#pragma once

/// How fast what hangs in joints swings, which decides how short a substep has to be.
///
/// A light link under tension is a string: turned out of its line by an angle it is pulled back by the two forces F at
/// its ends, by sum (F . r) per radian, where r are the arms from its centre of mass. It swings about its middle with
///
///   omega^2 = sum (F . r) / I      (in a chain with tension T and links of length l: T l / I)
///
/// Positive F . r pull outwards. Rods and ropes turn themselves as well: across their line they hold a body by T /
/// length per metre. These forces come from the turning of the joints' directions (the geometric stiffness, second
/// derivatives of C times lambda), which an explicit projection such as RATTLE takes as they are at the start of a
/// substep. It is stable up to omega h = 2 and falls apart beyond, however exactly its rows are solved: 40 links that
/// swing 670 times the mass of each reach omega = 450 / s. (Tournier, Nesme, Gilles and Faure 2015, "Stable constrained
/// dynamics", have the matrix, and damp where we step finer: their chains hang quietly, ours keep their energy.)

#include "engine/joint.h"

namespace proofreel {
inline namespace PROOFREEL_PRECISION {

/// Those of a group's joints that hold by forces at their anchors, as they pulled during the last tick.
class JointTension {
 public:
  /// The fastest of these swings, rad/s, if `joints` pulled with their impulses for `dt` s: an upper bound, reached
  /// where links turn against each other. Only `ids` count that act.
  real fastest_swing(const std::vector<std::uint32_t>& ids, const JointedBodies& scene, real dt);

 private:
  /// Of one body, both in 1/s^2.
  struct Hold {
    real across = 0;  ///< by rods and ropes that turn
    real turning = 0;
  };
  void add(const Joint& joint, const JointedBodies& scene, real dt);
  void add_line(const Joint& joint, const JointPlace& place, real tension_per_length,
                const std::vector<Motion>& motions);

  std::vector<Hold> holds_;  ///< by body; scratch
};

}  // namespace PROOFREEL_PRECISION
}  // namespace proofreel
