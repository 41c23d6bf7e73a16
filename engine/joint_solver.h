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

  // All groups, one after the other; what each of these does is told in joint_group.h.
  void linearize(const JointedBodies& scene);
  void begin_substep(const JointedBodies& scene, real h, real share);
  void add_share(const JointedBodies& scene);
  void solve_positions(const JointedBodies& scene, real h);
  void solve_velocities(const JointedBodies& scene, real h);
  double take_work(const JointedBodies& scene);

 private:
  std::vector<JointGroup> groups_;
};

}  // namespace PROOFREEL_PRECISION
}  // namespace proofreel
