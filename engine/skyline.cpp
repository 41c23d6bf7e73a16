#include "engine/skyline.h"

#include <algorithm>
#include <limits>

namespace proofreel {
inline namespace PROOFREEL_PRECISION {

namespace {

/// Sums products in eight lanes that are added up in a fixed order: the compiler may use the machine's vectors, whose
/// width then decides nothing.
real dot_product(const real* a, const real* b, int count) {
  constexpr int lanes = 8;
  real sums[lanes] = {};
  int k = 0;
  for (; k + lanes <= count; k += lanes) {
    for (int lane = 0; lane < lanes; ++lane) sums[lane] += a[k + lane] * b[k + lane];
  }
  real rest = 0;
  for (; k < count; ++k) rest += a[k] * b[k];
  if (count < lanes) return rest;
  return (((sums[0] + sums[4]) + (sums[2] + sums[6])) + ((sums[1] + sums[5]) + (sums[3] + sums[7]))) + rest;
}

}  // namespace

void SkylineMatrix::reset(const std::vector<int>& first) {
  first_ = first;
  start_.resize(first.size());
  std::size_t used = 0;
  for (std::size_t r = 0; r < first.size(); ++r) {
    start_[r] = used - static_cast<std::size_t>(first[r]);  // wraps below zero and back: only start + column is used
    used += r - static_cast<std::size_t>(first[r]) + 1;
  }
  values_.assign(used, 0);
  inverse_pivot_.assign(first.size(), 0);
}

double SkylineMatrix::work() const {
  double sum = 0;
  for (std::size_t r = 0; r < first_.size(); ++r) {
    const double width = static_cast<double>(r) - first_[r];
    sum += 0.5 * width * width;
  }
  return sum;
}

void SkylineMatrix::clear() { std::fill(values_.begin(), values_.end(), real(0)); }

real SkylineMatrix::factor() {
  real least = 1;
  const real negligible = 64 * std::numeric_limits<real>::epsilon();
  for (int r = 0; r < size(); ++r) {
    const int first_r = first_[static_cast<std::size_t>(r)];
    const real diagonal = at(r, r);
    for (int c = first_r; c < r; ++c) {
      // Until the pivots are divided out below, row r holds L(r, c) * D(c).
      const int from = std::max(first_r, first_[static_cast<std::size_t>(c)]);
      if (from < c) at(r, c) -= dot_product(&at(r, from), &at(c, from), c - from);
    }
    real pivot = diagonal;
    for (int c = first_r; c < r; ++c) {
      const real scaled = at(r, c) * inverse_pivot_[static_cast<std::size_t>(c)];
      pivot -= scaled * at(r, c);
      at(r, c) = scaled;
    }
    at(r, r) = pivot;
    inverse_pivot_[static_cast<std::size_t>(r)] = pivot > negligible * diagonal ? 1 / pivot : 0;
    if (pivot < least * diagonal) least = pivot / diagonal;
  }
  return least;
}

void SkylineMatrix::solve(std::vector<real>& x) const {
  for (int r = 0; r < size(); ++r) {
    real sum = x[static_cast<std::size_t>(r)];
    for (int c = first_[static_cast<std::size_t>(r)]; c < r; ++c) sum -= at(r, c) * x[static_cast<std::size_t>(c)];
    x[static_cast<std::size_t>(r)] = sum;
  }
  for (int r = 0; r < size(); ++r) x[static_cast<std::size_t>(r)] *= inverse_pivot_[static_cast<std::size_t>(r)];
  for (int r = size() - 1; r > 0; --r) {
    for (int c = first_[static_cast<std::size_t>(r)]; c < r; ++c) {
      x[static_cast<std::size_t>(c)] -= at(r, c) * x[static_cast<std::size_t>(r)];
    }
  }
}

}  // namespace PROOFREEL_PRECISION
}  // namespace proofreel
