#pragma once

/// Impacts with restitution (Newton's law: they part at e times the speed they met at), pair by pair until nothing
/// approaches, so that a row of equal elastic balls passes the momentum on to the last one.
///
/// An impact happens at its own time within the substep, t seconds after the start. The impulse dv is found from the
/// velocities at that time, gravity included, and the body is set back by dv * t: flying on with the new velocity from
/// there it arrives where the located impact would have taken it. A ball on a floor keeps its energy exactly.

#include <span>

#include "engine/contact_solver.h"

namespace proofreel {
inline namespace PROOFREEL_PRECISION {

/// Resolves all impacts of the next `h` seconds among contacts with restitution. `accelerations` of the bodies, none
/// where nothing accelerates. Bodies that approach slower than
/// `resting_speed` (m/s) do not bounce: the contact solver brings them to rest. To be called before the first kick.
/// `surface_speeds` as the contact solver tells them.
void resolve_impacts(std::vector<ContactConstraint>& constraints, std::span<const Vec2> accelerations,
                     std::vector<Motion>& motions, real h, real resting_speed, bool friction,
                     std::span<const real> surface_speeds);

}  // namespace PROOFREEL_PRECISION
}  // namespace proofreel
