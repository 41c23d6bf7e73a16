#pragma once

/// The impulses of a group of contacts by Newton's method. Pivoting (lcp.h) takes time in proportion to the cube of the
/// rows; this takes one sparse factorisation among the bodies, and none at all where nothing has changed.
///
/// The unknowns are not the impulses, of which a wall of bricks has more than equations (any of them may carry), but
/// the velocities. Give every row a stiff spring that starts from an impulse l0: at speed u it presses with
///     l(u) = l0 - r u,   cut off at 0 for a gap, at -mu N and +mu N for friction,
/// and the velocities v obey  M (v - v0) = J^T (l(J v) - l0).  That is the minimum of a convex function made of pieces
/// of parabolas, and Newton's method with a line search finds it in a few steps (as MuJoCo does: Todorov 2014). Then
/// l0 becomes l, and again: what the springs give way with disappears after a few such rounds (the method of
/// multipliers: Hestenes, Powell 1969), and with it every trace of r. The bounds mu N follow the impulses from round to
/// round (Haslinger 1983).
///
/// Which rows act changes from step to step, mostly by few of many. The factors then serve on, and conjugate gradients
/// make up for the rows that differ, unless new factors would be had sooner.
///
/// All in double precision whatever the engine's, with velocities in units in which every body has mass 1.

#include <vector>

#include "engine/block_matrix.h"
#include "engine/contact_problem.h"

namespace proofreel {
inline namespace PROOFREEL_PRECISION {

class ContactNewton {
 public:
  /// Looks who moves, and in which order factors stay sparse. False where a factorisation would take more than
  /// `most_work` multiplications. The rows' terms stay the same from then on.
  bool plan(const std::vector<ContactRow>& rows, const std::vector<Motion>& motions, double most_work);
  /// Gives all rows their impulses at once. False, and nothing has changed, when they have not settled after so many
  /// rounds: then what was found by then can be applied all the same.
  bool solve(std::vector<ContactRow>& rows, std::vector<Motion>& motions, int most_rounds);
  /// Whether the impulses given are the solution already, but for this part of the largest.
  bool is_in_balance(const std::vector<ContactRow>& rows, const std::vector<Motion>& motions, double negligible);
  void apply(std::vector<ContactRow>& rows, std::vector<Motion>& motions);
  /// The same for a large group that hardly moves: a single round, whose springs start from the impulses that are
  /// expected. What they give way by is left to the substeps to come, which start from what this one found, so that a
  /// pile at rest soon takes no more than a look. Where no impulse is known yet all rows are first taken to hold,
  /// whatever their bounds. False when no balance was found: then the rows were swept instead.
  bool solve_once(std::vector<ContactRow>& rows, std::vector<Motion>& motions);

 private:
  /// A body that moves, as far as units of mass 1 are concerned.
  struct Mover {
    double root_inv_mass = 0;  ///< 1 / sqrt(kg)
    double root_inv_inertia = 0;
  };
  /// Of one body: a velocity and a spin, or an impulse and an angular one.
  struct Twist {
    double x = 0;
    double y = 0;
    double turn = 0;
  };
  struct Row {
    double x = 0;  ///< direction of the push on b
    double y = 0;
    double arm_a = 0;
    double arm_b = 0;
    double start = 0;      ///< u at the start, m/s
    double stiffness = 0;  ///< r, kg
    double given = 0;      ///< at the start, N s
    double from = 0;       ///< l0
    double least = 0;      ///< bounds of l
    double most = 0;
    double impulse = 0;  ///< l
    double size = 0;     ///< speed per impulse, its root: 1 / sqrt(kg)
    double mass = 0;     ///< impulse per speed, kg; 0 where nothing gives way
    bool acts = false;   ///< l is not cut off
    bool acted = false;  ///< when the matrix was factored
  };
  /// Rows one after the other between the same two bodies: what they have in common is looked up once for all.
  struct Touch {
    BodyIndex body_a = 0;
    BodyIndex body_b = 0;
    int a = 0;  ///< number of the body among those that move; of all others, the one behind the last
    int b = 0;
    int place_a = 0;  ///< of its blocks in the matrix
    int place_b = 0;
    int place_between = 0;
    std::size_t end = 0;  ///< the row behind its last; its first one is the end of the touch before
  };
  /// A row that acts and did not when the matrix was factored, or the other way round.
  struct Differing {
    int a = 0;  ///< bodies that move; one of them twice where there is no other
    int b = 0;
    Twist on_a;
    Twist on_b;
    double stiffness = 0;  ///< negative where it acts no more
  };

  bool is_planned_for(const std::vector<ContactRow>& rows, const std::vector<Motion>& motions) const;
  bool make_plan(const std::vector<ContactRow>& rows, const std::vector<Motion>& motions, double most_work);
  void group_rows(const std::vector<ContactRow>& rows, const std::vector<Motion>& motions);
  std::vector<std::vector<int>> order_bodies();
  bool moves(int body) const { return body < static_cast<int>(bodies_.size()); }
  void scale_rows(const std::vector<ContactRow>& rows, const std::vector<Motion>& motions);
  void begin(const std::vector<ContactRow>& rows, const std::vector<Motion>& motions);
  double first_stiffness(const std::vector<ContactRow>& rows);
  void set_stiffness(double stiffness);
  void sweep(const std::vector<ContactRow>& rows, int times);
  void bound(const ContactRow& row, Row& own) const;
  void bound(const std::vector<ContactRow>& rows);
  int minimise();
  void take_step(double may_be_left);
  void find_way(double may_be_left);
  bool find_way_by_old_factors(double may_be_left);
  void find_differing();
  void add_difference(const Differing& row);
  void guess(const std::vector<ContactRow>& rows);
  bool minimise_roughly();
  void sweep_instead(const std::vector<ContactRow>& rows);
  void find_speeds(const std::vector<double>& change);
  template <typename Answer>
  void find_pushes(Answer&& answer);
  void respond();
  void find_residual();
  void factor_if_changed();
  void add_to_matrix(const Touch& touch, std::size_t first);
  void go_along();
  bool take_impulses();

  bool planned_ = false;
  std::vector<BodyIndex> bodies_;  ///< that move, in order of elimination
  std::vector<Mover> movers_;      ///< these, and one that stands for all others
  std::vector<Twist> speeds_;      ///< of the movers: what has changed since the start
  std::vector<Twist> pushes_;      ///< on the movers: what has been given since then
  std::vector<Row> rows_;
  std::vector<Touch> touches_;
  BlockMatrixOf<double> matrix_;
  std::vector<double> change_;    ///< of the unknowns since the start; three for each body
  std::vector<double> residual_;  ///< of the balance of each unknown
  std::vector<double> before_;    ///< the change a round began with
  std::vector<double> way_;
  std::vector<double> missing_;  ///< scratch of find_way_by_old_factors
  std::vector<double> next_;
  std::vector<double> factored_next_;  ///< the factored matrix times `next_`
  std::vector<double> pulled_;         ///< the present one times that
  std::vector<Differing> differing_rows_;
  double off_balance_ = 0;     ///< the largest residual
  double stiffness_ = 0;       ///< of the springs, times the bodies'
  double factored_with_ = 0;   ///< the same when the matrix was factored; 0 for never
  std::size_t differing_ = 0;  ///< how many of them there are
  double scale_ = 0;           ///< the largest impulse, in units of mass 1
};

}  // namespace PROOFREEL_PRECISION
}  // namespace proofreel
