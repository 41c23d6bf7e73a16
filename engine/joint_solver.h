#pragma once

/// Rigid joints, solved directly, group by group (joint_group.h), with the rows of each group numbered along its chains
/// so that the factors stay sparse.
///
/// In time it is RATTLE (Andersen 1983): the velocities at the start of a substep get just the impulses that make the
/// positions at its end obey the joints, and after the second half of the forces the velocities are made to obey them
/// too. Second order, time-reversible, and free of energy drift.

#include <vector>

#include "engine/joint_group.h"
#include "engine/joint_sweeps.h"
#include "engine/joint_tension.h"

namespace proofreel {
inline namespace PROOFREEL_PRECISION {

/// Or row by row (joint_sweeps.h): where the method wants it, and of large nets, which are meshes of joints and no
/// chains: their factors fill up, and the time they take grows with the fourth power of a net's side.
class JointSolver {
 public:
  explicit JointSolver(JointMethod method)
      : method_(method), sweeps_(method == JointMethod::direct ? sweeps_of_nets : SweepPlan{}) {}
  /// Groups and numbers the rows anew. Call when joints or bodies come or go.
  void rebuild(const std::vector<Joint>& joints, const std::vector<Motion>& motions, RowsWanted wanted);
  /// Lays the groups of sleepers aside and takes up those that have woken.
  void lay_aside_sleepers(const std::vector<Joint>& joints);
  bool empty() const { return groups_.empty() && sweeps_.empty(); }

  /// Whether any row is solved one by one: by choice, or because it belongs to a large net.
  bool sweeps() const { return !sweeps_.empty(); }
  /// How many rows are solved one by one although the method is direct.
  std::size_t rows_of_nets() const { return method_ == JointMethod::direct ? sweeps_.row_count() : 0; }

  /// How fast the swings are that the direct solver has to follow, rad/s (joint_tension.h), by what its joints gave
  /// during the last tick of `dt` seconds. Swept joints are soft and follow nothing.
  real fastest_swing(const JointedBodies& scene, real dt);

  // One group of the direct solver: who is in it, and how it answers (joint_group.h).
  std::size_t group_count() const { return groups_.size(); }
  std::size_t stops_of(std::size_t group) const { return groups_[group].stop_count(); }
  const std::vector<BodyIndex>& bodies_of(std::size_t group) const { return groups_[group].bodies(); }
  void hold(std::size_t group, std::vector<Motion>& motions) const { groups_[group].hold(motions); }
  JointGroup& group(std::size_t group) { return groups_[group]; }

  // All joints; what each of these does is told in joint_group.h.
  void begin_tick(const JointedBodies& scene, std::span<const std::uint8_t> overlapping);
  void linearize(const JointedBodies& scene);
  void begin_substep(const JointedBodies& scene, real h, real share);
  void add_share(const JointedBodies& scene, real share);
  bool solve_positions(const JointedBodies& scene, real h);
  void take_back_moves(std::vector<Motion>& motions);
  void solve_velocities(const JointedBodies& scene, real h);
  void end_substep(const JointedBodies& scene);
  double take_work(const JointedBodies& scene);
  /// For archives (world_archive.cpp): what it remembers from tick to tick, its groups being made already.
  template <typename Archive, typename Self>
  static void exchange(Archive& archive, Self& solver);

 private:
  JointMethod method_;
  RowsWanted wanted_;
  std::vector<JointGroup> groups_;     ///< direct
  std::vector<JointGroup> asleep_;     ///< the groups of sleepers
  std::vector<std::uint32_t> direct_;  ///< the joints of all groups
  std::vector<std::uint32_t> swept_;   ///< the joints that are solved row by row
  JointSweeps sweeps_;
  JointTension tension_;
};

}  // namespace PROOFREEL_PRECISION
}  // namespace proofreel
