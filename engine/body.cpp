#include "engine/body.h"

#include <cmath>

namespace proofreel {
inline namespace PROOFREEL_PRECISION {

Rot turned(Rot q, real angle) {
  // Taylor to the 11th power: below 1/4 rad the rest is under 1e-18.
  if (std::abs(angle) < real(0.25)) {
    const real a2 = angle * angle;
    const real s = angle * (1 - a2 / 6 * (1 - a2 / 20 * (1 - a2 / 42 * (1 - a2 / 72 * (1 - a2 / 110)))));
    const real c = 1 - a2 / 2 * (1 - a2 / 12 * (1 - a2 / 30 * (1 - a2 / 56 * (1 - a2 / 90 * (1 - a2 / 132)))));
    return normalized(Rot{c, s} * q);
  }
  return normalized(Rot(angle) * q);
}

}  // namespace PROOFREEL_PRECISION
}  // namespace proofreel
