#include "engine/contact_newton.h"

#include <algorithm>
#include <cmath>
#include <utility>

/// Where a step leads, and how far it is gone: see contact_newton.h.

namespace proofreel {
inline namespace PROOFREEL_PRECISION {
namespace {

/// A way is gone to the end when the slope there is no steeper than this part of what it was at the start.
constexpr double flat = 0.1;
constexpr int most_trials = 12;

/// Where other rows act than those the matrix was factored for, its factors serve on: for as many steps as take this
/// part of the time that new ones would, where each step may make up for so many rows.
constexpr double part_of_factoring = 0.8;
constexpr std::size_t rows_per_step = 8;

std::size_t at(int i) { return static_cast<std::size_t>(i); }

double dot_product(const std::vector<double>& a, const std::vector<double>& b) {
  double sum = 0;
  for (std::size_t k = 0; k < a.size(); ++k) sum += a[k] * b[k];
  return sum;
}

}  // namespace

/// Newton's way: what is missing to balance, divided by the matrix of the rows that act. Where only a few others acted
/// when that was factored the old factors serve on, and what they are wrong by is found step by step.
void ContactNewton::find_way(double may_be_left) {
  if (factored_with_ == stiffness_ && differing_ > 0 && find_way_by_old_factors(may_be_left)) return;
  factor_if_changed();
  way_ = residual_;
  for (double& x : way_) x = -x;
  matrix_.solve(way_);
}

/// By conjugate gradients (Hestenes and Stiefel 1952), preconditioned by the old factors: what those leave over is the
/// work of the rows that differ, so that few rows take few steps. False when they take too many.
bool ContactNewton::find_way_by_old_factors(double may_be_left) {
  const double enough = may_be_left * off_balance_;
  const auto most_tries =
      static_cast<std::size_t>(part_of_factoring * matrix_.work_to_factor() / matrix_.work_to_solve());
  if (differing_ > rows_per_step * most_tries) return false;
  find_differing();
  way_.assign(residual_.size(), 0);
  missing_ = residual_;
  for (double& x : missing_) x = -x;
  next_ = missing_;
  matrix_.solve(next_);
  factored_next_ = missing_;
  double product = dot_product(missing_, next_);
  for (std::size_t step = 0; step < most_tries; ++step) {
    pulled_ = factored_next_;
    for (const Differing& row : differing_rows_) add_difference(row);
    const double part = product / dot_product(next_, pulled_);
    double largest = 0;
    for (std::size_t k = 0; k < way_.size(); ++k) {
      way_[k] += part * next_[k];
      missing_[k] -= part * pulled_[k];
      largest = std::max(largest, std::abs(missing_[k]));
    }
    if (largest <= enough) return true;
    pulled_ = missing_;
    matrix_.solve(pulled_);
    const double before = std::exchange(product, dot_product(missing_, pulled_));
    const double share = product / before;
    for (std::size_t k = 0; k < way_.size(); ++k) {
      next_[k] = pulled_[k] + share * next_[k];
      factored_next_[k] = missing_[k] + share * factored_next_[k];
    }
  }
  return false;
}

void ContactNewton::find_differing() {
  differing_rows_.clear();
  std::size_t i = 0;
  for (const Touch& touch : touches_) {
    const Mover& a = movers_[at(touch.a)];
    const Mover& b = movers_[at(touch.b)];
    for (; i < touch.end; ++i) {
      const Row& row = rows_[i];
      if (row.acts == row.acted) continue;
      Differing d;
      d.a = moves(touch.a) ? touch.a : touch.b;
      d.b = moves(touch.b) ? touch.b : touch.a;
      d.on_a = {-a.root_inv_mass * row.x, -a.root_inv_mass * row.y, -a.root_inv_inertia * row.arm_a};
      d.on_b = {b.root_inv_mass * row.x, b.root_inv_mass * row.y, b.root_inv_inertia * row.arm_b};
      d.stiffness = row.acts ? row.stiffness : -row.stiffness;
      differing_rows_.push_back(d);
    }
  }
}

/// To the old matrix times `next_`, so that it becomes the present one times that.
inline void ContactNewton::add_difference(const Differing& row) {
  const double* a = &next_[3 * at(row.a)];
  const double* b = &next_[3 * at(row.b)];
  const double speed = (row.on_a.x * a[0] + row.on_a.y * a[1] + row.on_a.turn * a[2]) +
                       (row.on_b.x * b[0] + row.on_b.y * b[1] + row.on_b.turn * b[2]);
  const double pull = row.stiffness * speed;
  double* on_a = &pulled_[3 * at(row.a)];
  double* on_b = &pulled_[3 * at(row.b)];
  on_a[0] += pull * row.on_a.x, on_a[1] += pull * row.on_a.y, on_a[2] += pull * row.on_a.turn;
  on_b[0] += pull * row.on_b.x, on_b[1] += pull * row.on_b.y, on_b[2] += pull * row.on_b.turn;
}

/// Along the way to where the slope is 0, or nearly: mostly that is its end.
void ContactNewton::go_along() {
  double gone = 0;
  const auto go_to = [&](double share) {
    for (std::size_t k = 0; k < way_.size(); ++k) change_[k] += (share - gone) * way_[k];
    gone = share;
    respond();
    return dot_product(way_, residual_);
  };
  const double steepest = std::abs(dot_product(way_, residual_));
  double low = 0;
  double high = 1;
  double slope_low = -steepest;
  double slope_high = go_to(1);
  for (int trial = 0; trial < most_trials && slope_high > flat * steepest; ++trial) {
    const double between = low + (high - low) * std::clamp(slope_low / (slope_low - slope_high), 0.1, 0.9);
    const double slope_there = go_to(between);
    if (std::abs(slope_there) <= flat * steepest) return;
    if (slope_there < 0) {
      low = between;
      slope_low = slope_there;
    } else {
      high = between;
      slope_high = slope_there;
    }
  }
}
/// The matrix depends on which rows act, and on nothing else.
void ContactNewton::factor_if_changed() {
  if (differing_ == 0 && factored_with_ == stiffness_) return;
  matrix_.clear();
  for (int body = 0; body < static_cast<int>(bodies_.size()); ++body) {
    const auto block = matrix_.block(matrix_.place_of(body, body));
    for (int k = 0; k < 3; ++k) block(k, k) = 1;
  }
  std::size_t first = 0;
  for (const Touch& touch : touches_) {
    add_to_matrix(touch, first);
    first = touch.end;
  }
  factored_with_ = stiffness_;
  differing_ = 0;
  matrix_.factor();
}

/// The springs of the rows that act pull at both bodies.
void ContactNewton::add_to_matrix(const Touch& touch, std::size_t first) {
  double xx = 0, xy = 0, yy = 0;
  double xa = 0, ya = 0, xb = 0, yb = 0;
  double aa = 0, ab = 0, bb = 0;
  for (std::size_t i = first; i < touch.end; ++i) {
    Row& row = rows_[i];
    row.acted = row.acts;
    if (!row.acts) continue;
    const double x = row.stiffness * row.x;
    const double y = row.stiffness * row.y;
    xx += x * row.x, xy += x * row.y, yy += y * row.y;
    xa += x * row.arm_a, ya += y * row.arm_a, xb += x * row.arm_b, yb += y * row.arm_b;
    aa += row.stiffness * row.arm_a * row.arm_a;
    ab += row.stiffness * row.arm_a * row.arm_b;
    bb += row.stiffness * row.arm_b * row.arm_b;
  }
  // On one body, or between two: what moves i by what moves j, in units of mass 1.
  const auto add = [&](int place, const Mover& i, const Mover& j, double sign, const double(&sums)[9]) {
    const double left[3] = {sign * i.root_inv_mass, sign * i.root_inv_mass, sign * i.root_inv_inertia};
    const double top[3] = {j.root_inv_mass, j.root_inv_mass, j.root_inv_inertia};
    const auto block = matrix_.block(place);
    for (int r = 0; r < 3; ++r) {
      for (int c = 0; c < 3; ++c) block(r, c) += left[r] * top[c] * sums[3 * r + c];
    }
  };
  const Mover& a = movers_[at(touch.a)];
  const Mover& b = movers_[at(touch.b)];
  if (moves(touch.a)) add(touch.place_a, a, a, 1, {xx, xy, xa, xy, yy, ya, xa, ya, aa});
  if (moves(touch.b)) add(touch.place_b, b, b, 1, {xx, xy, xb, xy, yy, yb, xb, yb, bb});
  if (!moves(touch.a) || !moves(touch.b)) return;
  if (touch.a > touch.b) add(touch.place_between, a, b, -1, {xx, xy, xb, xy, yy, yb, xa, ya, ab});
  if (touch.a < touch.b) add(touch.place_between, b, a, -1, {xx, xy, xa, xy, yy, ya, xb, yb, ab});
}

}  // namespace PROOFREEL_PRECISION
}  // namespace proofreel
