#pragma once

/// Bodies that take no notice of each other: no contacts, no joints, only forces that act on each of them by itself.
/// Then a tick needs no stages, one after the other over all bodies: each body goes through all its substeps at once,
/// in registers, by a loop made for just the forces that are on. The numbers are those of the stages, bit by bit.

#include <span>
#include <vector>

#include "engine/body.h"

namespace proofreel {
inline namespace PROOFREEL_PRECISION {

/// What acts, one entry per body; an empty span is a force that is off.
struct FreeForces {
  std::span<const Vec2> accelerations;  ///< m/s^2, constant
  std::span<const DragDef> drags;
  Vec2 wind;  ///< m/s, of the medium that drags
};

/// One tick of `substeps` times `h` seconds, by verlet (halves of every force around the drift) or by symplectic Euler.
/// Moves centres, too: nothing is left in `Motion::delta`.
void fly(const FreeForces& forces, Integrator integrator, int substeps, real h, std::vector<Body>& bodies,
         std::vector<Motion>& motions);

}  // namespace PROOFREEL_PRECISION
}  // namespace proofreel
