#pragma once

/// Polygons as lists of corners, in double precision: what is done once when a scene is built, not at every tick.
/// Lengths in metres, corners counter-clockwise unless said otherwise. All decisions are made by the exact predicates.

#include <span>
#include <vector>

#include "engine/observer.h"
#include "engine/predicates.h"
#include "engine/vec2.h"

namespace proofreel {

/// The convex hull, counter-clockwise, by gift wrapping (Jarvis 1973): start at the leftmost point, which must be a
/// corner, and always go on to the point that leaves all others to the left. O(n h) for n points and h corners. Points
/// inside an edge are left out. Points on one line give their two ends, equal points one; what is not finite comes
/// back as it is. The observer sees HullCorner and HullCandidate.
template <typename Observer = NoObserver>
std::vector<Vec2d> convex_hull(const std::vector<Vec2d>& points, Observer observer = {});

/// Whether the outline turns left (or goes straight on) at every corner and goes round only once. A pentagram turns
/// left everywhere too, but goes round twice. An outline without area is not convex, and neighbours that are equal
/// count as one corner. The observer sees CornerTested, up to the first corner that turns right.
template <typename Observer = NoObserver>
bool is_convex(std::span<const Vec2d> corners, Observer observer = {});

/// Whether a quadrilateral, listed in either sense, is convex: each diagonal has the other two corners on its two
/// sides. This is thesis equation 3.4 with BA for CA, which lets darts pass as printed:
///     (BD x BA) (BD x BC) < 0  and  (AC x AD) (AC x AB) < 0.
/// A product of zero counts here as long as not all four are on one line: a corner that goes straight on lies on a
/// diagonal. So the answer is that of is_convex, which needs one sense and works for any number of corners. The
/// observer sees DiagonalTested, once for each diagonal looked at.
template <typename Observer = NoObserver>
bool quadrilateral_is_convex(Vec2d a, Vec2d b, Vec2d c, Vec2d d, Observer observer = {});

/// What is left of a convex polygon, counter-clockwise, when all its edges move inwards by `by` metres; fewer than
/// three corners when nothing is.
std::vector<Vec2d> inset(const std::vector<Vec2d>& corners, double by);

/// Integrals over a polygon, summed over the fan of triangles (first corner, corner i, corner i + 1): thesis
/// 3.7 and 3.8. Triangles that lie outside a concave polygon count negative and cancel. Measuring from the first corner
/// instead of the origin keeps all digits when the polygon is far away. The observer sees TriangleAdded.
template <typename Observer = NoObserver>
double area_of(std::span<const Vec2d> corners, Observer observer = {});

/// The centre of mass at equal density. The area must not be zero.
template <typename Observer = NoObserver>
Vec2d centroid_of(std::span<const Vec2d> corners, Observer observer = {});

}  // namespace proofreel
