#pragma once

/// Rigid joints as they are taught: one row after the other gets the impulse that it needs at the moment, which
/// disturbs its neighbours, and so again and again (projected Gauss-Seidel; "sequential impulses", Catto, GDC 2006).
/// Where a joint is open already, a part of the gap is closed by velocity (Baumgarte 1972). Cheap, simple, and slow to
/// converge along chains and between unequal masses: compare with joint_group.h. (The two rows of a pin are one.)

#include "engine/contact_solver.h"
#include "engine/joint_pins.h"
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
/// Nets that are too large for the direct solver: under their load they open by an eighth. A fourth sweep would not
/// make that less.
inline constexpr SweepPlan sweeps_of_nets{3, real(0.35)};

class JointSweeps {
 public:
  explicit JointSweeps(SweepPlan plan) : plan_(plan) {}
  /// Makes the rows of those of these joints that act. Call also when some fall asleep or wake.
  void rebuild(const std::vector<Joint>& joints, const std::vector<std::uint32_t>& ids, RowsWanted wanted);
  bool empty() const { return row_count() == 0; }
  std::size_t row_count() const { return rows_.size() + 2 * pins_.size(); }
  /// Looks where its anchors are. Call at the start of every tick, and then `linearize`.
  void begin_tick(const JointedBodies& scene) { pins_.begin_tick(scene); }
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
  /// What motors and moving kinematic bodies have put in since the last call, J. Joints of nets get to know their
  /// impulses by this: call at the end of every tick.
  double take_work(const JointedBodies& scene);

 private:
  /// What every sweep goes through: as little as it can be.
  struct Row {
    Term term;          ///< the first one
    real mass = 0;      ///< effective
    real value = 0;     ///< C
    real given = 0;     ///< impulse of this substep so far
    bool plain = true;  ///< an equation between two bodies; all else is in its source
  };
  /// The rest of a row.
  struct Source {
    std::uint32_t joint = 0;
    std::uint32_t slot = 0;  ///< in the joint's memory
    RowPlan plan;
    Terms terms;
    real warm = 0;    ///< impulse of the substep before
    real booked = 0;  ///< the part of the row's impulse that the joint knows of
    real total = 0;   ///< impulse since work was last taken
  };

  void linearize_row(std::size_t i, const Joint& joint, const JointPlace& place, const JointedBodies& scene);
  void solve(std::size_t i, const Softness& soft, const JointedBodies& scene, real h);
  static void solve_plain(Row& row, const Softness& soft, std::vector<Motion>& motions);
  void solve_bounded(std::size_t i, const Softness& soft, const JointedBodies& scene, real h);
  void apply(std::size_t i, real impulse, const JointedBodies& scene);
  void give_share(const JointedBodies& scene, real share);
  void book(const JointedBodies& scene);

  SweepPlan plan_;
  JointPins pins_;
  std::vector<Row> rows_;        ///< all other ones
  std::vector<Source> sources_;  ///< parallel to rows_
  double work_ = 0;
};

}  // namespace PROOFREEL_PRECISION
}  // namespace proofreel
