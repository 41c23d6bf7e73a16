// Joints that stand open are closed by moving their bodies, as overlaps are by nonlinear Gauss-Seidel: a way is not a
// velocity. Closed by velocities, gaps of a metre along a chain add up to a hundred metres per second at its end, and
// the velocity stage takes them out along directions that have turned meanwhile: what it leaves throws the links.

#include <algorithm>
#include <cmath>

#include "engine/joint_group.h"
#include "engine/work.h"

namespace proofreel {
inline namespace PROOFREEL_PRECISION {
namespace {

/// A move is linear; what turning leaves open the next one closes.
constexpr int most_moves = 3;
/// The part of the way that may be left after these.
constexpr real most_left = real(0.1);

bool has_to_close(const RowPlan& plan, real now) {
  return plan.bound == Bound::equal || (plan.bound == Bound::at_least && now < 0);
}

}  // namespace

/// Every gap by as much as it may close within `h`, or all of it where little more would be left. False if they do not
/// follow (joints that contradict each other): then nothing has moved.
bool JointGroup::close_by_moving(const JointedBodies& scene, real h) {
  moved_from_.clear();
  for (const BodyIndex body : bodies_) moved_from_.push_back(scene.motions[body]);
  for (Row& row : rows_) {
    const real most = closing_rate * scene.joints[row.joint].size * std::abs(h);
    switch_row(row, has_to_close(row.plan, row.value));
    row.goal = std::abs(row.value) > 2 * most ? row.value - std::copysign(most, row.value) : 0;
  }
  const real way = longest_way(scene);
  real left = way;
  for (int i = 0; i < most_moves; ++i) {
    move_to_goals(scene);
    for (std::size_t b = 0; b < bodies_.size(); ++b) scene.motions[bodies_[b]].inv_inertia = moved_from_[b].inv_inertia;
    linearize(scene);
    left = longest_way(scene);
    if (!(left < real(0.5) * way)) break;
  }
  const bool followed = left < most_left * way;
  for (std::size_t b = 0; b < bodies_.size(); ++b) {
    Motion& m = scene.motions[bodies_[b]];
    if (!followed) m = moved_from_[b];
    m.velocity = moved_from_[b].velocity;
    m.spin = moved_from_[b].spin;
  }
  if (followed) {
    keep_goals(scene, h);
  } else {
    moved_from_.clear();
    linearize(scene);
    set_goals(scene, h);
  }
  return followed;
}

/// To the goals, in sizes of the joint.
real JointGroup::longest_way(const JointedBodies& scene) const {
  real longest = 0;
  for (const Row& row : rows_) {
    if (row.on) longest = std::max(longest, std::abs(row.value - row.goal) / scene.joints[row.joint].size);
  }
  return longest;
}

/// What is still open after moving stays so during the substep.
void JointGroup::keep_goals(const JointedBodies& scene, real h) {
  for (Row& row : rows_) {
    const real most = closing_rate * scene.joints[row.joint].size * std::abs(h);
    row.goal = std::abs(row.value) > most && has_to_close(row.plan, row.value) ? row.value : 0;
  }
}

void JointGroup::take_back_moves(std::vector<Motion>& motions) {
  for (std::size_t b = 0; b < moved_from_.size(); ++b) motions[bodies_[b]] = moved_from_[b];
  moved_from_.clear();
}

/// The least way that leads to the goals. What pulls at both ends of a link turns it into its line; a long pull at a
/// light link would turn it over and over. So in a second solution that resistance to turning counts as inertia (an
/// implicit step; see joint_tension.h).
void JointGroup::move_to_goals(const JointedBodies& scene) {
  const auto find_ways = [&] {
    assemble(scene.motions);
    for (std::size_t k = 0; k < on_.size(); ++k) right_side_[k] = on_row(k).goal - on_row(k).value;
    matrix_.solve(right_side_);
    count_row_updates(on_.size());
  };
  find_ways();
  stiffen(scene);
  find_ways();
  for (const BodyIndex body : bodies_) {
    scene.motions[body].velocity = {};
    scene.motions[body].spin = 0;
  }
  for (std::size_t k = 0; k < on_.size(); ++k) push(on_row(k).terms, right_side_[k], scene.motions);
  for (const BodyIndex body : bodies_) drift(scene.motions[body], 1);
}

/// Takes the right side for impulses, and adds what they resist turning with to the inertia of the bodies.
void JointGroup::stiffen(const JointedBodies& scene) {
  std::vector<real> holds(scene.motions.size());
  for (std::size_t k = 0; k < on_.size(); ++k) {
    const Row& row = on_row(k);
    const JointPlace place = place_of(scene.joints[row.joint], scene.bodies, scene.motions);
    for (int t = 0; t < row.terms.count; ++t) {
      const Term& term = row.terms.terms[t];
      const Vec2 force = right_side_[k] * term.direction;
      holds[term.body_a] -= dot(force, place.arm_a);
      holds[term.body_b] += dot(force, place.arm_b);
    }
  }
  for (const BodyIndex body : bodies_) {
    real& inverse = scene.motions[body].inv_inertia;
    inverse /= 1 + inverse * std::max(real(0), holds[body]);
  }
}

}  // namespace PROOFREEL_PRECISION
}  // namespace proofreel
