// The stops of a group in the hands of those who solve them together with contacts.

#include "engine/joint_group.h"

namespace proofreel {
inline namespace PROOFREEL_PRECISION {
namespace {

/// In scales of their rows: stops that come no nearer than this have no part in what is solved.
constexpr real reach_of_stops = 1;

}  // namespace

void JointGroup::release_stops(const JointedBodies& scene) {
  for (const int r : bounded_) {
    Row& row = rows_[static_cast<std::size_t>(r)];
    if (row.plan.bound == Bound::at_least) switch_row(row, false);
  }
  if (stale_ || renumber_) assemble(scene.motions);
}

void JointGroup::find_stops(const JointedBodies& scene, real h, std::vector<Stop>& stops) {
  predict(scene, h);
  for (const int r : bounded_) {
    const Row& row = rows_[static_cast<std::size_t>(r)];
    const RowMemory& kept = memory(row, scene);
    if (row.plan.bound != Bound::at_least) continue;
    const real miss = miss_of(row, scene, h);
    if (!kept.engaged && miss > reach_of_stops * row.scale) continue;
    const Term& term = row.terms.terms[0];
    stops.push_back({static_cast<std::size_t>(r), term, miss / h - speed_of(term, scene.motions), kept.impulse});
  }
}

void JointGroup::find_touched_stops(const JointedBodies& scene, std::vector<Stop>& stops) const {
  for (const int r : bounded_) {
    const Row& row = rows_[static_cast<std::size_t>(r)];
    if (!row.touched) continue;
    stops.push_back({static_cast<std::size_t>(r), row.terms.terms[0], 0, memory(row, scene).impulse + row.pushed});
  }
}

/// What does not push lets go, as it does where the group is solved by itself.
void JointGroup::set_stop(const Stop& stop, real impulse, bool after_drift, const JointedBodies& scene) {
  Row& row = rows_[stop.row];
  RowMemory& kept = memory(row, scene);
  row.given += impulse - stop.given;
  kept.engaged = impulse > 0;
  if (!after_drift) {
    kept.impulse = impulse;
  } else if (kept.engaged) {
    row.pushed = impulse - kept.impulse;
  } else {
    row.pushed = 0;
    kept.impulse = 0;
  }
}

}  // namespace PROOFREEL_PRECISION
}  // namespace proofreel
