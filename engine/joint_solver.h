#pragma once

/// Rigid joints, solved directly, group by group (joint_group.h), with the rows of each group numbered along its chains
/// so that the factors stay sparse.
///
/// In time it is RATTLE (Andersen 1983): the velocities at the start of a substep get just the impulses that make the
/// positions at its end obey the joints, and after the second half of the forces the velocities are made to obey them
/// too. Second order, time-reversible, and free of energy drift.

#include <vector>

#include "engine/joint_group.h"

namespace proofreel {
inline namespace PROOFREEL_PRECISION {

class JointSolver {
 public:
  /// Groups and numbers the rows anew. Call when joints or bodies come or go.
  void rebuild(const std::vector<Joint>& joints, const std::vector<Motion>& motions, RowsWanted wanted);
  bool empty() const { return groups_.empty(); }
  /// Takes directions and effective masses from the present positions. Call after every drift.
  void linearize(const JointedBodies& scene);
  /// Starts a substep of `h` from the impulses of the one before; `share` of the forces comes before the drift.
  void begin_substep(const JointedBodies& scene, real h, real share);
  /// Adds the other share of the motors' impulses. Call before the contacts relax.
  void add_share(const JointedBodies& scene);
  /// Changes velocities so that drifting for `h` ends on the joints.
  void solve_positions(const JointedBodies& scene, real h);
  /// Changes velocities so that no joint is opening, and motors run at their speeds.
  void solve_velocities(const JointedBodies& scene, real h);
  /// What motors and moving kinematic bodies have put in since the last call, J.
  double take_work(const JointedBodies& scene);

 private:
  std::vector<JointGroup> groups_;
};

}  // namespace PROOFREEL_PRECISION
}  // namespace proofreel
