// The linear system of a group: which rows are in it, and its factors.

#include <algorithm>
#include <utility>

#include "engine/joint_group.h"
#include "engine/lanes.h"

namespace proofreel {
inline namespace PROOFREEL_PRECISION {
namespace {

/// Where joints contradict each other, nearly singular rows would ask for any impulse to win the last nanometre. So
/// much give, relative to the row's own mass, keeps them finite; what it leaves open the next Newton step closes.
constexpr real compliance = real(1e-6);
/// The same where a moving kinematic body pulls joints apart that cannot follow: no force however large helps, and one
/// in proportion does not hurl about what is pulled in vain. (Fixed bodies do no work, so they need no such care.)
constexpr real strained_compliance = real(3e-2);
/// Rows that depend on others (loops with more joints than it takes) show as pivots of little but compliance. Rounding
/// and the turning of directions within a substep make them disagree a little; what they would ask for to settle that
/// has to stay small, and Newton's method closes the rest.
constexpr real redundant = real(2e-5);
constexpr real redundant_compliance = real(1e-3);
/// For rows that only seem to depend on others, and how independent these are at least.
constexpr real slight_compliance = real(1e-10);
constexpr real independent = real(1e-8);

/// Multiplications for one factorisation that a group may take: a net of 30 by 30 bodies is about there, a chain of ten
/// thousand links far below.
constexpr double most_work = 5e6;

}  // namespace

void JointGroup::couple(const std::vector<Motion>& motions) {
  std::vector<std::pair<BodyIndex, Side>> sides;
  for (int i = 0; i < static_cast<int>(links_.size()); ++i) {
    const Terms& terms = rows_[static_cast<std::size_t>(links_[static_cast<std::size_t>(i)].first_row)].terms;
    for (int t = 0; t < terms.count; ++t) {
      sides.push_back({terms.terms[t].body_a, {i, static_cast<std::size_t>(2 * t)}});
      sides.push_back({terms.terms[t].body_b, {i, static_cast<std::size_t>(2 * t + 1)}});
    }
  }
  std::erase_if(sides,
                [&](const auto& s) { return motions[s.first].inv_mass <= 0 && motions[s.first].inv_inertia <= 0; });
  std::stable_sort(sides.begin(), sides.end(), [](const auto& s, const auto& t) { return s.first < t.first; });
  for (std::size_t end = 0, begin = 0; begin < sides.size(); begin = end) {
    const BodyIndex body = sides[begin].first;
    bodies_.push_back(body);
    factored_with_.emplace_back();
    for (end = begin; end < sides.size() && sides[end].first == body; ++end) {
      for (std::size_t other = begin; other <= end; ++other) {
        Coupling coupling;
        coupling.row = sides[end].second;
        coupling.column = sides[other].second;
        coupling.body = body;
        couplings_.push_back(coupling);
        // A gear may hold the same body twice; then its two sides meet in both orders.
        if (other != end && coupling.row.link == coupling.column.link) couplings_.push_back(coupling);
      }
    }
  }
  plan_matrix();
}

void JointGroup::plan_matrix() {
  std::vector<std::vector<int>> below(links_.size());
  for (const Coupling& k : couplings_) {
    if (k.row.link != k.column.link) below[static_cast<std::size_t>(k.column.link)].push_back(k.row.link);
  }
  for (std::vector<int>& rows : below) {
    std::sort(rows.begin(), rows.end());
    rows.erase(std::unique(rows.begin(), rows.end()), rows.end());
  }
  for (const Link& link : links_) links_on_.push_back(link.row_count);
  levers_.resize(12 * rows_.size());
  scales_.resize(in_whole_lanes(rows_.size()), 1);
  too_dense_ = !matrix_.plan(std::move(below), links_on_, most_work);
  if (too_dense_) return;
  for (Coupling& k : couplings_) k.place = matrix_.place_of(k.row.link, k.column.link);
  number_rows();
}

bool JointGroup::masses_changed(const std::vector<Motion>& motions) const {
  for (std::size_t i = 0; i < bodies_.size(); ++i) {
    const Motion& m = motions[bodies_[i]];
    if (m.inv_mass != factored_with_[i].inv_mass || m.inv_inertia != factored_with_[i].inv_inertia) return true;
  }
  return false;
}

bool JointGroup::holds(const Row& row, const JointedBodies& scene, bool for_velocities) const {
  if (row.plan.bound == Bound::equal) return true;
  return row.plan.bound == Bound::driven ? for_velocities : memory(row, scene).engaged;
}

void JointGroup::prepare(const JointedBodies& scene, bool for_velocities) {
  for (const int r : bounded_) {
    Row& row = rows_[static_cast<std::size_t>(r)];
    switch_row(row, holds(row, scene, for_velocities));
    row.at_bound = 0;
  }
  if (stale_ || renumber_) assemble(scene.motions);
}

void JointGroup::switch_row(Row& row, bool on) {
  renumber_ |= row.on != on;
  row.on = on;
}

void JointGroup::number_rows() {
  renumber_ = false;
  on_.clear();
  for (std::size_t i = 0; i < links_.size(); ++i) {
    const std::size_t before = on_.size();
    for (int r = links_[i].first_row; r < links_[i].first_row + links_[i].row_count; ++r) {
      if (rows_[static_cast<std::size_t>(r)].on) on_.push_back(r);
    }
    links_on_[i] = static_cast<int>(on_.size() - before);
  }
  right_side_.assign(in_whole_lanes(on_.size()), 0);
  matrix_.resize(links_on_);
  find_spots();
}

void JointGroup::find_spots() {
  for (Coupling& k : couplings_) {
    k.rows = links_on_[static_cast<std::size_t>(k.row.link)];
    k.columns = links_on_[static_cast<std::size_t>(k.column.link)];
    k.row_levers = place_of_levers(k.row.side, matrix_.first(k.row.link));
    k.column_levers = place_of_levers(k.column.side, matrix_.first(k.column.link));
    k.spot = matrix_.spot(k.place);
  }
}

namespace {

/// The body's part of one row, or of two, in a block: `Numbers` are a real or a pair of them. `mine` and `others` point
/// at the first of its levers and of those of the block's columns; `count` further are their next components.
template <typename Numbers>
[[gnu::always_inline]] inline void add_products(const real* mine, const real* others, int columns, std::size_t count,
                                                Numbers inv_mass, Numbers inv_inertia, real* entries,
                                                std::size_t stride) {
  const Numbers x = inv_mass * packed<Numbers>(mine);
  const Numbers y = inv_mass * packed<Numbers>(mine + count);
  const Numbers spin = inv_inertia * packed<Numbers>(mine + 2 * count);
  for (const real* end = others + columns; others != end; ++others, entries += stride) {
    const Numbers product = (others[0] * x + others[count] * y) + others[2 * count] * spin;
    put_packed(entries, packed<Numbers>(entries) + product);
  }
}

}  // namespace

/// J M^-1 J^T, body by body. Rows go in pairs, as those of pins are. A third one goes with the second again, to which
/// it adds zeros; on the diagonal what is filled above it does not count.
void JointGroup::fill(const std::vector<Motion>& motions) {
  matrix_.clear();
  const std::size_t count = rows_.size();
  for (const Coupling& k : couplings_) {
    const Motion& m = motions[k.body];
    const real* mine = levers_.data() + k.row_levers;
    const real* others = levers_.data() + k.column_levers;
    const BlockMatrix::Block block = matrix_.block(k.spot);
    const auto fill_rows = [&](int row, auto inv_mass, auto inv_inertia) {
      add_products(mine + row, others, k.columns, count, inv_mass, inv_inertia, block.values + row, block.stride);
    };
    if (k.rows == 1) fill_rows(0, m.inv_mass, m.inv_inertia);
    int row = 0;
    for (; row + 2 <= k.rows; row += 2) {
      fill_rows(row, Pair{m.inv_mass, m.inv_mass}, Pair{m.inv_inertia, m.inv_inertia});
    }
    if (row > 0 && row < k.rows) fill_rows(row - 1, Pair{0, m.inv_mass}, Pair{0, m.inv_inertia});
  }
}

/// How the rows that hold push the bodies on their sides.
void JointGroup::find_levers() {
  const std::size_t count = rows_.size();
  for (std::size_t k = 0; k < on_.size(); ++k) {
    const Terms& terms = on_row(k).terms;
    real* levers = levers_.data() + k;
    for (int t = 0; t < terms.count; ++t, levers += 6 * count) {
      const Term& term = terms.terms[t];
      levers[0] = -term.direction.x;
      levers[count] = -term.direction.y;
      levers[2 * count] = -term.arm_a;
      levers[3 * count] = term.direction.x;
      levers[4 * count] = term.direction.y;
      levers[5 * count] = term.arm_b;
    }
  }
}

/// A group that was redundant mostly still is: then the system for that is tried first.
void JointGroup::assemble(const std::vector<Motion>& motions) {
  stale_ = false;
  if (renumber_) number_rows();
  find_levers();
  for (std::size_t i = 0; i < bodies_.size(); ++i) {
    factored_with_[i] = {motions[bodies_[i]].inv_mass, motions[bodies_[i]].inv_inertia};
  }
  if (uneven_ && !strained_) {
    fill(motions);
    uneven_ = factor_with(slight_compliance) > independent;
    if (uneven_) return;
  }
  if (redundant_ && !strained_) {
    fill(motions);
    if (factor_with(redundant_compliance) <= redundant_compliance + redundant) return;
  }
  fill(motions);
  redundant_ = factor_with(strained_ ? strained_compliance : compliance) <= redundant;
  if (strained_ || !redundant_) return;
  fill(motions);
  factor_with(redundant_compliance);
}

/// Returns how independent the rows are.
real JointGroup::factor_with(real give) {
  matrix_.stretch_diagonal(1 + give);
  return matrix_.factor();
}

}  // namespace PROOFREEL_PRECISION
}  // namespace proofreel
