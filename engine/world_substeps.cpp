// How many substeps a tick has: as many as the method says, and more where joints swing too fast for them.

#include <algorithm>

#include "engine/world.h"

namespace proofreel {
inline namespace PROOFREEL_PRECISION {
namespace {

/// Radians per substep that the fastest swing of a joint may take. It is followed up to 2; the load may quadruple from
/// one tick to the next.
constexpr real longest_swing = real(1.5);
/// No more than so many times what the method says: joints that contradict each other pull without end.
constexpr int most_times = 16;

/// What a substep gave is where the next one starts from: of another length, it gives in proportion.
void scale_impulses(std::vector<Contact>& contacts, real ratio) {
  for (Contact& contact : contacts) {
    for (PointImpulse& impulse : contact.impulses) {
      impulse.normal *= ratio;
      impulse.tangent *= ratio;
    }
    contact.rolling_impulse *= ratio;
  }
}

}  // namespace

/// Always by halving, so that loads that change a little change nothing.
void World::choose_substeps() {
  int substeps = method_.substeps;
  if (has_rigid_joints()) {
    const real swing = joint_solver_.fastest_swing(jointed(), dt_);
    const int most = most_times * method_.substeps;
    while (swing * dt_ > longest_swing * static_cast<real>(substeps) && substeps < most) substeps *= 2;
  }
  if (substeps == substeps_) return;
  const real ratio = static_cast<real>(substeps_) / static_cast<real>(substeps);
  substeps_ = substeps;
  most_substeps_ = std::max(most_substeps_, substeps);
  h_ = dt_ / static_cast<real>(substeps);
  for (Joint& joint : joints_) {
    for (RowMemory& memory : joint.memory) memory.impulse *= ratio;
  }
  scale_impulses(contacts_, ratio);
  scale_impulses(sleep_.contacts, ratio);
}

}  // namespace PROOFREEL_PRECISION
}  // namespace proofreel
