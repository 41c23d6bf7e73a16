#pragma once

/// Polygons as lists of corners, in double precision: what is done once when a scene is built, not at every tick.
/// Lengths in metres, corners counter-clockwise unless said otherwise.

#include <span>
#include <string>
#include <variant>
#include <vector>

#include "engine/vec2.h"

namespace proofreel {

/// Twice the signed area of the triangle (a, b, c): positive when c lies left of the way from a to b, zero when the
/// three are on one line. The plain formula can get the sign wrong where the points are almost on a line; where its
/// error bound (Shewchuk 1997) leaves the sign open, it is computed again with twice the digits.
double orientation(Vec2d a, Vec2d b, Vec2d c);

/// Makes a polygon's corners ready for ShapeDef: duplicates and points on straight edges (to a billionth of the
/// polygon's extent) dropped, order made counter-clockwise. Otherwise a sentence: what is wrong and what to change.
/// Corners are counted from 1 in the order given.
std::variant<std::vector<Vec2d>, std::string> clean_polygon(const std::vector<Vec2d>& corners);

/// The convex hull, counter-clockwise, by gift wrapping (Jarvis 1973): start at the leftmost point, which must be a
/// corner, and always go on to the point that leaves all others to the left. O(n h) for n points and h corners. Points
/// inside an edge are left out. Points on one line give their two ends, equal points one; what is not finite comes
/// back as it is.
std::vector<Vec2d> convex_hull(const std::vector<Vec2d>& points);

/// Whether the outline turns left (or goes straight on) at every corner and goes round only once. A pentagram turns
/// left everywhere too, but goes round twice.
bool is_convex(std::span<const Vec2d> corners);

/// The three integrals over a polygon, summed over the triangles (first corner, corner i, corner i + 1): thesis 3.7 and
/// 3.8. Triangles that lie outside a concave polygon count negative and cancel. Measuring from the first corner
/// instead of the origin keeps all digits when the polygon is far away.
double area_of(std::span<const Vec2d> corners);

/// The centre of mass at equal density. The area must not be zero.
Vec2d centroid_of(std::span<const Vec2d> corners);

/// The second moment of area about the centroid, m^4: times density, the moment of inertia. Found about the first
/// corner and moved by the parallel-axis theorem (thesis 3.16: J = J_centroid + m d^2). The area must not be zero.
double second_moment_of(std::span<const Vec2d> corners);

}  // namespace proofreel
