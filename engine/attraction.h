#pragma once

/// Forces that pull bodies towards points or towards each other, as gravity does between stars. They act on centres of
/// mass and depend on positions only, so energy is conserved as well as the integrator can.

#include <vector>

#include "engine/body.h"

namespace proofreel {
inline namespace PROOFREEL_PRECISION {

/// Pulls every dynamic body towards one point for `h` seconds: with m * strength / r^2, or with m * strength * r. Where
/// the point is a body, that body feels all of it in return (Newton's third law) and is itself not pulled: the impulse
/// all others have got, N s, is returned. At distance zero there is no direction and no force.
Vec2 kick_towards(const AttractorDef& attractor, const std::vector<Body>& bodies, std::vector<Motion>& motions, real h);

/// The potential energy, J: -m strength / r per body, zero far away; or m strength r^2 / 2, zero at the point.
double potential_of(const AttractorDef& attractor, const std::vector<Body>& bodies, const std::vector<Motion>& motions);

/// Newton's law of gravitation between every two dynamic bodies, G m1 m2 / r^2, for `h` seconds. All pairs: O(n^2).
void kick_towards_each_other(double gravitational_constant, const std::vector<Body>& bodies,
                             std::vector<Motion>& motions, real h);

/// -G m1 m2 / r, summed over all pairs, J.
double mutual_potential(double gravitational_constant, const std::vector<Body>& bodies,
                        const std::vector<Motion>& motions);

}  // namespace PROOFREEL_PRECISION
}  // namespace proofreel
