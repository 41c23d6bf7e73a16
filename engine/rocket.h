#pragma once

/// A rocket: a body whose mass falls while it burns. What leaves it carries its own momentum away, so the equation is
/// m dv/dt = thrust, not d(m v)/dt = thrust (thesis 3.11 has the latter, which holds only for a constant mass).

#include "engine/body.h"

namespace proofreel {
inline namespace PROOFREEL_PRECISION {

struct Rocket {
  BodyIndex body = 0;
  double thrust = 0;     ///< N along the body's +y
  double burn_rate = 0;  ///< kg/s
  double fuel = 0;       ///< kg left
  Vec2d at;              ///< where it pushes, in the body's axes from its centre of mass
};

/// Burns for `h` seconds, or until the fuel is gone. With the mass falling evenly from m0 to m1 the gain in speed is
/// thrust / burn_rate * ln(m0 / m1), exactly (Tsiolkovsky 1903), as long as the body does not turn meanwhile. The
/// fuel burns evenly all over the body, so its inertia falls as its mass does and its centre stays. Returns the work
/// done, J: the change of kinetic energy, that of the lost mass included.
double burn(Rocket& rocket, Body& body, Motion& motion, real h);

}  // namespace PROOFREEL_PRECISION
}  // namespace proofreel
