#pragma once

/// Rigid joints that hang together through the bodies they move, solved directly: all their rows in one linear system,
/// factored exactly (no iteration to converge, whatever the masses). Groups share no moving body, so each is solved for
/// itself: what contradicts itself in one of them disturbs no other.
///
/// Rows with bounds (stops, ropes, motors) are solved by active sets: the system is solved with the rows that hold at
/// present, a row whose impulse leaves its bounds lets go (or gives all it has), a row that would be violated holds
/// again, until nothing changes. All that want to change do so at once; should that go round in circles, then only the
/// first one does, which is known to end (Murty 1974; together as Judice and Pires 1994).

#include <limits>

#include "engine/joint_rows.h"
#include "engine/skyline.h"

namespace proofreel {
inline namespace PROOFREEL_PRECISION {

class JointGroup {
 public:
  /// `ids` in the order in which their rows shall be numbered: neighbours close together.
  JointGroup(const std::vector<std::uint32_t>& ids, const std::vector<Joint>& joints,
             const std::vector<Motion>& motions, RowsWanted wanted);
  bool empty() const { return rows_.empty(); }
  /// Multiplications that solving it takes, about.
  double work() const { return matrix_.work(); }
  std::uint32_t first_joint() const { return rows_.front().joint; }
  /// Joints of one group sleep together.
  bool acts(const std::vector<Joint>& joints) const { return joints[rows_.front().joint].acts; }
  /// Takes directions from the present positions. Call after every drift.
  void linearize(const JointedBodies& scene);
  /// Starts a substep of `h` from the impulses of the one before; motors give the `share` of them that belongs before
  /// the drift.
  void begin_substep(const JointedBodies& scene, real h, real share);
  /// Motors give as much again as before the drift, as contacts do: contacts and joints have their say in turns, and
  /// what rests on a driven body has to see its motor hold.
  /// Call before the contacts relax.
  void add_share(const JointedBodies& scene);
  /// Changes velocities so that drifting for `h` ends on the joints.
  void solve_positions(const JointedBodies& scene, real h);
  /// Changes velocities so that no joint is opening, and motors run at their speeds.
  void solve_velocities(const JointedBodies& scene, real h);
  /// The least change of velocities after which the rows that held in the last stage stand still: how the joints answer
  /// to pushes on bodies at rest. Books nothing.
  void hold(std::vector<Motion>& motions) const;
  /// The bodies its joints move, in order.
  const std::vector<BodyIndex>& bodies() const { return bodies_; }
  /// What motors and moving kinematic bodies have put in since the last call, J.
  double take_work(const JointedBodies& scene);
  /// For archives (world_archive.cpp): what it remembers from tick to tick. All else is made anew in every substep, and
  /// the impulses lie in the joints.
  template <typename Archive, typename Self>
  static void exchange(Archive& archive, Self& group);

 private:
  struct Row {
    std::uint32_t joint = 0;
    std::size_t slot = 0;  ///< in the joint's memory
    RowPlan plan;
    Terms terms;
    bool on = true;        ///< it is part of the system
    bool touched = false;  ///< one-sided: it held at the start of the velocity stage
    int at_bound = 0;      ///< driven: gives all it has, forwards (1) or backwards (-1)
    real goal = 0;         ///< what is left of C after this substep
    real miss = 0;         ///< by how much C would end beside the goal
    real scale = 1;        ///< what `miss` is measured by
    real begun = 0;        ///< driven: impulse given before the drift
    real pushed = 0;       ///< impulse of the velocity stage
    real pushed_before = 0;
    real speed_before = 0;  ///< driven: when its impulse began to act
    real total = 0;         ///< impulse since work was last taken
  };
  /// Two rows that move a common body: the body's contribution to their matrix entry.
  struct Coupling {
    int row = 0;
    int column = 0;
    BodyIndex body = 0;
    std::uint8_t row_term = 0;
    std::uint8_t column_term = 0;
    bool row_is_b = false;
    bool column_is_b = false;
  };

  void couple(const std::vector<Motion>& motions);
  real entry(const Coupling& k, const std::vector<Motion>& motions) const;
  void assemble(const std::vector<Motion>& motions);
  void fill(const std::vector<Motion>& motions);
  real factor_with(real give);
  /// The system of the rows that hold in this stage; factored anew only where something has changed.
  void prepare(const JointedBodies& scene, bool for_velocities);
  bool holds(const Row& row, const JointedBodies& scene, bool for_velocities) const;

  RowMemory& memory(const Row& row, const JointedBodies& scene) const {
    return scene.joints[row.joint].memory[row.slot];
  }
  real scale_of(const Row& row, const JointedBodies& scene) const;
  void begin_motors(const JointedBodies& scene, real h, real share);
  void book_begun(const JointedBodies& scene);
  void apply(Row& row, real impulse, const JointedBodies& scene) const;

  // Positions (joint_group_positions.cpp).
  void set_goals(const JointedBodies& scene, real h);
  real predict(const JointedBodies& scene, real h);
  bool iterate(const JointedBodies& scene, real h);
  bool settle_positions(const JointedBodies& scene, bool one_at_a_time);
  void close_gently(const JointedBodies& scene, real h);
  bool has_mover(const JointedBodies& scene) const;
  bool drop_pulling_rows(const JointedBodies& scene);

  // Velocities (joint_group_velocities.cpp).
  void solve_bounded_velocities(const JointedBodies& scene, real h);
  bool any_bounded_row_on() const;
  void find_corrections(const JointedBodies& scene);
  void apply_corrections(const JointedBodies& scene);
  bool bound_corrections(const JointedBodies& scene, real h, bool one_at_a_time);
  bool engage_overrun_rows(const JointedBodies& scene, real h, bool one_at_a_time);

  std::vector<Row> rows_;
  std::vector<BodyIndex> bodies_;
  std::vector<Coupling> couplings_;
  SkylineMatrix matrix_;
  std::vector<real> right_side_;
  bool stale_ = true;       ///< directions have changed since the system was factored
  bool redundant_ = false;  ///< some rows follow from the others
  bool strained_ = false;   ///< a kinematic body pulls its joints apart in this substep
  int one_sided_ = 0;       ///< how many rows are
  int driven_ = 0;
  double work_ = 0;
};

/// What counts as nothing, relative to a row's scale.
inline constexpr real row_tolerance = 32 * std::numeric_limits<real>::epsilon();

/// After so many rounds of active sets only one row changes at a time.
inline constexpr int rounds_together = 8;
/// No more rounds than this for a group with so many bounded rows.
inline int most_rounds(int bounded_rows) { return rounds_together + 4 * bounded_rows; }

}  // namespace PROOFREEL_PRECISION
}  // namespace proofreel
