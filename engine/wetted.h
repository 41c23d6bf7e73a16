#pragma once

/// The part of a shape that lies below a water line, exactly: its area, where its centre lies, and how it resists
/// turning. Discs, capsules and rounded polygons are as exact as sharp ones.

#include "engine/shape.h"

namespace proofreel {
inline namespace PROOFREEL_PRECISION {

/// Moments of an area about a body's centre of mass, in world axes. Those of several shapes add up. In double in every
/// precision.
struct Wetted {
  double area = 0;    ///< m^2
  Vec2d first;        ///< m^3: area times the way from the centre of mass to the area's centroid
  double second = 0;  ///< m^4: polar, of x^2 + y^2

  Wetted& operator+=(const Wetted& other);
};

/// The part of the hull below a line `level` metres above the body's centre of mass (below it, when negative).
///
/// By Green's theorem the moments of a region are integrals along its rim, area = -(integral of y dx) and so on. With y
/// measured from the water line, the piece of the rim that lies in the water line adds nothing to any of them. So it
/// is enough to walk along the rim of the shape, edge by edge and arc by arc, and to add up what is under water; the
/// cut itself never has to be made. A shape deep under water is measured from its own top, so that depth costs no
/// digits.
Wetted wetted_part(const Hull& hull, Rot rotation, double level);

}  // namespace PROOFREEL_PRECISION
}  // namespace proofreel
