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
/// All in double precision whatever the engine's, with velocities in units in which every body has mass 1.

#include <cstdint>
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
  void apply(std::vector<ContactRow>& rows, std::vector<Motion>& motions) const;
  /// The same for a large group that hardly moves: a single round, whose springs start from the impulses that are
  /// expected. What they give way by is left to the substeps to come, which start from what this one found, so that a
  /// pile at rest soon takes no more than a look. Factors serve on while other rows act than those they were made for,
  /// as long as steps get on with them. Where no impulse is known yet all rows are first taken to hold, whatever their
  /// bounds. False when no balance was found: then the rows were swept instead.
  bool solve_once(std::vector<ContactRow>& rows, std::vector<Motion>& motions);

 private:
  enum class Factored : std::uint8_t { never, acting, cut_off };

  /// A row in units of mass 1: its speed is that of the start and this times the change of the unknowns.
  struct Row {
    BodyIndex body_a = 0;
    BodyIndex body_b = 0;
    int a = -1;  ///< number of the body among those that move; -1 for the others
    int b = -1;
    int place_a = 0;  ///< of its blocks in the matrix
    int place_b = 0;
    int place_between = 0;
    double on_a[3] = {};
    double on_b[3] = {};
    double size = 0;       ///< of both together, 1 / sqrt(kg)
    double stiffness = 0;  ///< r, kg
    double start = 0;      ///< u at the start, m/s
    double given = 0;      ///< at the start, N s
    double from = 0;       ///< l0
    double least = 0;      ///< bounds of l
    double most = 0;
    double impulse = 0;  ///< l
    bool acts = false;   ///< l is not cut off
    Factored factored = Factored::never;
  };

  bool is_planned_for(const std::vector<ContactRow>& rows, const std::vector<Motion>& motions) const;
  bool make_plan(const std::vector<ContactRow>& rows, const std::vector<Motion>& motions, double most_work);
  std::vector<std::vector<int>> order_bodies(const std::vector<ContactRow>& rows);
  void scale_row(Row& row, const Term& t, const std::vector<Motion>& motions);
  void begin(const std::vector<ContactRow>& rows, const std::vector<Motion>& motions);
  double first_stiffness(const std::vector<ContactRow>& rows);
  void set_stiffness(double stiffness);
  double speed_of(const Row& row) const;
  void sweep_once(const std::vector<ContactRow>& rows);
  void bound(const ContactRow& row, Row& own) const;
  void bound(const std::vector<ContactRow>& rows);
  int minimise();
  void take_step();
  void guess(const std::vector<ContactRow>& rows);
  bool minimise_with_kept_factors();
  void sweep_instead(const std::vector<ContactRow>& rows);
  void respond();
  double find_residual();
  double largest_residual() const;
  void factor_if_changed();
  void add_to_matrix(const Row& row);
  void go_along();
  bool take_impulses();

  bool planned_ = false;
  std::vector<BodyIndex> bodies_;  ///< that move, in order of elimination
  std::vector<Row> rows_;
  BlockMatrixOf<double> matrix_;
  std::vector<double> change_;    ///< of the unknowns since the start; three for each body
  std::vector<double> residual_;  ///< of the balance of each unknown
  std::vector<double> before_;    ///< the change a round began with
  std::vector<double> way_;
  double stiffness_ = 0;  ///< of the springs, times the bodies'
  double scale_ = 0;      ///< the largest impulse, in units of mass 1
};

}  // namespace PROOFREEL_PRECISION
}  // namespace proofreel
