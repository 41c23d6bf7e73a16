// The velocity stage of a group: no joint opens, motors run.

#include <algorithm>
#include <cmath>

#include "engine/joint_group.h"

namespace proofreel {
inline namespace PROOFREEL_PRECISION {

void JointGroup::add_share(const JointedBodies& scene) {
  if (driven_ == 0) return;
  for (Row& row : rows_) {
    if (row.plan.bound != Bound::driven) continue;
    const real before = speed_of(row.terms, scene.motions);
    apply(row, row.begun, scene);
    row.pushed += row.begun;
    work_ += static_cast<double>(row.begun * real(0.5) * (before + speed_of(row.terms, scene.motions)));
  }
}

void JointGroup::solve_velocities(const JointedBodies& scene, real h) {
  prepare(scene, true);
  if (one_sided_ + driven_ > 0) return solve_bounded_velocities(scene, h);
  for (std::size_t r = 0; r < rows_.size(); ++r) right_side_[r] = -speed_of(rows_[r].terms, scene.motions);
  matrix_.solve(right_side_);
  for (std::size_t r = 0; r < rows_.size(); ++r) apply(rows_[r], right_side_[r], scene);
}

/// Impulses that would leave their bounds are not tried out on the bodies: where a motor works against a stop they
/// would be enormous, and would cost the others their last digits.
void JointGroup::solve_bounded_velocities(const JointedBodies& scene, real h) {
  for (Row& row : rows_) {
    row.speed_before = speed_of(row.terms, scene.motions);
    row.pushed_before = row.pushed;
  }
  for (int round = 1; round < most_rounds(one_sided_ + driven_); ++round) {
    const bool one_at_a_time = round > rounds_together;
    find_corrections(scene);
    if (!bound_corrections(scene, h, one_at_a_time)) {
      apply_corrections(scene);
      if (any_bounded_row_on()) {  // what the compliance of the first time has left
        find_corrections(scene);
        apply_corrections(scene);
      }
      if (!engage_overrun_rows(scene, h, one_at_a_time)) break;
    }
    assemble(scene.motions);
  }
  for (const Row& row : rows_) {
    if (row.plan.bound != Bound::driven) continue;
    memory(row, scene).impulse = row.begun + row.pushed;
    // Impulses on a linear system do work by the mean of the speeds before and after, whatever comes between.
    const real speed = real(0.5) * (row.speed_before + speed_of(row.terms, scene.motions));
    work_ += static_cast<double>((row.pushed - row.pushed_before) * speed);
  }
}

bool JointGroup::any_bounded_row_on() const {
  return std::any_of(rows_.begin(), rows_.end(), [](const Row& r) { return r.on && r.plan.bound != Bound::equal; });
}

/// What every row would have to give to stand still, or to run at its speed.
void JointGroup::find_corrections(const JointedBodies& scene) {
  for (std::size_t r = 0; r < rows_.size(); ++r) {
    const Row& row = rows_[r];
    right_side_[r] = row.on ? wanted_speed(row.plan, scene.joints[row.joint]) - speed_of(row.terms, scene.motions) : 0;
  }
  matrix_.solve(right_side_);
}

void JointGroup::apply_corrections(const JointedBodies& scene) {
  for (std::size_t r = 0; r < rows_.size(); ++r) {
    if (!rows_[r].on) continue;
    rows_[r].pushed += right_side_[r];
    apply(rows_[r], right_side_[r], scene);
  }
}

/// Rows that would leave their bounds give what they may and are out of the system: a motor all it has, a stop nothing
/// over the whole substep. (A stop may take back what it gave before the drift: that was there to reach a position, not
/// to throw anything off.) False when there was none.
bool JointGroup::bound_corrections(const JointedBodies& scene, real h, bool one_at_a_time) {
  bool changed = false;
  for (std::size_t r = 0; r < rows_.size(); ++r) {
    Row& row = rows_[r];
    if (!row.on || row.plan.bound == Bound::equal || (changed && one_at_a_time)) continue;
    RowMemory& kept = memory(row, scene);
    const bool driven = row.plan.bound == Bound::driven;
    const real most = driven ? h * strongest(row.plan, scene.joints[row.joint]) : 0;
    const real given = row.pushed + (driven ? row.begun : kept.impulse);
    const real wanted = given + right_side_[r];
    const real allowed = driven ? std::clamp(wanted, -most, most) : std::max(wanted, real(0));
    if (wanted == allowed) continue;
    apply(row, allowed - given, scene);
    row.pushed += allowed - given;
    row.at_bound = wanted > 0 ? 1 : -1;
    row.on = false;
    changed = true;
    if (driven) continue;
    row.pushed += kept.impulse;
    kept = {};
  }
  return changed;
}

/// Stops that are being overrun hold, motors that run ahead of their speed brake. False when there was none.
bool JointGroup::engage_overrun_rows(const JointedBodies& scene, real h, bool one_at_a_time) {
  bool changed = false;
  for (Row& row : rows_) {
    if (row.on || row.plan.bound == Bound::equal || (changed && one_at_a_time)) continue;
    const real tolerance = row_tolerance * row.scale / h;
    const real lacking = wanted_speed(row.plan, scene.joints[row.joint]) - speed_of(row.terms, scene.motions);
    const bool driven = row.plan.bound == Bound::driven;
    if (driven ? static_cast<real>(row.at_bound) * lacking >= -tolerance : !row.touched || lacking <= tolerance)
      continue;
    row.on = changed = true;
    if (!driven) memory(row, scene).engaged = true;
  }
  return changed;
}

}  // namespace PROOFREEL_PRECISION
}  // namespace proofreel
