#pragma once

#include <vector>

#include "engine/body.h"

namespace proofreel {
inline namespace PROOFREEL_PRECISION {

struct HandSteps {
  int ticks = 0;
  int substeps = 0;
  real h = 0;  ///< s, of a substep
};

/// Bodies under constant accelerations, stepped by verlet in a loop that somebody wrote for just this: what the
/// engine's step is measured against. On the engine's own numbers.
void measured_steps_by_hand(std::vector<Body>& bodies, std::vector<Motion>& motions,
                            const std::vector<Vec2>& accelerations, const HandSteps& steps);

}  // namespace PROOFREEL_PRECISION
}  // namespace proofreel
