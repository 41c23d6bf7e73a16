#include "engine/joint_sweeps.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "engine/work.h"

namespace proofreel {
inline namespace PROOFREEL_PRECISION {
namespace {

/// Of the springs that close gaps.
constexpr real damping_ratio = 2;

/// What a row's speed changes by for a unit impulse along it. A gear may move one body by both of its terms.
real response_of(const Terms& terms, const std::vector<Motion>& motions) {
  real sum = 0;
  for (int t = 0; t < terms.count; ++t) {
    for (int u = 0; u < terms.count; ++u) {
      const Term& one = terms.terms[t];
      const Term& other = terms.terms[u];
      const auto add = [&](BodyIndex body, real sign, real arm, real other_arm) {
        const Motion& m = motions[body];
        sum += sign * (m.inv_mass * dot(one.direction, other.direction) + m.inv_inertia * arm * other_arm);
      };
      if (one.body_a == other.body_a) add(one.body_a, 1, one.arm_a, other.arm_a);
      if (one.body_b == other.body_b) add(one.body_b, 1, one.arm_b, other.arm_b);
      if (one.body_a == other.body_b) add(one.body_a, -1, one.arm_a, other.arm_b);
      if (one.body_b == other.body_a) add(one.body_b, -1, one.arm_b, other.arm_a);
    }
  }
  return sum;
}

constexpr Softness rigid{};

}  // namespace

void JointSweeps::rebuild(const std::vector<Joint>& joints, const std::vector<std::uint32_t>& ids, RowsWanted wanted) {
  rows_.clear();
  for (const std::uint32_t i : ids) {
    if (!joints[i].acts) continue;
    const std::vector<RowPlan> plans = plan_rows(joints[i], wanted);
    for (std::size_t slot = 0; slot < plans.size(); ++slot) {
      Row& row = rows_.emplace_back();
      row.joint = i;
      row.slot = slot;
      row.plan = plans[slot];
    }
  }
}

void JointSweeps::linearize(const JointedBodies& scene) {
  for (auto row = rows_.begin(); row != rows_.end();) {
    const std::uint32_t number = row->joint;
    const Joint& joint = scene.joints[number];
    const JointPlace place = place_of(joint, scene.bodies, scene.motions);
    for (; row != rows_.end() && row->joint == number; ++row) {
      row->terms = terms_of(row->plan, joint, place, scene);
      row->value = row->plan.bound == Bound::driven ? 0 : value_of(row->plan, joint, place, scene, 0);
      const real response = response_of(row->terms, scene.motions);
      row->mass = response > 0 ? 1 / response : 0;
    }
  }
}

void JointSweeps::apply(Row& row, real impulse, const JointedBodies& scene) {
  const bool driven = row.plan.bound == Bound::driven;
  const real before = driven ? speed_of(row.terms, scene.motions) : 0;
  push(row.terms, impulse, scene.motions);
  book_reaction(scene.joints[row.joint], row.terms, impulse);
  if (driven) work_ += static_cast<double>(impulse * real(0.5) * (before + speed_of(row.terms, scene.motions)));
  row.given += impulse;
  row.total += impulse;
}

void JointSweeps::begin_substep(const JointedBodies& scene, real share) {
  for (Row& row : rows_) {
    row.warm = scene.joints[row.joint].memory[row.slot].impulse;
    row.given = 0;
  }
  add_share(scene, share);
}

void JointSweeps::add_share(const JointedBodies& scene, real share) {
  for (Row& row : rows_) apply(row, share * row.warm, scene);
}

/// Rigid, or with the give of a spring that pulls the row's number to 0. A stop that is not reached yet may come as
/// close as touching.
void JointSweeps::solve(Row& row, const Softness& soft, const JointedBodies& scene, real h) {
  const Joint& joint = scene.joints[row.joint];
  constexpr real unbound = std::numeric_limits<real>::max();
  const bool driven = row.plan.bound == Bound::driven;
  const bool open_stop = row.plan.bound == Bound::at_least && row.value > 0;
  const real most = driven ? h * strongest(row.plan, joint) : unbound;
  const real least = driven ? -most : row.plan.bound == Bound::at_least ? real(0) : -unbound;
  const Softness& give = driven || open_stop ? rigid : soft;
  const real closing = open_stop ? row.value / h : give.bias_rate * row.value;
  const real lacking = wanted_speed(row.plan, joint) - closing - speed_of(row.terms, scene.motions);
  const real change = give.mass_scale * row.mass * lacking - give.impulse_scale * row.given;
  apply(row, std::clamp(row.given + change, least, most) - row.given, scene);
}

void JointSweeps::solve_positions(const JointedBodies& scene, real h) {
  const Softness soft = make_softness(plan_.stiffness / h, damping_ratio, h);
  for (int i = 0; i < plan_.sweeps; ++i) {
    count_row_updates(rows_.size());
    for (Row& row : rows_) solve(row, soft, scene, h);
  }
}

/// Backwards along the chains, so that neither end is favoured. A stop that has not been reached yet must not be braked
/// for: it may only take back.
void JointSweeps::solve_velocities(const JointedBodies& scene, real h) {
  for (int i = 0; i < plan_.sweeps; ++i) {
    count_row_updates(rows_.size());
    for (auto row = rows_.rbegin(); row != rows_.rend(); ++row) {
      const bool open_stop = row->plan.bound == Bound::at_least && row->value > 0;
      if (!open_stop || row->given > 0) solve(*row, rigid, scene, h);
    }
  }
  for (const Row& row : rows_) scene.joints[row.joint].memory[row.slot].impulse = row.given;
}

double JointSweeps::take_work(const JointedBodies& scene) {
  for (Row& row : rows_) work_ += work_of_movers(row.terms, std::exchange(row.total, real(0)), scene);
  return std::exchange(work_, 0);
}

}  // namespace PROOFREEL_PRECISION
}  // namespace proofreel
