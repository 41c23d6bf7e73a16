#pragma once

/// Narrow phase (thesis chapter 4.2): where and how do two shapes touch?

#include <cstdint>

#include "engine/shape.h"

namespace proofreel {
inline namespace PROOFREEL_PRECISION {

/// One point of a manifold. It stays the same one as long as the same features touch, which `feature` names.
struct ManifoldPoint {
  Vec2 point;           ///< midway between the surfaces, relative to A's centre of mass, in world axes
  real separation = 0;  ///< negative on overlap
  std::uint32_t feature = 0;
};

/// All that two convex shapes touch in: one normal and one or two points.
struct Manifold {
  Vec2 normal;  ///< unit, from A to B, world axes
  ManifoldPoint points[2];
  int count = 0;
};

/// The least separation of all points; the largest number there is for a manifold without points.
real deepest(const Manifold& m);

/// Points farther apart than `margin` are left out. The poses are those of the centres of mass. All is computed in A's
/// frame, so that nothing is lost far from the origin.
Manifold collide(const Hull& a, const Pose& pose_a, const Hull& b, const Pose& pose_b, real margin);

}  // namespace PROOFREEL_PRECISION
}  // namespace proofreel
