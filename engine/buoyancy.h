#pragma once

/// Water that fills everything below a height, and what it does to bodies in it. It is thought at rest and so large
/// that nothing raises its level. It acts on every dynamic body, sensors too. Only shapes displace water, whatever
/// they weigh; shapes of one body that overlap count twice, as they do for its mass.

#include <vector>

#include "engine/body.h"
#include "engine/broad_phase.h"
#include "engine/smooth_motion.h"
#include "engine/wetted.h"

namespace proofreel {
inline namespace PROOFREEL_PRECISION {

/// What of a body is under water.
Wetted wetted_part(const WaterDef& water, const Body& body, const Motion& motion, const std::vector<Shape>& shapes);

/// Archimedes: the water carries what the displaced water would weigh, density * area * gravity, straight up, through
/// the centroid of the wetted part. That force depends on where the body is, and on nothing else, so it keeps energy
/// (see `water_potential`). `gravity` is the scene's, m/s^2 downwards; a body's gravity_scale changes what the body
/// weighs and not what the water does, so a body of gravity_scale 0.5 floats as if it were half as heavy.
void lift(Motion& motion, const WaterDef& water, const Wetted& wetted, double gravity, real h);

/// What it took to push the water away: density * gravity * the integral of the depth over the wetted part, J. Zero
/// above water.
double water_potential(const WaterDef& water, const Wetted& wetted, double depth_of_center, double gravity);

/// The resistance of the water for `h` seconds: every wetted square metre feels -drag times the velocity it has itself
/// (Rayleigh's linear damping, spread over the area). Together that is a force -drag * area * (velocity of the wetted
/// centroid) through the centroid, and a torque -drag * (polar second moment about the centroid) * spin. Both act at
/// once, and the solution is exact for a body that stays where it is meanwhile, so no drag however large turns anything
/// round, and none adds energy.
void resist(Motion& motion, const WaterDef& water, const Wetted& wetted, real h);

/// Adds what that resistance decelerates a body by now, for integrators that take it as one force among others.
void add_resistance(const Motion& motion, const WaterDef& water, const Wetted& wetted, Slope& slope);

}  // namespace PROOFREEL_PRECISION
}  // namespace proofreel
