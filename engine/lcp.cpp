#include "engine/lcp.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>

namespace proofreel {
namespace {

/// What right sides of the size of one may be off by.
constexpr double rounding = 1e-13;
/// What a solution may leave open.
constexpr double accepted = 1e-7;

/// Unknowns beyond this mean that the problem has hardly a solution.
constexpr double largest = 1e7;

/// The tableau w - M z - d z0 = q, solved for the variables in the basis. Columns: w, then z, then z0, then the right
/// side.
class Tableau {
 public:
  explicit Tableau(const Lcp& problem)
      : noise_(problem.noise),
        size_(problem.size),
        columns_(2 * size_ + 2),
        cells_(at_index(size_) * at_index(columns_)),
        basis_(at_index(size_)) {
    for (int r = 0; r < size_; ++r) {
      cell(r, r) = 1;
      for (int c = 0; c < size_; ++c) cell(r, size_ + c) = -problem.m(r, c);
      cell(r, artificial()) = -1;
      cell(r, columns_ - 1) = problem.q(r);
      basis_[at_index(r)] = r;
    }
  }

  int artificial() const { return 2 * size_; }
  int partner(int variable) const { return variable < size_ ? variable + size_ : variable - size_; }
  double right(int row) const { return cell(row, columns_ - 1); }

  int lowest_row() const {
    int lowest = 0;
    for (int r = 1; r < size_; ++r) lowest = right(r) < right(lowest) ? r : lowest;
    return lowest;
  }

  /// The row whose variable is the first to become 0 as the entering one grows; -1 when none ever does. Of rows that
  /// are as early but for rounding, the one of largest pivot, so that errors do not grow (Harris 1973); the artificial
  /// variable before all others.
  int leaving_row(int entering) const {
    double first = std::numeric_limits<double>::infinity();
    for (int r = 0; r < size_; ++r) {
      if (cell(r, entering) > noise_) first = std::min(first, (right(r) + rounding) / cell(r, entering));
    }
    int best = -1;
    for (int r = 0; r < size_; ++r) {
      if (cell(r, entering) <= noise_ || right(r) / cell(r, entering) > first) continue;
      if (basis_[at_index(r)] == artificial()) return r;
      if (best < 0 || cell(r, entering) > cell(best, entering)) best = r;
    }
    return best;
  }

  /// Takes a variable into the basis in a row's place and returns the one that leaves.
  int exchange(int row, int entering) {
    const double inverse = 1 / cell(row, entering);
    for (int c = 0; c < columns_; ++c) cell(row, c) *= inverse;
    for (int r = 0; r < size_; ++r) {
      const double factor = cell(r, entering);
      if (r == row || factor == 0) continue;
      for (int c = 0; c < columns_; ++c) cell(r, c) -= factor * cell(row, c);
      cell(r, entering) = 0;
    }
    return std::exchange(basis_[at_index(row)], entering);
  }

  std::vector<double> z() const {
    std::vector<double> z(at_index(size_));
    for (int r = 0; r < size_; ++r) {
      const int variable = basis_[at_index(r)];
      if (variable >= size_ && variable < artificial()) z[at_index(variable - size_)] = std::max(right(r), 0.0);
    }
    return z;
  }

 private:
  static std::size_t at_index(int i) { return static_cast<std::size_t>(i); }
  double& cell(int row, int column) { return cells_[at_index(row) * at_index(columns_) + at_index(column)]; }
  double cell(int row, int column) const { return cells_[at_index(row) * at_index(columns_) + at_index(column)]; }

  double noise_;
  int size_;
  int columns_;
  std::vector<double> cells_;
  std::vector<int> basis_;  ///< the variable of each row
};

/// The solution, if it is one.
std::optional<std::vector<double>> checked(const Lcp& problem, std::vector<double> z) {
  for (int r = 0; r < problem.size; ++r) {
    double w = problem.q(r);
    double sum = std::abs(w);
    for (int c = 0; c < problem.size; ++c) {
      const double term = problem.m(r, c) * z[static_cast<std::size_t>(c)];
      w += term;
      sum += std::abs(term);
    }
    const double allowed = accepted * std::max(sum, 1.0);
    if (!(z[static_cast<std::size_t>(r)] <= largest) || w < -allowed ||
        (z[static_cast<std::size_t>(r)] > accepted && w > allowed))
      return std::nullopt;
  }
  return z;
}

}  // namespace

std::optional<std::vector<double>> solve(const Lcp& problem) {
  Tableau tableau(problem);
  const int lowest = problem.size > 0 ? tableau.lowest_row() : 0;
  if (problem.size == 0 || tableau.right(lowest) >= 0) return tableau.z();
  int left = tableau.exchange(lowest, tableau.artificial());
  const int most_exchanges = 20 * problem.size + 20;
  for (int i = 0; i < most_exchanges; ++i) {
    const int entering = tableau.partner(left);
    const int row = tableau.leaving_row(entering);
    if (row < 0) return std::nullopt;
    left = tableau.exchange(row, entering);
    if (left == tableau.artificial()) return checked(problem, tableau.z());
  }
  return std::nullopt;
}

}  // namespace proofreel
