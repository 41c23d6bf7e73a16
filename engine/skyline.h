#pragma once

/// A symmetric linear system kept by its envelope: of each row only what lies between its first non-zero entry and the
/// diagonal. Gaussian elimination never fills in anything outside it (Jennings 1966), so chains and trees of joints,
/// numbered along the chain, are factored in time proportional to their number.

#include <cstddef>
#include <vector>

#include "engine/real.h"

namespace proofreel {
inline namespace PROOFREEL_PRECISION {

class SkylineMatrix {
 public:
  /// `first[r]` is the column of row r's first entry, at most r. All entries become 0.
  void reset(const std::vector<int>& first);
  int size() const { return static_cast<int>(first_.size()); }
  /// Multiplications that `factor` takes, about.
  double work() const;
  void clear();
  /// The entry (row, column) with first[row] <= column <= row.
  real& at(int row, int column) {
    return values_[start_[static_cast<std::size_t>(row)] + static_cast<std::size_t>(column)];
  }
  /// Turns the matrix into its factors L D L^T. A pivot that is nothing but rounding belongs to a redundant row (a
  /// closed loop has some): its unknown is set to 0. Returns the least pivot relative to what stood on its diagonal
  /// before: how independent the rows are, 1 at best.
  real factor();
  /// Overwrites the right-hand side by the solution. After `factor`.
  void solve(std::vector<real>& x) const;

 private:
  const real& at(int row, int column) const {
    return values_[start_[static_cast<std::size_t>(row)] + static_cast<std::size_t>(column)];
  }

  std::vector<int> first_;
  std::vector<std::size_t> start_;  ///< values_[start_[r] + c] is entry (r, c)
  std::vector<real> values_;
  std::vector<real> inverse_pivot_;
};

}  // namespace PROOFREEL_PRECISION
}  // namespace proofreel
