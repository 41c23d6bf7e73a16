#include "engine/joint_solver.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace proofreel {
inline namespace PROOFREEL_PRECISION {
namespace {

/// Newton's iterations for the positions converge quadratically at first and then at the rate the bodies turn per
/// substep; two or three are the rule.
constexpr int max_newton_steps = 12;
/// What Newton's method may leave open, relative to the joint's size, and still count as having arrived.
constexpr real good_enough = sizeof(real) == sizeof(double) ? real(1e-9) : real(1e-5);
/// Where joints contradict each other, nearly singular rows would ask for any impulse to win the last nanometre. So
/// much give, relative to the row's own mass, keeps them finite; what it leaves open the next Newton step closes.
constexpr real compliance = real(1e-6);
/// A joint that starts torn is closed at this many times its own size per second, gently instead of within one substep.
constexpr real closing_rate = 4;

}  // namespace

/// Joints in an order that keeps neighbours close together, by breadth-first search from an end of each chain (Cuthill
/// and McKee 1969). Joints are neighbours when they move a common body.
std::vector<std::uint32_t> JointSolver::ordered_joints(const std::vector<Joint>& joints,
                                                       const std::vector<Motion>& motions) const {
  std::vector<std::vector<std::uint32_t>> at_body(motions.size());
  std::vector<std::uint32_t> rigid;
  for (std::uint32_t i = 0; i < joints.size(); ++i) {
    const bool movable = motions[joints[i].body_a].inv_mass > 0 || motions[joints[i].body_b].inv_mass > 0;
    if (!joints[i].alive || !is_rigid(joints[i]) || !movable) continue;
    rigid.push_back(i);
    for (const BodyIndex body : {joints[i].body_a, joints[i].body_b}) {
      if (motions[body].inv_mass > 0) at_body[body].push_back(i);
    }
  }
  const auto degree = [&](std::uint32_t i) {
    return at_body[joints[i].body_a].size() + at_body[joints[i].body_b].size();
  };
  std::vector<std::uint32_t> starts = rigid;
  std::stable_sort(starts.begin(), starts.end(), [&](auto i, auto j) { return degree(i) < degree(j); });
  std::vector<bool> seen(joints.size(), false);
  std::vector<std::uint32_t> order;
  for (const std::uint32_t start : starts) {
    if (seen[start]) continue;
    seen[start] = true;
    order.push_back(start);
    for (std::size_t next = order.size() - 1; next < order.size(); ++next) {
      const Joint& joint = joints[order[next]];
      for (const BodyIndex body : {joint.body_a, joint.body_b}) {
        for (const std::uint32_t neighbour : at_body[body]) {
          if (!seen[neighbour]) order.push_back(neighbour);
          seen[neighbour] = true;
        }
      }
    }
  }
  return order;
}

void JointSolver::rebuild(const std::vector<Joint>& joints, const std::vector<Motion>& motions) {
  rows_.clear();
  for (const std::uint32_t i : ordered_joints(joints, motions)) {
    for (int component = 0; component < row_count(joints[i]); ++component) {
      rows_.push_back({i, component, joints[i].body_a, joints[i].body_b, {}, 0, 0, 0});
    }
  }
  right_side_.assign(rows_.size(), 0);
  couple(motions);
}

void JointSolver::couple(const std::vector<Motion>& motions) {
  couplings_.clear();
  std::vector<int> first(rows_.size());
  std::vector<std::vector<int>> rows_at(motions.size());
  for (int r = 0; r < static_cast<int>(rows_.size()); ++r) {
    const Row& row = rows_[static_cast<std::size_t>(r)];
    first[static_cast<std::size_t>(r)] = r;
    for (const bool is_b : {false, true}) {
      const BodyIndex body = is_b ? row.body_b : row.body_a;
      if (motions[body].inv_mass <= 0 && motions[body].inv_inertia <= 0) continue;
      rows_at[body].push_back(r);
      for (const int c : rows_at[body]) {
        couplings_.push_back({r, c, body, is_b, rows_[static_cast<std::size_t>(c)].body_b == body});
        first[static_cast<std::size_t>(r)] = std::min(first[static_cast<std::size_t>(r)], c);
      }
    }
  }
  matrix_.reset(first);
}

void JointSolver::linearize(const std::vector<Joint>& joints, const std::vector<Body>& bodies,
                            const std::vector<Motion>& motions) {
  for (Row& row : rows_) {
    const Joint& joint = joints[row.joint];
    const AnchorGap g = anchor_gap(joint, bodies, motions);
    row.direction = joint.kind == JointKind::distance ? normalized(g.gap)
                    : row.component == 0              ? Vec2{1, 0}
                                                      : Vec2{0, 1};
    row.arm_a = cross(g.arm_a, row.direction);
    row.arm_b = cross(g.arm_b, row.direction);
  }
  matrix_.clear();
  for (const Coupling& k : couplings_) {
    const Row& row = rows_[static_cast<std::size_t>(k.row)];
    const Row& column = rows_[static_cast<std::size_t>(k.column)];
    const Motion& m = motions[k.body];
    const real arms = (k.row_is_b ? row.arm_b : row.arm_a) * (k.column_is_b ? column.arm_b : column.arm_a);
    const real entry = m.inv_mass * dot(row.direction, column.direction) + m.inv_inertia * arms;
    matrix_.at(k.row, k.column) += k.row_is_b == k.column_is_b ? entry : -entry;
  }
  for (int r = 0; r < matrix_.size(); ++r) matrix_.at(r, r) *= 1 + compliance;
  matrix_.factor();
}

void JointSolver::apply(const Row& row, real impulse, std::vector<Joint>& joints, std::vector<Motion>& motions) const {
  Motion& a = motions[row.body_a];
  Motion& b = motions[row.body_b];
  a.velocity -= impulse * a.inv_mass * row.direction;
  a.spin -= impulse * a.inv_inertia * row.arm_a;
  b.velocity += impulse * b.inv_mass * row.direction;
  b.spin += impulse * b.inv_inertia * row.arm_b;
  joints[row.joint].impulse += impulse * row.direction;
}

namespace {

real& component_of(Vec2& v, int component) { return component == 0 ? v.x : v.y; }

}  // namespace

void JointSolver::begin_substep(std::vector<Joint>& joints, std::vector<Motion>& motions) {
  for (const Row& row : rows_) {
    apply(row, component_of(joints[row.joint].warm_impulse, row.component), joints, motions);
  }
}

real JointSolver::row_violation(const Row& row, const Joint& joint, Vec2 gap) const {
  if (joint.kind == JointKind::distance) return length(gap) - joint.length;
  return component_of(gap, row.component);
}

void JointSolver::set_goals(const std::vector<Joint>& joints, const std::vector<Body>& bodies,
                            const std::vector<Motion>& motions, real h) {
  for (Row& row : rows_) {
    const Joint& joint = joints[row.joint];
    const real now = row_violation(row, joint, anchor_gap(joint, bodies, motions).gap);
    const real most = closing_rate * joint.size * h;
    row.goal = std::abs(now) > most ? now - std::copysign(most, now) : 0;
  }
}

/// Puts into the right side by how much each row would miss its goal after drifting for `h`; the largest miss, in
/// units of the joint's size, comes back.
real JointSolver::predict(const std::vector<Joint>& joints, const std::vector<Body>& bodies,
                          const std::vector<Motion>& motions, real h) {
  real worst = 0;
  for (std::size_t r = 0; r < rows_.size(); ++r) {
    const Row& row = rows_[r];
    const Joint& joint = joints[row.joint];
    Motion a = motions[row.body_a];
    Motion b = motions[row.body_b];
    drift(a, h);
    drift(b, h);
    const Vec2 centers = (bodies[row.body_b].center - bodies[row.body_a].center) + (b.delta - a.delta);
    const Vec2 gap = centers + (rotate(b.rotation, joint.local_b) - rotate(a.rotation, joint.local_a));
    const real miss = row_violation(row, joint, gap) - row.goal;
    right_side_[r] = -miss / h;
    worst = std::max(worst, std::abs(miss) / joint.size);
  }
  return worst;
}

void JointSolver::add_solution(std::vector<Joint>& joints, std::vector<Motion>& motions) const {
  for (std::size_t r = 0; r < rows_.size(); ++r) {
    component_of(joints[rows_[r].joint].warm_impulse, rows_[r].component) += right_side_[r];
    apply(rows_[r], right_side_[r], joints, motions);
  }
}

void JointSolver::take_back(std::vector<Joint>& joints, std::vector<Motion>& motions) const {
  for (const Row& row : rows_) {
    real& impulse = component_of(joints[row.joint].warm_impulse, row.component);
    apply(row, -impulse, joints, motions);
    impulse = 0;
  }
}

/// Newton's method. Where joints contradict each other (a chain pulled straight between two walls) no impulses lead to
/// a solution, and looking for one would only throw the bodies about: then the joints are closed at a bounded speed
/// instead.
void JointSolver::solve_positions(std::vector<Joint>& joints, const std::vector<Body>& bodies,
                                  std::vector<Motion>& motions, real h) {
  set_goals(joints, bodies, motions, h);
  const real tolerance = 32 * std::numeric_limits<real>::epsilon();
  real miss = predict(joints, bodies, motions, h);
  for (int step = 0; step < max_newton_steps && miss > tolerance; ++step) {
    matrix_.solve(right_side_);
    add_solution(joints, motions);
    const real next = predict(joints, bodies, motions, h);
    if (!(next < miss)) break;
    miss = next;
  }
  if (miss <= good_enough) return;
  take_back(joints, motions);
  for (std::size_t r = 0; r < rows_.size(); ++r) {
    const Joint& joint = joints[rows_[r].joint];
    const real open = row_violation(rows_[r], joint, anchor_gap(joint, bodies, motions).gap);
    const real most = closing_rate * joint.size;
    right_side_[r] = -row_speed(rows_[r], motions) - std::clamp(real(0.1) * open / h, -most, most);
  }
  matrix_.solve(right_side_);
  for (std::size_t r = 0; r < rows_.size(); ++r) apply(rows_[r], right_side_[r], joints, motions);
}

real JointSolver::row_speed(const Row& row, const std::vector<Motion>& motions) const {
  const Motion& a = motions[row.body_a];
  const Motion& b = motions[row.body_b];
  return dot(b.velocity - a.velocity, row.direction) + row.arm_b * b.spin - row.arm_a * a.spin;
}

void JointSolver::solve_velocities(std::vector<Joint>& joints, std::vector<Motion>& motions) {
  for (std::size_t r = 0; r < rows_.size(); ++r) right_side_[r] = -row_speed(rows_[r], motions);
  matrix_.solve(right_side_);
  for (std::size_t r = 0; r < rows_.size(); ++r) apply(rows_[r], right_side_[r], joints, motions);
}

}  // namespace PROOFREEL_PRECISION
}  // namespace proofreel
