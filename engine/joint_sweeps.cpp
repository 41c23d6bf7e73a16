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

real response_of(const Term& t, const std::vector<Motion>& motions) {
  const Motion& a = motions[t.body_a];
  const Motion& b = motions[t.body_b];
  const real square = dot(t.direction, t.direction);
  return (a.inv_mass * square + a.inv_inertia * t.arm_a * t.arm_a) +
         (b.inv_mass * square + b.inv_inertia * t.arm_b * t.arm_b);
}

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
  pins_.clear();
  rows_.clear();
  sources_.clear();
  for (const std::uint32_t i : ids) {
    if (!joints[i].acts) continue;
    const std::vector<RowPlan> plans = plan_rows(joints[i], wanted);
    for (std::size_t slot = 0; slot < plans.size(); ++slot) {
      if (slot + 1 < plans.size() && JointPins::is_pin(plans[slot], plans[slot + 1])) {
        pins_.add(i, static_cast<std::uint32_t>(slot++), joints);
        continue;
      }
      Source& source = sources_.emplace_back();
      source.joint = i;
      source.slot = static_cast<std::uint32_t>(slot);
      source.plan = plans[slot];
      source.terms = bodies_of(joints[i], joints);
      const Term& term = source.terms.terms[0];
      const bool plain = source.plan.bound == Bound::equal && source.terms.count == 1 && term.body_a != term.body_b;
      rows_.push_back({term, 0, 0, 0, plain});
    }
  }
}

void JointSweeps::linearize(const JointedBodies& scene) {
  pins_.linearize(scene);
  for (std::size_t i = 0; i < rows_.size();) {
    const std::uint32_t number = sources_[i].joint;
    const Joint& joint = scene.joints[number];
    const JointPlace place = place_of(joint, scene.bodies, scene.motions);
    for (; i < rows_.size() && sources_[i].joint == number; ++i) linearize_row(i, joint, place, scene);
  }
}

void JointSweeps::linearize_row(std::size_t i, const Joint& joint, const JointPlace& place,
                                const JointedBodies& scene) {
  Row& row = rows_[i];
  Source& source = sources_[i];
  source.terms = terms_of(source.plan, joint, place, scene);
  row.term = source.terms.terms[0];
  row.value = source.plan.bound == Bound::driven ? 0 : value_of(source.plan, joint, place, scene, 0);
  const real response = row.plain ? response_of(row.term, scene.motions) : response_of(source.terms, scene.motions);
  row.mass = response > 0 ? 1 / response : 0;
}

void JointSweeps::apply(std::size_t i, real impulse, const JointedBodies& scene) {
  rows_[i].given += impulse;
  if (rows_[i].plain) return push(rows_[i].term, impulse, scene.motions);
  const Terms& terms = sources_[i].terms;
  const bool driven = sources_[i].plan.bound == Bound::driven;
  const real before = driven ? speed_of(terms, scene.motions) : 0;
  push(terms, impulse, scene.motions);
  if (driven) work_ += static_cast<double>(impulse * real(0.5) * (before + speed_of(terms, scene.motions)));
}

/// What has been given since the last time, before directions change.
void JointSweeps::book(const JointedBodies& scene) {
  for (std::size_t i = 0; i < rows_.size(); ++i) {
    Source& source = sources_[i];
    const real impulse = rows_[i].given - std::exchange(source.booked, rows_[i].given);
    book_reaction(scene.joints[source.joint], source.terms, impulse);
    source.total += impulse;
  }
}

void JointSweeps::begin_substep(const JointedBodies& scene, real share) {
  pins_.begin_substep(share, scene.motions);
  for (std::size_t i = 0; i < rows_.size(); ++i) {
    sources_[i].warm = scene.joints[sources_[i].joint].memory[sources_[i].slot].impulse;
    sources_[i].booked = 0;
    rows_[i].given = 0;
  }
  give_share(scene, share);
}

void JointSweeps::add_share(const JointedBodies& scene, real share) {
  pins_.add_share(share, scene.motions);
  give_share(scene, share);
}

void JointSweeps::give_share(const JointedBodies& scene, real share) {
  for (std::size_t i = 0; i < rows_.size(); ++i) apply(i, share * sources_[i].warm, scene);
}

/// Rigid, or with the give of a spring that pulls the row's number to 0.
inline void JointSweeps::solve_plain(Row& row, const Softness& give, std::vector<Motion>& motions) {
  const real lacking = -(give.bias_rate * row.value) - speed_of(row.term, motions);
  const real before = row.given;
  row.given += give.mass_scale * row.mass * lacking - give.impulse_scale * before;
  push(row.term, row.given - before, motions);
}

inline void JointSweeps::solve(std::size_t i, const Softness& soft, const JointedBodies& scene, real h) {
  rows_[i].plain ? solve_plain(rows_[i], soft, scene.motions) : solve_bounded(i, soft, scene, h);
}

/// A stop that is not reached yet may come as close as touching.
void JointSweeps::solve_bounded(std::size_t i, const Softness& soft, const JointedBodies& scene, real h) {
  const Row& row = rows_[i];
  const RowPlan& plan = sources_[i].plan;
  const Joint& joint = scene.joints[sources_[i].joint];
  constexpr real unbound = std::numeric_limits<real>::max();
  const bool driven = plan.bound == Bound::driven;
  const bool open_stop = plan.bound == Bound::at_least && row.value > 0;
  const real most = driven ? h * strongest(plan, joint) : unbound;
  const real least = driven ? -most : plan.bound == Bound::at_least ? real(0) : -unbound;
  const Softness& give = driven || open_stop ? rigid : soft;
  const real closing = open_stop ? row.value / h : give.bias_rate * row.value;
  const real lacking = wanted_speed(plan, joint) - closing - speed_of(sources_[i].terms, scene.motions);
  const real change = give.mass_scale * row.mass * lacking - give.impulse_scale * row.given;
  apply(i, std::clamp(row.given + change, least, most) - row.given, scene);
}

void JointSweeps::solve_positions(const JointedBodies& scene, real h) {
  if (empty()) return;
  const Softness soft = make_softness(plan_.stiffness / h, damping_ratio, h);
  for (int sweep = 0; sweep < plan_.sweeps; ++sweep) {
    count_row_updates(row_count());
    pins_.sweep_softly(soft, scene.motions);
    for (std::size_t i = 0; i < rows_.size(); ++i) solve(i, soft, scene, h);
  }
  book(scene);
}

/// Backwards along the chains, so that neither end is favoured. A stop that has not been reached yet must not be braked
/// for: it may only take back.
void JointSweeps::solve_velocities(const JointedBodies& scene, real h) {
  for (int sweep = 0; sweep < plan_.sweeps; ++sweep) {
    count_row_updates(row_count());
    for (std::size_t i = rows_.size(); i-- > 0;) {
      const bool open_stop = !rows_[i].plain && sources_[i].plan.bound == Bound::at_least && rows_[i].value > 0;
      if (!open_stop || rows_[i].given > 0) solve(i, rigid, scene, h);
    }
    pins_.sweep_back(scene.motions);
  }
  book(scene);
  pins_.keep();
  for (std::size_t i = 0; i < rows_.size(); ++i)
    scene.joints[sources_[i].joint].memory[sources_[i].slot].impulse = rows_[i].given;
}

double JointSweeps::take_work(const JointedBodies& scene) {
  work_ += pins_.take_work(scene);
  for (Source& source : sources_) work_ += work_of_movers(source.terms, std::exchange(source.total, real(0)), scene);
  return std::exchange(work_, 0);
}

}  // namespace PROOFREEL_PRECISION
}  // namespace proofreel
