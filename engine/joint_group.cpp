#include "engine/joint_group.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "engine/joints/kinds.h"

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

}  // namespace

JointGroup::JointGroup(const std::vector<std::uint32_t>& ids, const std::vector<Joint>& joints,
                       const std::vector<Motion>& motions, RowsWanted wanted) {
  for (const std::uint32_t i : ids) {
    const std::vector<RowPlan> plans = plan_rows(joints[i], wanted);
    for (std::size_t slot = 0; slot < plans.size(); ++slot) {
      Row& row = rows_.emplace_back();
      row.joint = i;
      row.slot = slot;
      row.plan = plans[slot];
      row.terms = bodies_of(joints[i], joints);
      one_sided_ += row.plan.bound == Bound::at_least;
      driven_ += row.plan.bound == Bound::driven;
    }
  }
  right_side_.assign(rows_.size(), 0);
  couple(motions);
}

void JointGroup::couple(const std::vector<Motion>& motions) {
  struct Side {
    int row;
    std::uint8_t term;
    bool is_b;
  };
  std::vector<int> first(rows_.size());
  std::vector<std::pair<BodyIndex, std::vector<Side>>> sides;
  const auto sides_of = [&sides](BodyIndex body) -> std::vector<Side>& {
    const auto at = std::lower_bound(sides.begin(), sides.end(), body,
                                     [](const auto& entry, BodyIndex index) { return entry.first < index; });
    return at != sides.end() && at->first == body ? at->second : sides.insert(at, {body, {}})->second;
  };
  for (int r = 0; r < static_cast<int>(rows_.size()); ++r) {
    const Row& row = rows_[static_cast<std::size_t>(r)];
    int& first_column = first[static_cast<std::size_t>(r)] = r;
    for (int side = 0; side < 2 * row.terms.count; ++side) {
      const auto term = static_cast<std::uint8_t>(side / 2);
      const bool is_b = side % 2 == 1;
      const BodyIndex body = is_b ? row.terms.terms[term].body_b : row.terms.terms[term].body_a;
      if (motions[body].inv_mass <= 0 && motions[body].inv_inertia <= 0) continue;
      std::vector<Side>& others = sides_of(body);
      others.push_back({r, term, is_b});
      for (const Side& other : others) {
        const Coupling coupling{r, other.row, body, term, other.term, is_b, other.is_b};
        couplings_.push_back(coupling);
        first_column = std::min(first_column, other.row);
        // A gear may hold the same body twice; then its two sides meet in both orders.
        if (other.row == r && (other.term != term || other.is_b != is_b)) couplings_.push_back(coupling);
      }
    }
  }
  for (const auto& [body, rows] : sides) bodies_.push_back(body);
  matrix_.reset(first);
}

real JointGroup::entry(const Coupling& k, const std::vector<Motion>& motions) const {
  const Term& row = rows_[static_cast<std::size_t>(k.row)].terms.terms[k.row_term];
  const Term& column = rows_[static_cast<std::size_t>(k.column)].terms.terms[k.column_term];
  const Motion& m = motions[k.body];
  const real arms = (k.row_is_b ? row.arm_b : row.arm_a) * (k.column_is_b ? column.arm_b : column.arm_a);
  const real sum = m.inv_mass * dot(row.direction, column.direction) + m.inv_inertia * arms;
  return k.row_is_b == k.column_is_b ? sum : -sum;
}

void JointGroup::linearize(const JointedBodies& scene) {
  stale_ = true;
  JointPlace place;
  const Joint* placed = nullptr;
  for (Row& row : rows_) {
    const Joint& joint = scene.joints[row.joint];
    if (placed != &joint) place = place_of(joint, scene.bodies, scene.motions);
    placed = &joint;
    row.terms = terms_of(row.plan, joint, place, scene);
    row.scale = scale_of(row, scene);
  }
}

/// Metres are measured by the joint's size and the way to its stop; angles by themselves, for the last digits of many
/// turns are lost.
real JointGroup::scale_of(const Row& row, const JointedBodies& scene) const {
  const real size = scene.joints[row.joint].size;
  if (row.plan.coordinate == Coordinate::stretch) return size;
  if (row.plan.coordinate != Coordinate::turn && row.plan.coordinate != Coordinate::geared)
    return size + std::abs(row.plan.offset);
  real angles = 1;
  for (int t = 0; t < row.terms.count; ++t) {
    const Term& term = row.terms.terms[t];
    angles += std::abs(term.arm_a * scene.motions[term.body_a].angle);
    angles += std::abs(term.arm_b * scene.motions[term.body_b].angle);
  }
  return real(0.125) * angles;
}

