#pragma once

/// Convex shapes as the collision stages see them (thesis chapter 3.3): the hull of a few points, rounded by a radius.
/// One point is a disc, two a capsule, three and more a polygon; so every pair of shapes needs the same few tests.

#include "engine/real.h"
#include "engine/scene.h"

namespace proofreel {
inline namespace PROOFREEL_PRECISION {

/// Coordinates are relative to the body's centre of mass, in the body's axes. The places behind the last corner are
/// filled with the first one, so that loops may run over whole blocks; `make_hull` sees to it.
struct Hull {
  Vec2 points[max_polygon_vertices];   ///< counter-clockwise
  Vec2 normals[max_polygon_vertices];  ///< unit, outward; normals[i] belongs to the edge from points[i] to the next
  int count = 0;
  real radius = 0;
  real thickness = 0;  ///< the width across the thinnest direction, rounding included; 0 for a bare segment
  real detail = 0;     ///< what contact tolerances are measured by: the thickness, of a bare segment 1 % of its length
};

/// `center` is the body's centre of mass in the coordinates `def` is written in.
Hull make_hull(const ShapeDef& def, Vec2d center);

/// The same hull at a pose: in the frame the pose is told in.
Hull transformed(const Hull& hull, const Pose& pose);

/// The smallest box around the hull at a pose.
Aabb bounds(const Hull& hull, const Pose& pose);

/// The distance from the centre of mass to the farthest point.
real reach(const Hull& hull);

}  // namespace PROOFREEL_PRECISION
}  // namespace proofreel
