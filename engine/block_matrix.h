#pragma once

/// A symmetric linear system made of small blocks, most of which are zero, factored by L D L^T with square-root-free
/// Cholesky elimination. Which blocks can become non-zero is worked out once (George and Liu, "Computer Solution of
/// Large Sparse Positive Definite Systems", 1981, chapter 5); how many rows a block has may change from one
/// factorisation to the next at no cost, so that equations that do not hold at present take no part.
///
/// The blocks of one column stand below each other in a dense panel. Numbered from the leaves to the root, trees fill
/// in nothing: chains and trees of joints are factored in time proportional to their number.

#include <cstddef>
#include <cstdint>
#include <vector>

#include "engine/real.h"

namespace proofreel {
inline namespace PROOFREEL_PRECISION {

template <typename T>
class BlockMatrixOf {
 public:
  /// `below[c]` are the rows of the non-zero blocks below the diagonal of column c, ascending; `most_rows[c]` is how
  /// many rows block c may have. False where a factorisation would take more than `most_work` multiplications: then
  /// the matrix is of no use.
  bool plan(std::vector<std::vector<int>> below, const std::vector<int>& most_rows, double most_work);
  /// From now on block i has `rows[i]` rows. All entries become 0.
  void resize(const std::vector<int>& rows);
  void clear();
  /// How many equations there are now.
  int size() const { return panels_.back().first; }
  /// The number of equation 0 of block i; of the one behind the last block, how many there are.
  int first(int i) const { return panels_[at(i)].first; }

  /// One block of the lower triangle, for filling it.
  struct Block {
    T* values = nullptr;
    std::size_t stride = 0;
    T& operator()(int row, int column) const {
      return values[static_cast<std::size_t>(column) * stride + static_cast<std::size_t>(row)];
    }
  };
  /// The place of block (row, column), column <= row, which was planned.
  int place_of(int row, int column) const;
  /// Where the entries of a block stand, until the next `resize`.
  struct Spot {
    std::size_t begin = 0;
    std::size_t stride = 0;
  };
  Spot spot(int place) const {
    const Panel& panel = panels_[at(column_[at(place)])];
    return {panel.begin + at(offset_[at(place)]), at(panel.height)};
  }
  /// On the diagonal only what is on or below it counts.
  Block block(Spot spot) { return {values_.data() + spot.begin, spot.stride}; }
  Block block(int place) { return block(spot(place)); }
  /// Multiplications that it takes, as planned: with all the rows that blocks may have.
  double work_to_factor() const { return work_; }
  double work_to_solve() const { return 2 * entries_; }
  /// Multiplies the diagonal.
  void stretch_diagonal(T factor);
  /// Turns the matrix into its factors. A pivot that is nothing but rounding belongs to a redundant row (a closed loop
  /// has some): its unknown is set to 0. Returns the least pivot relative to what stood on its diagonal before: how
  /// independent the rows are, 1 at best.
  T factor();
  /// Overwrites the right-hand side by the solution. After `factor`.
  void solve(std::vector<T>& x) const;

 private:
  /// The blocks of one column, from the diagonal one down, as a dense matrix stored by columns.
  struct Panel {
    int first = 0;          ///< number of the block's first equation
    int width = 0;          ///< of the block, in equations
    int height = 0;         ///< of the panel
    std::size_t begin = 0;  ///< in `values_`
    std::size_t list = 0;   ///< where in `equations_` the numbers of its rows begin
  };

  /// Up to so many equations loops are so short that what surrounds them is the price.
  static constexpr int most_few = 96;

  static std::size_t at(int i) { return static_cast<std::size_t>(i); }
  const int* equations_of(const Panel& panel) const { return equations_.data() + panel.list; }
  void find_runs();
  void find_meeting_rows();
  void subtract_what_follows_from(int place);
  void subtract_in_runs(int place);
  template <int width, bool in_runs>
  void subtract_alike(int place);
  void take_updates(const Panel& panel);
  void subtract_few(int place);
  template <int width, bool pairs>
  void subtract_few(int place);
  void subtract_few_of_any_width(int place);
  void take_few(const Panel& panel);
  T factor_panel(const Panel& panel);
  template <int width>
  T factor_narrow(const Panel& panel);
  void solve_few(T* x) const;
  void spread(const Panel& panel, T* x) const;
  template <int width>
  void spread_narrow(const Panel& panel, T* x) const;
  void spread_in_runs(int column, T* x) const;
  void spread_threes(int column, T* x) const;
  void gather(const Panel& panel, T* x) const;
  template <int width>
  void gather_narrow(const Panel& panel, T* x) const;
  void gather_threes(const Panel& panel, T* x) const;
  void gather_in_runs(int column, T* x) const;
  template <typename Visit>
  void for_each_run(int place, int skip, Visit&& visit) const;

  // The plan. Places number the blocks column by column, the diagonal one first.
  std::vector<int> start_;                ///< first place of each column, and the end
  std::vector<int> row_;                  ///< block row of each place
  std::vector<int> column_;               ///< and its block column
  std::vector<int> run_end_;              ///< the first place behind it that does not stand on the next rows
  std::vector<std::uint8_t> in_runs_;     ///< whether a column's blocks stand in long runs
  std::vector<std::vector<int>> beside_;  ///< of each block row, the places left of the diagonal

  double work_ = 0;
  double entries_ = 0;  ///< of the lower triangle

  // Sizes.
  std::vector<Panel> panels_;   ///< and one behind the last
  std::vector<int> offset_;     ///< of each place in its panel, in rows
  std::vector<int> equations_;  ///< the numbers of all rows of all panels
  int alike_ = 0;               ///< how many rows all blocks have: 2 as pins do, 3 as bodies do; else 0
  bool few_ = false;            ///< equations: then what meets where is looked up, not scattered by equation
  std::vector<int> meeting_;    ///< few: of each place, where its row and all below it stand in the panel of that row
  std::vector<int> meets_;      ///< few: where in `meeting_` those of each place begin

  std::vector<T> values_;
  std::vector<T> pivot_;
  std::vector<T> inverse_pivot_;
  std::vector<T>
      updates_;  ///< what is to be subtracted from one panel, by equation (few: as it stands); 0 between uses
};

/// Visits the rows of a column from `skip` rows below the upper edge of the block at `place` on, by runs of consecutive
/// equations: visit(first equation, offset in the panel, count).
template <typename T>
template <typename Visit>
void BlockMatrixOf<T>::for_each_run(int place, int skip, Visit&& visit) const {
  const int end = start_[at(column_[at(place)]) + 1];
  for (int p = place; p < end; p = run_end_[at(p)], skip = 0) {
    const int row = first(row_[at(p)]) + skip;
    visit(row, offset_[at(p)] + skip, first(row_[at(run_end_[at(p)] - 1)] + 1) - row);
  }
}

/// Most are as precise as the engine; contacts of very unequal masses need all the digits there are.
using BlockMatrix = BlockMatrixOf<real>;

}  // namespace PROOFREEL_PRECISION
}  // namespace proofreel