bool JointGroup::holds(const Row& row, const JointedBodies& scene, bool for_velocities) const {
  if (row.plan.bound == Bound::equal) return true;
  return row.plan.bound == Bound::driven ? for_velocities : memory(row, scene).engaged;
}

void JointGroup::prepare(const JointedBodies& scene, bool for_velocities) {
  bool changed = stale_;
  if (one_sided_ + driven_ > 0) {
    for (Row& row : rows_) {
      const bool on = holds(row, scene, for_velocities);
      changed |= on != row.on;
      row.on = on;
      row.at_bound = 0;
      row.touched = on;
    }
  }
  if (changed) assemble(scene.motions);
}

void JointGroup::fill(const std::vector<Motion>& motions) {
  matrix_.clear();
  if (one_sided_ + driven_ == 0) {
    for (const Coupling& k : couplings_) matrix_.at(k.row, k.column) += entry(k, motions);
  } else {
    for (const Coupling& k : couplings_) {
      if (!rows_[static_cast<std::size_t>(k.row)].on || !rows_[static_cast<std::size_t>(k.column)].on) continue;
      matrix_.at(k.row, k.column) += entry(k, motions);
    }
  }
}

/// A group that was redundant mostly still is: then the system for that is tried first.
void JointGroup::assemble(const std::vector<Motion>& motions) {
  stale_ = false;
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
  for (int r = 0; r < matrix_.size(); ++r) matrix_.at(r, r) *= 1 + give;
  return matrix_.factor();
}

void JointGroup::apply(Row& row, real impulse, const JointedBodies& scene) const {
  push_joint(scene.joints[row.joint], row.terms, impulse, scene.motions);
  row.total += impulse;
}

/// Motors give one half of their impulse before the drift and one half after it, as all forces do: what a motor holds
/// does not creep, and what it accelerates does so to second order.
void JointGroup::begin_substep(const JointedBodies& scene, real h, real share) {
  if (driven_ > 0) begin_motors(scene, h, share);
  for (Row& row : rows_) {
    row.pushed = 0;
    // Forces that redundant joints exert on each other move nothing and would grow from substep to substep.
    if (redundant_ && row.plan.bound != Bound::driven) memory(row, scene).impulse = 0;
    apply(row, row.plan.bound == Bound::driven ? row.begun : memory(row, scene).impulse, scene);
  }
}

void JointGroup::begin_motors(const JointedBodies& scene, real h, real share) {
  for (Row& row : rows_) {
    if (row.plan.bound != Bound::driven) continue;
    const real most = h * strongest(row.plan, scene.joints[row.joint]);
    row.begun = share * std::clamp(memory(row, scene).impulse, -most, most);
    row.speed_before = speed_of(row.terms, scene.motions);
    work_ += static_cast<double>(row.begun * row.speed_before);
  }
}

/// Impulses do work by the mean of the speeds before and after, and after means when all joints have had their say.
void JointGroup::book_begun(const JointedBodies& scene) {
  for (Row& row : rows_) {
    if (row.plan.bound != Bound::driven) continue;
    const real now = speed_of(row.terms, scene.motions);
    work_ += 0.5 * static_cast<double>(row.begun * (now - row.speed_before));
    row.speed_before = now;
  }
}

void JointGroup::hold(std::vector<Motion>& motions) const {
  std::vector<real> impulses(rows_.size());
  for (std::size_t r = 0; r < rows_.size(); ++r) impulses[r] = rows_[r].on ? -speed_of(rows_[r].terms, motions) : 0;
  matrix_.solve(impulses);
  for (std::size_t r = 0; r < rows_.size(); ++r) {
    if (rows_[r].on) push(rows_[r].terms, impulses[r], motions);
  }
}

double JointGroup::take_work(const JointedBodies& scene) {
  for (Row& row : rows_) work_ += work_of_movers(row.terms, std::exchange(row.total, real(0)), scene);
  return std::exchange(work_, 0);
}

}  // namespace PROOFREEL_PRECISION
}  // namespace proofreel
