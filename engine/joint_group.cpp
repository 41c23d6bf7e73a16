#include "engine/joint_group.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "engine/joint_pins.h"
#include "engine/joints/kinds.h"
#include "engine/lanes.h"

namespace proofreel {
inline namespace PROOFREEL_PRECISION {
namespace {

/// Of angles and one radian.
constexpr real angle_scale = real(0.125);

}  // namespace

JointGroup::JointGroup(const std::vector<std::uint32_t>& ids, const std::vector<Joint>& joints,
                       const std::vector<Motion>& motions, RowsWanted wanted) {
  for (const std::uint32_t i : ids) {
    seen_.push_back(joints[i].body_a);
    seen_.push_back(joints[i].body_b);
  }
  std::sort(seen_.begin(), seen_.end());
  seen_.erase(std::unique(seen_.begin(), seen_.end()), seen_.end());
  ahead_.resize(in_whole_lanes(seen_.size()));
  for (const std::uint32_t i : ids) add_link(i, joints, wanted);
  ahead_places_.resize(links_.size());
  couple(motions);
}

void JointGroup::add_link(std::uint32_t id, const std::vector<Joint>& joints, RowsWanted wanted) {
  const std::vector<RowPlan> plans = plan_rows(joints[id], wanted);
  if (plans.empty()) return;
  const auto place = [this](BodyIndex body) {
    return static_cast<int>(std::lower_bound(seen_.begin(), seen_.end(), body) - seen_.begin());
  };
  Link& link = links_.emplace_back();
  link.joint = id;
  link.first_row = static_cast<int>(rows_.size());
  link.row_count = static_cast<int>(plans.size());
  link.body_a = joints[id].body_a;
  link.body_b = joints[id].body_b;
  link.place_a = place(link.body_a);
  link.place_b = place(link.body_b);
  link.plain = !has_axis_or_ropes(joints[id]);
  link.pin = plans.size() >= 2 && JointPins::is_pin(plans[0], plans[1]) && link.body_a != link.body_b;
  for (std::size_t slot = 0; slot < plans.size(); ++slot) {
    const RowPlan& plan = plans[slot];
    if (plan.bound != Bound::equal) bounded_.push_back(static_cast<int>(rows_.size()));
    equal_ += plan.bound == Bound::equal;
    one_sided_ += plan.bound == Bound::at_least;
    driven_ += plan.bound == Bound::driven;
    Row& row = rows_.emplace_back();
    row.joint = id;
    row.slot = static_cast<std::uint32_t>(slot);
    row.link = static_cast<std::uint32_t>(links_.size() - 1);
    row.plan = plan;
    row.terms = bodies_of(joints[id], joints);
  }
}

/// Not in turns where a motor drives: what jams it would wind contacts and pins up against each other.
void JointGroup::begin_tick(const JointedBodies& scene, std::span<const std::uint8_t> overlapping) {
  in_turns_ = driven_ == 0 && !overlapping.empty() &&
              std::any_of(bodies_.begin(), bodies_.end(), [overlapping](BodyIndex i) { return overlapping[i] != 0; });
  for (Link& link : links_) link.anchors = anchors_of(scene.joints[link.joint], scene.bodies);
}

/// Pins and stops, most of all rows, once they have been linearized: what only turns always does so in the same
/// direction; the directions of pins stay, but their arms turn. False for all others, for which nothing is done.
inline bool JointGroup::follow(Row& row, const JointPlace& place, const Motion& a, const Motion& b) {
  Term& term = row.terms.terms[0];
  const Coordinate coordinate = row.plan.coordinate;
  const bool known = term.arm_a != 0;
  if (!known || row.plan.bound == Bound::driven) return false;
  if (coordinate == Coordinate::turn) {
    row.value = row.plan.sign * (place.turn - row.plan.offset);
    row.scale = angle_scale * (1 + std::abs(a.angle) + std::abs(b.angle));  // as in scale_of: both arms are 1 or -1
    return true;
  }
  if (coordinate != Coordinate::anchor_x && coordinate != Coordinate::anchor_y) return false;
  row.value = row.plan.sign * ((coordinate == Coordinate::anchor_x ? place.gap.x : place.gap.y) - row.plan.offset);
  const real arm_a = cross(place.arm_a, term.direction);
  const real arm_b = cross(place.arm_b, term.direction);
  stale_ |= (arm_a != term.arm_a) | (arm_b != term.arm_b);
  term.arm_a = arm_a;
  term.arm_b = arm_b;
  return true;
}

/// What only turns always does so in the same direction.
inline void JointGroup::direct(Row& row, const Joint& joint, const JointPlace& place, const JointedBodies& scene) {
  const bool known = row.terms.terms[0].arm_a != 0;
  if (row.plan.coordinate == Coordinate::turn && known) return;
  const Terms terms = terms_of(row.plan, joint, place, scene);
  stale_ |= terms != row.terms;
  row.terms = terms;
}

/// Metres are measured by the joint's size and the way to its stop; angles by themselves, for the last digits of many
/// turns are lost.
inline real JointGroup::scale_of(const Row& row, const JointedBodies& scene) const {
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
  return angle_scale * angles;
}

inline void JointGroup::linearize_row(Row& row, const Joint& joint, const JointPlace& place,
                                      const JointedBodies& scene) {
  const bool driven = row.plan.bound == Bound::driven;
  const real before = driven ? speed_of(row.terms, scene.motions) : 0;
  row.value = value_of(row.plan, joint, place, scene, 0);
  direct(row, joint, place, scene);
  if (driven) row.drifted = real(0.5) * (before + speed_of(row.terms, scene.motions));
  row.scale = scale_of(row, scene);
}

void JointGroup::linearize(const JointedBodies& scene) {
  stale_ |= masses_changed(scene.motions);
  for (const Link& link : links_) {
    const Motion& a = scene.motions[link.body_a];
    const Motion& b = scene.motions[link.body_b];
    const JointPlace place = place_on(link, scene, a, b);
    for (Row& row : rows_of(link)) {
      if (!follow(row, place, a, b)) linearize_row(row, scene.joints[link.joint], place, scene);
    }
  }
}

/// At the end of a substep, before directions change.
void JointGroup::book_reactions(const JointedBodies& scene) {
  for (Row& row : rows_) {
    if (row.given == 0) continue;
    book_reaction(scene.joints[row.joint], row.terms, row.given);
    row.total += std::exchange(row.given, real(0));
  }
}

/// Motors give one half of their impulse before the drift and one half after it, as all forces do: what a motor holds
/// does not creep, and what it accelerates does so to second order.
void JointGroup::begin_substep(const JointedBodies& scene, real h, real share) {
  share_ = share;
  if (driven_ > 0) begin_motors(scene, h, share);
  for (Row& row : rows_) {
    row.pushed = 0;
    if (row.plan.bound != Bound::driven) begin_row(row, scene);
    if (row.plan.bound != Bound::at_least || memory(row, scene).engaged) apply(row, row.begun, scene);
  }
}

/// Forces that redundant joints exert on each other move nothing and would grow from substep to substep.
inline void JointGroup::begin_row(Row& row, const JointedBodies& scene) {
  RowMemory& kept = memory(row, scene);
  const bool holds = row.plan.bound == Bound::equal || kept.engaged;
  if (holds && redundant_ && !uneven_) kept.impulse = 0;
  row.begun = holds ? kept.impulse : 0;
}

void JointGroup::begin_motors(const JointedBodies& scene, real h, real share) {
  for (Row& row : rows_) {
    if (row.plan.bound != Bound::driven) continue;
    const real most = h * strongest(row.plan, scene.joints[row.joint]);
    row.counted = false;
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
  std::vector<real> impulses(on_.size());
  for (std::size_t k = 0; k < on_.size(); ++k) impulses[k] = -speed_of(on_row(k).terms, motions);
  matrix_.solve(impulses);
  for (std::size_t k = 0; k < on_.size(); ++k) push(on_row(k).terms, impulses[k], motions);
}

double JointGroup::take_work(const JointedBodies& scene) {
  for (Row& row : rows_) work_ += work_of_movers(row.terms, std::exchange(row.total, real(0)), scene);
  return std::exchange(work_, 0);
}

}  // namespace PROOFREEL_PRECISION
}  // namespace proofreel
