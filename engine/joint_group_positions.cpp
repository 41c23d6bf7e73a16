// The position stage of a group: velocities that lead onto the joints.

#include <algorithm>
#include <cmath>

#include "engine/drift.h"
#include "engine/joint_group.h"
#include "engine/lanes.h"
#include "engine/work.h"

namespace proofreel {
inline namespace PROOFREEL_PRECISION {
namespace {

/// Newton's iterations for the positions converge quadratically at first and then at the rate the bodies turn per
/// substep; two or three are the rule.
constexpr int max_newton_steps = 12;
/// What Newton's method may leave open, relative to the row's scale, and still count as having arrived.
constexpr real good_enough = sizeof(real) == sizeof(double) ? real(1e-9) : real(1e-5);

}  // namespace

/// True when a joint is too far open to be closed within the substep.
bool JointGroup::set_goals(const JointedBodies& scene, real h) {
  bool torn = false;
  for (const Link& link : links_) {
    const real most = closing_rate * scene.joints[link.joint].size * std::abs(h);  // suzuki4 steps backwards, too
    for (Row& row : rows_of(link)) {
      const bool free_to_part = row.plan.bound == Bound::at_least && row.value > 0;
      const bool open = std::abs(row.value) > most && !free_to_part;
      torn |= open && row.plan.bound != Bound::driven;
      row.goal = open ? row.value - std::copysign(most, row.value) : 0;
    }
  }
  return torn;
}

/// Where the joint of a link will be. Most need no more of that than these two.
inline void JointGroup::look_ahead(const Link& link, const JointedBodies& scene, JointPlace& place) const {
  const Motion& a = ahead_[static_cast<std::size_t>(link.place_a)];
  const Motion& b = ahead_[static_cast<std::size_t>(link.place_b)];
  if (!link.plain) {
    place = place_on(link, scene, a, b);
    return;
  }
  const JointPlace plain = place_of(link.anchors, a, b);
  place.gap = plain.gap;
  place.turn = plain.turn;
}

/// Turns what is missed into the speeds that would make up for it. The largest miss comes back, in units of its scale.
/// (Divisions are slow, and there are two for every row.)
inline real JointGroup::aim(real h) {
  Lanes worst{};
  for (std::size_t k = 0; k < on_.size(); k += lanes) {
    const Lanes miss = lanes_at(&right_side_[k]);
    const Lanes size = (miss < 0 ? -miss : miss) / lanes_at(&scales_[k]);
    worst = size > worst ? size : worst;
    put_lanes(&right_side_[k], -miss / h);
  }
  real all = worst[0];
  for (int lane = 1; lane < lanes; ++lane) all = std::max(all, worst[lane]);
  return all;
}

/// Puts into the right side by how much each row would miss its goal after drifting for `h`, and goes on with `aim`.
real JointGroup::predict(const JointedBodies& scene, real h) {
  for (std::size_t i = 0; i < seen_.size(); ++i) ahead_[i] = scene.motions[seen_[i]];
  drift(ahead_, h);
  std::size_t k = 0;
  for (std::size_t i = 0; i < links_.size(); ++i) {
    const Link& link = links_[i];
    look_ahead(link, scene, ahead_places_[i]);
    const std::size_t end = k + static_cast<std::size_t>(links_on_[i]);
    if (link.pin) {
      const Row* rows = rows_.data() + link.first_row;
      right_side_[k] = ahead_places_[i].gap.x - rows[0].goal;
      right_side_[k + 1] = ahead_places_[i].gap.y - rows[1].goal;
      scales_[k] = rows[0].scale;
      scales_[k + 1] = rows[1].scale;
      k += 2;
    }
    for (; k < end; ++k) {
      right_side_[k] = miss_of(on_row(k), scene, h);
      scales_[k] = on_row(k).scale;
    }
  }
  return aim(h);
}

/// Newton's method with the directions at the start of the substep. False where it does not arrive.
bool JointGroup::iterate(const JointedBodies& scene, real h) {
  real miss = predict(scene, h);
  for (int step = 0; step < max_newton_steps && miss > row_tolerance; ++step) {
    matrix_.solve(right_side_);
    count_row_updates(on_.size());
    for (std::size_t k = 0; k < on_.size(); ++k) {
      memory(on_row(k), scene).impulse += right_side_[k];
      apply(on_row(k), right_side_[k], scene);
    }
    const real next = predict(scene, h);
    if (!(next < miss)) break;
    miss = next;
  }
  return miss <= good_enough;
}

bool JointGroup::solve_positions(const JointedBodies& scene, real h) {
  const bool moved = set_goals(scene, h) && close_by_moving(scene, h);
  stale_ |= strained_;
  strained_ = false;
  prepare(scene, false);
  bool arrived = iterate(scene, h);
  for (int round = 1; one_sided_ > 0 && round < most_rounds(one_sided_); ++round) {
    if (!settle_positions(scene, h, round > rounds_together)) break;
    assemble(scene.motions);
    arrived = iterate(scene, h);
  }
  if (!arrived && !arrive_evenly(scene, h)) close_gently(scene, h);
  if (driven_ > 0) book_begun(scene);
  for (const int r : bounded_) {
    Row& row = rows_[static_cast<std::size_t>(r)];
    row.touched = row.plan.bound == Bound::at_least && memory(row, scene).engaged;
  }
  return moved;
}

/// Rows of very unequal masses look as if they followed from each other (a disc of 10 cm between two of 2 m: the rails
/// that keep their angles differ by one part in 80000), and the give that redundant rows get keeps Newton's method from
/// arriving. Before joints are given up they get next to no give, if that tells the rows apart.
bool JointGroup::arrive_evenly(const JointedBodies& scene, real h) {
  const bool tried = uneven_;
  uneven_ = !tried && redundant_ && sizeof(real) == sizeof(double);
  if (!tried && !uneven_) return false;
  assemble(scene.motions);
  if (!uneven_) return false;
  uneven_ = iterate(scene, h);
  if (!uneven_) assemble(scene.motions);
  return uneven_;
}

/// One-sided rows that pull let go, those that would be overrun hold. False when none had to change.
bool JointGroup::settle_positions(const JointedBodies& scene, real h, bool one_at_a_time) {
  bool changed = false;
  for (const int r : bounded_) {
    Row& row = rows_[static_cast<std::size_t>(r)];
    if (row.plan.bound != Bound::at_least || (changed && one_at_a_time)) continue;
    RowMemory& kept = memory(row, scene);
    if (row.on ? kept.impulse >= 0 : miss_of(row, scene, h) >= -row_tolerance * row.scale) continue;
    if (row.on) apply(row, -kept.impulse, scene);
    kept.impulse = 0;
    row.begun = 0;
    switch_row(row, !row.on);
    kept.engaged = row.on;
    changed = true;
  }
  return changed;
}

bool JointGroup::has_mover(const JointedBodies& scene) const {
  const auto moves = [&](BodyIndex i) {
    const Motion& m = scene.motions[i];
    return scene.bodies[i].type == BodyType::kinematic && (!(m.velocity == Vec2{}) || m.spin != 0);
  };
  return std::any_of(rows_.begin(), rows_.end(), [&](const Row& row) {
    const Term* terms = row.terms.terms;
    return std::any_of(terms, terms + row.terms.count,
                       [&](const Term& t) { return moves(t.body_a) || moves(t.body_b); });
  });
}

/// Where joints contradict each other (a chain pulled straight between two walls) no impulses lead to a solution, and
/// looking for one would only throw the bodies about: then the joints are closed at a bounded speed instead.
void JointGroup::close_gently(const JointedBodies& scene, real h) {
  for (Row& row : rows_) {
    if (row.plan.bound == Bound::driven) continue;
    real& impulse = memory(row, scene).impulse;
    apply(row, -impulse, scene);
    impulse = 0;
    row.begun = 0;
  }
  strained_ = has_mover(scene);
  if (strained_) assemble(scene.motions);
  do {
    for (std::size_t k = 0; k < on_.size(); ++k) {
      const Row& row = on_row(k);
      const real most = closing_rate * scene.joints[row.joint].size;
      const real closing = std::clamp(real(0.1) * row.value / h, -most, most);
      right_side_[k] = -speed_of(row.terms, scene.motions) - closing;
    }
    matrix_.solve(right_side_);
    count_row_updates(on_.size());
  } while (drop_pulling_rows(scene));
  for (std::size_t k = 0; k < on_.size(); ++k) apply(on_row(k), right_side_[k], scene);
}

/// Rows leave and none comes back, so that this ends.
bool JointGroup::drop_pulling_rows(const JointedBodies& scene) {
  bool changed = false;
  for (std::size_t k = 0; k < on_.size(); ++k) {
    Row& row = on_row(k);
    if (row.plan.bound != Bound::at_least || right_side_[k] >= 0) continue;
    switch_row(row, false);
    memory(row, scene).engaged = false;
    changed = true;
  }
  if (changed) assemble(scene.motions);
  return changed;
}

}  // namespace PROOFREEL_PRECISION
}  // namespace proofreel
