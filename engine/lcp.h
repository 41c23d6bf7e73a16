#pragma once

/// Linear complementarity, the mathematics of touching: find z >= 0 so that w = M z + q >= 0, and of every pair (z_i,
/// w_i) at least one is 0. For contacts, z are the impulses, w the speeds at which they part: what presses does not
/// part, and what parts does not press.

#include <optional>
#include <vector>

namespace proofreel {

/// A square system in double precision, whatever the engine's: pivoting needs the digits. Entries should be of about
/// the same size.
struct Lcp {
  explicit Lcp(int n) : size(n), matrix(static_cast<std::size_t>(n) * static_cast<std::size_t>(n)), offset(index(n)) {}
  double& m(int row, int column) { return matrix[index(row) * index(size) + index(column)]; }
  double m(int row, int column) const { return matrix[index(row) * index(size) + index(column)]; }
  double& q(int row) { return offset[index(row)]; }
  double q(int row) const { return offset[index(row)]; }

  int size = 0;
  double noise = 1e-10;        ///< entries are known to about this: a pivot has to be larger
  std::vector<double> matrix;  ///< M, row by row
  std::vector<double> offset;  ///< q

 private:
  static std::size_t index(int i) { return static_cast<std::size_t>(i); }
};

/// Solves it by Lemke's complementary pivoting (1965): one artificial unknown makes all w positive, and is driven out
/// by exchanging one z for its w at a time, the next always being the partner of the last. For positive semidefinite M,
/// and for contacts with Coulomb's friction as set up by Anitescu and Potra (1997), it ends with a solution if there is
/// one. Nothing comes back when there is none (something is squeezed by what does not give way), or hardly one (an
/// unknown above 1e7), or none that rounding has left exact to 1e-7 of the entries.
std::optional<std::vector<double>> solve(const Lcp& problem);

}  // namespace proofreel
