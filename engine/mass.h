#pragma once

/// Mass, centre and moment of inertia of the shapes we have (thesis chapters 3.2 and 3.3). Always in double: computed
/// once per body, used by every precision.

#include <span>

#include "engine/scene.h"
#include "engine/vec2.h"

namespace proofreel {

struct MassProperties {
  double mass = 0;     ///< kg
  Vec2d center;        ///< of mass, in the coordinates the shapes are written in
  double inertia = 0;  ///< kg m^2 about `center`
};

/// Of one shape. A rounded hull is cut into its core polygon, a rectangle along every edge and a circular sector at
/// every corner, whose parts add up exactly by the parallel-axis theorem (thesis equation 3.16). A disc is the sector
/// that goes all the way round, a capsule two rectangles and two half discs. A bare segment has no area and no mass.
MassProperties mass_of(const ShapeDef& shape);

/// Of several together.
MassProperties combined(std::span<const MassProperties> parts);

/// Of a whole body, with the mass and inertia its definition asks for. `mass` without `inertia` scales the inertia.
/// Only dynamic bodies have mass. The others have their centre at the origin: a kinematic body turns about the point it
/// is placed by.
MassProperties mass_of(const BodyDef& body);

}  // namespace proofreel
