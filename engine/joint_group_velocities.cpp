// The velocity stage of a group: no joint opens, motors run.

#include <algorithm>
#include <cmath>

#include "engine/joint_group.h"
#include "engine/work.h"

namespace proofreel {
inline namespace PROOFREEL_PRECISION {
namespace {

/// The part of what it has missed that a motor catches up with in one substep, and the most it may have missed, in ways
/// of a substep.
constexpr real catching_up = real(0.2);
constexpr real most_missed = real(0.025);

}  // namespace

void JointGroup::add_share(const JointedBodies& scene) {
  if (in_turns_) {
    for (Row& row : rows_) {
      if (row.begun == 0) continue;  // most stops
      apply(row, row.begun, scene);
      row.pushed += row.begun;
    }
  }
  if (driven_ == 0) return;
  for (Row& row : rows_) {
    if (row.plan.bound != Bound::driven) continue;
    const real before = speed_of(row.terms, scene.motions);
    apply(row, row.begun, scene);
    row.pushed += row.begun;
    work_ += static_cast<double>(row.begun * real(0.5) * (before + speed_of(row.terms, scene.motions)));
  }
}

/// Contacts start the next substep from what they gave in the whole of this one, without what drove overlap out before
/// the drift and was taken back after it. Started from what they gave before the drift, joints would still answer to
/// that push, and the contacts' only sweep would spend itself on bearing their answer.
void JointGroup::end_substep(const JointedBodies& scene) {
  if (!in_turns_) return;
  for (Row& row : rows_) {
    if (row.plan.bound == Bound::driven) continue;
    real& impulse = memory(row, scene).impulse;
    impulse = share_ * (impulse + row.pushed);
  }
}

void JointGroup::solve_velocities(const JointedBodies& scene, real h) {
  prepare(scene, true);
  if (bounded_.empty()) {
    find_corrections(scene);
    apply_corrections(scene);
  } else {
    solve_bounded_velocities(scene, h);
  }
  book_reactions(scene);
}

/// Impulses that would leave their bounds are not tried out on the bodies: where a motor works against a stop they
/// would be enormous, and would cost the others their last digits.
void JointGroup::solve_bounded_velocities(const JointedBodies& scene, real h) {
  if (driven_ > 0) note_speeds(scene, h);
  for (int round = 1; round < most_rounds(one_sided_ + driven_); ++round) {
    const bool one_at_a_time = round > rounds_together;
    find_corrections(scene);
    if (!bound_corrections(scene, h, one_at_a_time)) {
      apply_corrections(scene);
      if (static_cast<int>(on_.size()) > equal_) {  // what the compliance of the first time has left
        find_corrections(scene);
        apply_corrections(scene);
      }
      if (!engage_overrun_rows(scene, h, one_at_a_time)) break;
    }
    assemble(scene.motions);
  }
  if (driven_ > 0) book_motors(scene);
}

void JointGroup::note_speeds(const JointedBodies& scene, real h) {
  for (const int r : bounded_) {
    Row& row = rows_[static_cast<std::size_t>(r)];
    if (row.plan.bound == Bound::driven) ask_speed(row, scene, h);
    row.speed_before = speed_of(row.terms, scene.motions);
    row.pushed_before = row.pushed;
  }
}

/// Before a drift a motor gives half of what it gave in the substep before: where its load changes it is a little off
/// its speed during the drift, and what adds up of that over many turns is of first order only. So it catches up. Not
/// with what it could not follow because it gave all it has, and no more than a little of its speed: against what does
/// not give way a motor must not wind itself up.
void JointGroup::ask_speed(Row& row, const JointedBodies& scene, real h) {
  const real speed = wanted_speed(row.plan, scene.joints[row.joint]);
  RowMemory& kept = memory(row, scene);
  if (!row.counted && kept.engaged) {
    const real most = most_missed * std::abs(h * speed);
    kept.missed = std::clamp(kept.missed + h * (speed - row.drifted), -most, most);
  }
  row.counted = true;
  row.asked = speed + catching_up * kept.missed / h;
}

/// Impulses on a linear system do work by the mean of the speeds before and after, whatever comes between.
void JointGroup::book_motors(const JointedBodies& scene) {
  for (const int r : bounded_) {
    const Row& row = rows_[static_cast<std::size_t>(r)];
    if (row.plan.bound != Bound::driven) continue;
    RowMemory& kept = memory(row, scene);
    kept.impulse = row.begun + row.pushed;
    kept.engaged = row.on;
    if (!row.on) kept.missed = 0;
    const real speed = real(0.5) * (row.speed_before + speed_of(row.terms, scene.motions));
    work_ += static_cast<double>((row.pushed - row.pushed_before) * speed);
  }
}

/// What every row would have to give to stand still, or to run at its speed.
void JointGroup::find_corrections(const JointedBodies& scene) {
  for (std::size_t k = 0; k < on_.size(); ++k) {
    const Row& row = on_row(k);
    right_side_[k] = row.asked - speed_of(row.terms, scene.motions);
  }
  matrix_.solve(right_side_);
  count_row_updates(on_.size());
}

void JointGroup::apply_corrections(const JointedBodies& scene) {
  for (std::size_t k = 0; k < on_.size(); ++k) {
    on_row(k).pushed += right_side_[k];
    apply(on_row(k), right_side_[k], scene);
  }
}

/// Rows that would leave their bounds give what they may and are out of the system: a motor all it has, a stop nothing
/// over the whole substep. (A stop may take back what it gave before the drift: that was there to reach a position, not
/// to throw anything off.) False when there was none.
bool JointGroup::bound_corrections(const JointedBodies& scene, real h, bool one_at_a_time) {
  bool changed = false;
  for (std::size_t k = 0; k < on_.size(); ++k) {
    Row& row = on_row(k);
    if (row.plan.bound == Bound::equal || (changed && one_at_a_time)) continue;
    RowMemory& kept = memory(row, scene);
    const bool driven = row.plan.bound == Bound::driven;
    const real most = driven ? h * strongest(row.plan, scene.joints[row.joint]) : 0;
    const real given = row.pushed + (driven ? row.begun : kept.impulse);
    const real wanted = given + right_side_[k];
    const real allowed = driven ? std::clamp(wanted, -most, most) : std::max(wanted, real(0));
    if (wanted == allowed) continue;
    apply(row, allowed - given, scene);
    row.pushed += allowed - given;
    row.at_bound = wanted > 0 ? 1 : -1;
    switch_row(row, false);
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
  for (const int r : bounded_) {
    Row& row = rows_[static_cast<std::size_t>(r)];
    if (row.on || (changed && one_at_a_time)) continue;
    if (row.plan.bound == Bound::at_least && !row.touched) continue;
    const real tolerance = row_tolerance * row.scale / h;
    const real lacking = row.asked - speed_of(row.terms, scene.motions);
    const bool driven = row.plan.bound == Bound::driven;
    if (driven ? static_cast<real>(row.at_bound) * lacking >= -tolerance : lacking <= tolerance) continue;
    switch_row(row, true);
    changed = true;
    if (!driven) memory(row, scene).engaged = true;
  }
  return changed;
}

}  // namespace PROOFREEL_PRECISION
}  // namespace proofreel
