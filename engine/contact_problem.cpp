#include "engine/contact_problem.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "engine/lcp.h"
#include "engine/work.h"

namespace proofreel {
inline namespace PROOFREEL_PRECISION {
namespace {

/// What changes less than this part of the largest impulse does not change.
constexpr real settled = 4 * std::numeric_limits<real>::epsilon();
/// Where there is no solution, because something is squeezed by what does not give way, impulses must not grow without
/// bound: contacts give way themselves, by this part of their own response.
constexpr real give_of_squeezed = real(1e-3);

/// The rows as unknowns that are never negative: the impulse of a gap; of a bounded row the impulses forwards and
/// backwards, and the speed that is left once they have given all they may. In units in which every row's own response
/// is 1, so that pivots can be compared.
class Problem {
 public:
  Problem(const std::vector<ContactRow>& rows, const std::vector<double>& response_to, double noise,
          const std::vector<Motion>& motions)
      : rows_(rows), response_(response_to) {
    for (std::size_t i = 0; i < rows_.size(); ++i) {
      const bool takes_part = !rows_[i].off && response(i, i) > 0;
      scale_.push_back(takes_part ? 1 / std::sqrt(response(i, i)) : 0);
      first_.push_back(takes_part ? count_ : -1);
      if (takes_part) count_ += is_gap(i) ? 1 : 3;
    }
    lcp_.emplace(count_);
    lcp_->noise = noise;
    for (std::size_t i = 0; i < rows_.size(); ++i) {
      if (first_[i] < 0) continue;
      set_speed(i, motions);
      for (std::size_t j = 0; j < rows_.size(); ++j) {
        if (first_[j] >= 0) couple(i, j);
      }
      if (!is_gap(i)) bound(i);
    }
    for (double& q : lcp_->offset) q /= unit_ > 0 ? unit_ : 1;
  }

  /// The impulse of every row, or nothing when no solution was found.
  std::optional<std::vector<real>> impulses() const {
    const std::optional<std::vector<double>> z = proofreel::solve(*lcp_);
    if (!z) return std::nullopt;
    std::vector<real> impulses;
    for (std::size_t i = 0; i < rows_.size(); ++i) {
      const auto part = [&](int k) { return (*z)[static_cast<std::size_t>(first_[i] + k)]; };
      const double sum = first_[i] < 0 ? 0 : is_gap(i) ? part(0) : part(0) - part(1);
      impulses.push_back(static_cast<real>(unit_ * scale_[i] * sum));
    }
    return impulses;
  }

 private:
  bool is_gap(std::size_t i) const { return only_pushes(rows_[i]); }
  double response(std::size_t i, std::size_t j) const { return static_cast<double>(response_[i * rows_.size() + j]); }

  /// What the speed would be without any of these impulses.
  void set_speed(std::size_t i, const std::vector<Motion>& motions) {
    double speed = static_cast<double>(speed_of(rows_[i].term, motions) + rows_[i].bias);
    for (std::size_t j = 0; j < rows_.size(); ++j) speed -= response(i, j) * static_cast<double>(rows_[j].given);
    lcp_->q(first_[i]) = scale_[i] * speed;
    if (!is_gap(i)) lcp_->q(first_[i] + 1) = -scale_[i] * speed;
    unit_ = std::max(unit_, std::abs(scale_[i] * speed));
  }

  void couple(std::size_t i, std::size_t j) {
    const double entry = scale_[i] * scale_[j] * response(i, j);
    lcp_->m(first_[i], first_[j]) = entry;
    if (!is_gap(j)) lcp_->m(first_[i], first_[j] + 1) = -entry;
    if (!is_gap(i)) lcp_->m(first_[i] + 1, first_[j]) = -entry;
    if (!is_gap(i) && !is_gap(j)) lcp_->m(first_[i] + 1, first_[j] + 1) = entry;
  }

  void bound(std::size_t i) {
    const int at = first_[i];
    lcp_->m(at, at + 2) = lcp_->m(at + 1, at + 2) = 1;
    lcp_->m(at + 2, at) = lcp_->m(at + 2, at + 1) = -1;
    for (std::size_t k = rows_[i].first_gap; k < rows_[i].first_gap + rows_[i].gap_count; ++k) {
      if (first_[k] >= 0)
        lcp_->m(at + 2, first_[k]) = static_cast<double>(rows_[i].coefficient) * scale_[k] / scale_[i];
    }
  }

  const std::vector<ContactRow>& rows_;
  const std::vector<double>& response_;
  std::vector<int> first_;     ///< unknown of every row; -1 for those that take no part
  std::vector<double> scale_;  ///< of every row: impulse = unit * scale * unknown
  double unit_ = 0;
  int count_ = 0;
  std::optional<Lcp> lcp_;
};

/// What a row may give, as near to `wanted` as can be; friction and rolling resistance follow the gaps.
real within_bounds(const std::vector<ContactRow>& rows, std::size_t i, real wanted) {
  const ContactRow& row = rows[i];
  if (only_pushes(row)) return row.off ? real(0) : std::max(wanted, real(0));
  real most = 0;
  for (std::size_t k = row.first_gap; k < row.first_gap + row.gap_count; ++k) most += row.coefficient * rows[k].given;
  return row.off ? real(0) : std::clamp(wanted, -most, most);
}

}  // namespace

bool solve_by_pivots(std::vector<ContactRow>& rows, const std::vector<double>& response, double noise,
                     std::vector<Motion>& motions) {
  const std::optional<std::vector<real>> impulses = Problem(rows, response, noise, motions).impulses();
  count_row_updates(rows.size());
  if (!impulses) return false;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    push(rows[i].term, (*impulses)[i] - rows[i].given, motions);
    rows[i].given = (*impulses)[i];
  }
  return true;
}

void solve_by_sweeps(std::vector<ContactRow>& rows, const std::vector<double>& response, std::vector<Motion>& motions,
                     int most_sweeps) {
  const std::size_t n = rows.size();
  std::vector<double> speeds;
  std::vector<real> before;
  for (const ContactRow& row : rows) {
    speeds.push_back(static_cast<double>(speed_of(row.term, motions) + row.bias));
    before.push_back(row.given);
  }
  for (int sweep = 0; sweep < most_sweeps; ++sweep) {
    count_row_updates(n);
    real largest = 0;
    real change = 0;
    for (std::size_t j = 0; j < n; ++j) {
      const double own = response[j * n + j];
      if (own <= 0) continue;
      const real impulse = within_bounds(rows, j, rows[j].given - static_cast<real>(speeds[j] / own));
      const real gained = impulse - rows[j].given;
      for (std::size_t i = 0; i < n; ++i) speeds[i] += response[i * n + j] * static_cast<double>(gained);
      change = std::max(change, std::abs(gained));
      largest = std::max(largest, std::abs(impulse));
      rows[j].given = impulse;
    }
    if (change <= settled * largest) break;
  }
  for (std::size_t i = 0; i < n; ++i) push(rows[i].term, rows[i].given - before[i], motions);
}

bool has_mover(const std::vector<ContactRow>& rows, const std::vector<Motion>& motions) {
  return std::any_of(rows.begin(), rows.end(), [&motions](const ContactRow& row) {
    return is_mover(motions[row.term.body_a]) || is_mover(motions[row.term.body_b]);
  });
}

void solve_by_sweeps(std::vector<ContactRow>& rows, std::vector<Motion>& motions, int most_sweeps) {
  const auto inverse_mass = [&motions](const Term& t) {
    const Motion& a = motions[t.body_a];
    const Motion& b = motions[t.body_b];
    return (a.inv_mass + b.inv_mass) * dot(t.direction, t.direction) + a.inv_inertia * t.arm_a * t.arm_a +
           b.inv_inertia * t.arm_b * t.arm_b;
  };
  // Pivots find the solution of a small group if there is one.
  const real give = has_mover(rows, motions) || rows.size() <= most_rows_to_pivot ? give_of_squeezed : real(0);
  for (int sweep = 0; sweep < most_sweeps; ++sweep) {
    count_row_updates(rows.size());
    real largest = 0;
    real change = 0;
    for (std::size_t i = 0; i < rows.size(); ++i) {
      ContactRow& row = rows[i];
      const real response = inverse_mass(row.term);
      if (response <= 0) continue;
      const real speed = speed_of(row.term, motions) + row.bias + give * response * row.given;
      const real wanted = row.given - speed / ((1 + give) * response);
      const real impulse = within_bounds(rows, i, wanted);
      push(row.term, impulse - row.given, motions);
      change = std::max(change, std::abs(impulse - row.given));
      largest = std::max(largest, std::abs(impulse));
      row.given = impulse;
    }
    if (change <= settled * largest) return;
  }
}

}  // namespace PROOFREEL_PRECISION
}  // namespace proofreel
