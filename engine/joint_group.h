#pragma once

/// Rigid joints that hang together through the bodies they move, solved directly: all their rows in one linear system,
/// factored exactly (no iteration to converge, whatever the masses). Groups share no moving body, so each is solved for
/// itself: what contradicts itself in one of them disturbs no other.
///
/// Rows with bounds (stops, ropes, motors) are solved by active sets: the system is solved with the rows that hold at
/// present, a row whose impulse leaves its bounds lets go (or gives all it has), a row that would be violated holds
/// again, until nothing changes. All that want to change do so at once; should that go round in circles, then only the
/// first one does, which is known to end (Murty 1974; together as Judice and Pires 1994). Rows that do not hold have no
/// place in the system: a stop costs next to nothing until it is reached.

#include <limits>
#include <span>

#include "engine/block_matrix.h"
#include "engine/joint_rows.h"

namespace proofreel {
inline namespace PROOFREEL_PRECISION {

/// A stop or a rope as one problem with others: its speed plus `bias` is not to be negative, nor is its impulse.
struct Stop {
  std::size_t row = 0;
  Term term;
  real bias = 0;
  real given = 0;  ///< impulse so far
};

class JointGroup {
 public:
  JointGroup() = default;
  /// `ids` in the order in which their rows shall be eliminated: leaves first.
  JointGroup(const std::vector<std::uint32_t>& ids, const std::vector<Joint>& joints,
             const std::vector<Motion>& motions, RowsWanted wanted);
  bool empty() const { return rows_.empty(); }
  /// Solving it would take too many multiplications: it is a large net, and of no use as a group.
  bool too_dense() const { return too_dense_; }
  std::uint32_t first_joint() const { return rows_.front().joint; }
  /// Joints of one group sleep together.
  bool acts(const std::vector<Joint>& joints) const { return joints[rows_.front().joint].acts; }
  /// Looks where its anchors are, and whether it has its say in turns with contacts: `overlapping` are the bodies
  /// that sweeps of contacts drive out of something. Call at the start of every tick, and then `linearize`.
  void begin_tick(const JointedBodies& scene, std::span<const std::uint8_t> overlapping);
  /// Takes directions from the present positions. Call after every drift, and at the start of a tick.
  void linearize(const JointedBodies& scene);
  /// Starts a substep of `h` from the impulses of the one before; motors, or all rows in turns with contacts, give the
  /// `share` of them that belongs before the drift.
  void begin_substep(const JointedBodies& scene, real h, real share);
  /// Motors, or all rows in turns with contacts, give as much again as they began with, as contacts do: what rests on
  /// a driven body has to see its motor hold, and what lies under a jointed one how it is loaded.
  /// Call before the contacts relax.
  void add_share(const JointedBodies& scene);
  /// Changes velocities so that drifting for `h` ends on the joints. True when joints were too far open for that: then
  /// their bodies have been moved.
  bool solve_positions(const JointedBodies& scene, real h);
  /// Puts the bodies back to where they were when they were moved last, and forgets it.
  void take_back_moves(std::vector<Motion>& motions);
  /// Changes velocities so that no joint is opening, and motors run at their speeds.
  void solve_velocities(const JointedBodies& scene, real h);
  /// Decides what the next substep starts from, where contacts have their say, too.
  void end_substep(const JointedBodies& scene);
  /// The least change of velocities after which the rows that held in the last stage stand still: how the joints answer
  /// to pushes on bodies at rest. Books nothing.
  void hold(std::vector<Motion>& motions) const;
  /// Whether some of its rows only push: stops and ropes.
  bool has_stops() const { return one_sided_ > 0; }
  std::size_t stop_count() const { return static_cast<std::size_t>(one_sided_); }
  // For those who solve stops together with what else presses (exact_contacts.h), after the group itself has.
  /// All its stops let go in the system, so that `hold` answers without them.
  void release_stops(const JointedBodies& scene);
  /// The stops that hold or might be reached by drifting for `h`.
  void find_stops(const JointedBodies& scene, real h, std::vector<Stop>& stops);
  /// The stops that held at the drift.
  void find_touched_stops(const JointedBodies& scene, std::vector<Stop>& stops) const;
  /// The bodies have been pushed by this impulse instead of the one it had: before the drift, or after it.
  void set_stop(const Stop& stop, real impulse, bool after_drift, const JointedBodies& scene);
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
    std::uint32_t slot = 0;  ///< in the joint's memory
    std::uint32_t link = 0;
    RowPlan plan;
    Terms terms;
    bool on = true;        ///< it is part of the system
    bool touched = false;  ///< one-sided: it held at the drift
    int at_bound = 0;      ///< driven: gives all it has, forwards (1) or backwards (-1)
    real value = 0;        ///< C at the start of this substep
    real goal = 0;         ///< what is left of C after this substep
    real scale = 1;        ///< what is missed of it is measured by
    real begun = 0;        ///< impulse it has started the substep with, and gives again after the drift
    real pushed = 0;       ///< impulse of the velocity stage
    real pushed_before = 0;
    real speed_before = 0;  ///< driven: when its impulse began to act
    real asked = 0;         ///< driven: the speed to run at, with what it has to catch up; 0 for all others
    real drifted = 0;       ///< driven: the mean speed of the last drift
    bool counted = true;    ///< driven: what it missed in that drift is
    real given = 0;         ///< impulse of this substep
    real total = 0;         ///< impulse since work was last taken
  };
  /// The rows of one joint: a block of the matrix.
  struct Link {
    std::uint32_t joint = 0;
    int first_row = 0;
    int row_count = 0;
    int place_a = 0;  ///< of its bodies in `seen_`
    int place_b = 0;
    BodyIndex body_a = 0;
    BodyIndex body_b = 0;
    Anchors anchors;     ///< in this tick
    bool plain = false;  ///< it has neither axis nor ropes
    bool pin = false;    ///< its first two rows are those of a pin, which always hold
  };
  /// One body as a joint moves it.
  struct Side {
    int link = 0;
    std::size_t side = 0;  ///< a and b of the first term of its rows, a and b of the second
  };
  /// Two joints that move a common body: the body's contribution to a block of the matrix.
  struct Coupling {
    Side row;
    Side column;
    BodyIndex body = 0;
    int place = 0;  ///< of the block
    // As the rows are numbered at present.
    int rows = 0;
    int columns = 0;
    std::size_t row_levers = 0;  ///< the first one's place in `levers_`
    std::size_t column_levers = 0;
    BlockMatrix::Spot spot;
  };

  struct InverseMass {
    real inv_mass = 0;
    real inv_inertia = 0;
  };

  void add_link(std::uint32_t id, const std::vector<Joint>& joints, RowsWanted wanted);

  // The system (joint_group_system.cpp).
  void couple(const std::vector<Motion>& motions);
  void plan_matrix();
  void switch_row(Row& row, bool on);
  void number_rows();
  void assemble(const std::vector<Motion>& motions);
  void find_levers();
  void find_spots();
  void fill(const std::vector<Motion>& motions);
  std::size_t place_of_levers(std::size_t side, int row) const {
    return 3 * side * rows_.size() + static_cast<std::size_t>(row);
  }
  real factor_with(real give);
  /// The system of the rows that hold in this stage; factored anew only where something has changed.
  void prepare(const JointedBodies& scene, bool for_velocities);
  bool holds(const Row& row, const JointedBodies& scene, bool for_velocities) const;
  /// Since the system was factored. (A tick begins where the last one ended: mostly its system serves on.)
  bool masses_changed(const std::vector<Motion>& motions) const;

  std::span<Row> rows_of(const Link& link) {
    return {rows_.data() + link.first_row, static_cast<std::size_t>(link.row_count)};
  }
  /// The row with this number in the system.
  Row& on_row(std::size_t k) { return rows_[static_cast<std::size_t>(on_[k])]; }
  const Row& on_row(std::size_t k) const { return rows_[static_cast<std::size_t>(on_[k])]; }
  RowMemory& memory(const Row& row, const JointedBodies& scene) const {
    return scene.joints[row.joint].memory[row.slot];
  }
  real scale_of(const Row& row, const JointedBodies& scene) const;
  void begin_row(Row& row, const JointedBodies& scene);
  void begin_motors(const JointedBodies& scene, real h, real share);
  void book_begun(const JointedBodies& scene);
  void apply(Row& row, real impulse, const JointedBodies& scene) const {
    push(row.terms, impulse, scene.motions);
    row.given += impulse;
  }
  /// Where the joint of a link stands when its bodies are where `a` and `b` are.
  JointPlace place_on(const Link& link, const JointedBodies& scene, const Motion& a, const Motion& b) const {
    JointPlace place = place_of(link.anchors, a, b);
    if (!link.plain) add_axis_and_ropes(place, scene.joints[link.joint], scene.bodies, a, b);
    return place;
  }
  bool follow(Row& row, const JointPlace& place, const Motion& a, const Motion& b);
  void linearize_row(Row& row, const Joint& joint, const JointPlace& place, const JointedBodies& scene);
  void direct(Row& row, const Joint& joint, const JointPlace& place, const JointedBodies& scene);
  real miss_of(const Row& row, const JointedBodies& scene, real h) const {
    return value_of(row.plan, scene.joints[row.joint], ahead_places_[row.link], scene, h) - row.goal;
  }
  void book_reactions(const JointedBodies& scene);

  // Positions (joint_group_positions.cpp).
  bool set_goals(const JointedBodies& scene, real h);
  real predict(const JointedBodies& scene, real h);
  void look_ahead(const Link& link, const JointedBodies& scene, JointPlace& place) const;
  real aim(real h);
  bool iterate(const JointedBodies& scene, real h);
  bool settle_positions(const JointedBodies& scene, real h, bool one_at_a_time);
  bool arrive_evenly(const JointedBodies& scene, real h);
  void close_gently(const JointedBodies& scene, real h);
  bool has_mover(const JointedBodies& scene) const;
  bool drop_pulling_rows(const JointedBodies& scene);

  // Gaps (joint_group_closing.cpp).
  real longest_way(const JointedBodies& scene) const;
  bool close_by_moving(const JointedBodies& scene, real h);
  void keep_goals(const JointedBodies& scene, real h);
  void move_to_goals(const JointedBodies& scene);
  void stiffen(const JointedBodies& scene);

  // Velocities (joint_group_velocities.cpp).
  void solve_bounded_velocities(const JointedBodies& scene, real h);
  void note_speeds(const JointedBodies& scene, real h);
  void ask_speed(Row& row, const JointedBodies& scene, real h);
  void book_motors(const JointedBodies& scene);
  void find_corrections(const JointedBodies& scene);
  void apply_corrections(const JointedBodies& scene);
  bool bound_corrections(const JointedBodies& scene, real h, bool one_at_a_time);
  bool engage_overrun_rows(const JointedBodies& scene, real h, bool one_at_a_time);

  std::vector<Row> rows_;
  std::vector<Link> links_;    ///< in the order of their rows
  std::vector<int> bounded_;   ///< the rows that have bounds
  std::vector<int> on_;        ///< the rows that the system was made of, in its order
  std::vector<int> links_on_;  ///< how many of them each link has
  std::vector<BodyIndex> bodies_;
  std::vector<BodyIndex> seen_;             ///< these, and what they hang on
  std::vector<Motion> ahead_;               ///< where all that is seen will be
  std::vector<JointPlace> ahead_places_;    ///< and the joints of all links
  std::vector<InverseMass> factored_with_;  ///< of `bodies_`, when the system was factored
  std::vector<Coupling> couplings_;
  BlockMatrix matrix_;
  std::vector<real> levers_;      ///< how its rows push: x, y and arm of all rows on their first side, then on the next
  std::vector<real> right_side_;  ///< by the numbers of the system, in whole lanes
  std::vector<real> scales_;      ///< scratch: of the same rows
  bool too_dense_ = false;
  bool renumber_ = true;    ///< other rows hold than when the system was made
  bool stale_ = true;       ///< directions or masses have changed since the system was factored
  bool redundant_ = false;  ///< some rows follow from the others
  bool uneven_ = false;     ///< they seem to, but it is the masses that differ
  bool strained_ = false;   ///< a kinematic body pulls its joints apart in this substep
  bool in_turns_ = false;   ///< with contacts, in this tick; it has no motors then
  real share_ = 1;          ///< of an impulse that belongs before the drift
  int equal_ = 0;           ///< how many rows are
  int one_sided_ = 0;
  int driven_ = 0;
  double work_ = 0;
  std::vector<Motion> moved_from_;  ///< its bodies, before joints were closed by moving them
};

/// What counts as nothing, relative to a row's scale.
inline constexpr real row_tolerance = 32 * std::numeric_limits<real>::epsilon();

/// A joint that starts torn is closed at this many times its own size per second, gently instead of within one substep.
inline constexpr real closing_rate = 4;

/// After so many rounds of active sets only one row changes at a time.
inline constexpr int rounds_together = 8;
/// No more rounds than this for a group with so many bounded rows.
inline int most_rounds(int bounded_rows) { return rounds_together + 4 * bounded_rows; }

}  // namespace PROOFREEL_PRECISION
}  // namespace proofreel
