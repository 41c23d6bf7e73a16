#pragma once

/// Rigid joints as they are taught: one row after the other gets the impulse that it needs at the moment, which
/// disturbs its neighbours, and so again and again (projected Gauss-Seidel; "sequential impulses", Catto, GDC 2006).
/// Where a joint is open already, a part of the gap is closed by velocity (Baumgarte 1972). Cheap, simple, and slow to
/// converge along chains and between unequal masses: compare with joint_group.h.

#include "engine/contact_solver.h"
#include "engine/joint_rows.h"

namespace proofreel {
inline namespace PROOFREEL_PRECISION {

/// How often a substep goes through the rows, before the drift and after it, and how stiff the springs are that close
/// gaps, in oscillations per substep. What a spring gives under load falls with the square of its stiffness; but what
/// it pushes too much has to be swept out again, and one sweep alone carries no more than 0.18 in the loops of a net.
struct SweepPlan {
  int sweeps = 1;
  real stiffness = real(0.125);
};
/// Nets that are too large for the direct solver: under their load they open by an eighth, for up to twice the
/// price.
inline constexpr SweepPlan sweeps_of_nets{4, real(0.35)};

class JointSweeps {
 public:
  explicit JointSweeps(SweepPlan plan) : plan_(plan) {}
  /// Makes the rows of those of these joints that act. Call also when some fall asleep or wake.
  void rebuild(const std::vector<Joint>& joints, const std::vector<std::uint32_t>& ids, RowsWanted wanted);
  bool empty() const { return rows_.empty(); }
  std::size_t row_count() const { return rows_.size(); }
  /// Takes directions from the present positions. Call after every drift.
  void linearize(const JointedBodies& scene);
  /// Starts a substep: applies `share` of the impulses of the one before.
  void begin_substep(const JointedBodies& scene, real share);
  /// Adds the other share before velocities are solved.
  void add_share(const JointedBodies& scene, real share);
  /// Sweeps that also close gaps.
  void solve_positions(const JointedBodies& scene, real h);
  /// Sweeps for the velocities alone.
  void solve_velocities(const JointedBodies& scene, real h);
  /// What motors and moving kinematic bodies have put in since the last call, J.
  double take_work(const JointedBodies& scene);

 private:
  struct Row {
    std::uint32_t joint = 0;
    std::size_t slot = 0;  ///< in the joint's memory
    RowPlan plan;
    Terms terms;
    real mass = 0;   ///< effective
    real value = 0;  ///< C
    real warm = 0;   ///< impulse of the substep before
    real given = 0;  ///< impulse of this one so far
    real total = 0;  ///< impulse since work was last taken
  };

  void solve(Row& row, const Softness& soft, const JointedBodies& scene, real h);
  void apply(Row& row, real impulse, const JointedBodies& scene);

  SweepPlan plan_;
  std::vector<Row> rows_;
  double work_ = 0;
};

}  // namespace PROOFREEL_PRECISION
}  // namespace proofreel
