#pragma once

/// Polygons as lists of corners, in double precision: what is done once when a scene is built, not at every tick.
/// Lengths in metres, corners counter-clockwise unless said otherwise. All decisions are made by the exact predicates.

#include <span>
#include <string>
#include <variant>
#include <vector>

#include "engine/observer.h"
#include "engine/predicates.h"
#include "engine/vec2.h"

namespace proofreel {

/// The farthest a corner may lie from the origin along either axis, and the largest size of a shape, m.
inline constexpr double max_coordinate = 1e9;

/// The most corners an outline may have: cutting it into convex parts takes the cube of their number.
inline constexpr int max_outline_corners = 256;

/// Makes the outline of a polygon, convex or concave, ready for use: duplicates and points on straight edges (to a
/// billionth of the polygon's extent) dropped, order made counter-clockwise. Otherwise a sentence: what is wrong and
/// what to change, with corners counted from 1 in the order given. Refused are coordinates that are not finite or above
/// 1e9, fewer than three distinct points, zero area, a polygon thinner than a millionth of its extent, more corners
/// than max_outline_corners, and an outline that crosses or touches itself, to a billionth of its extent (so there are
/// no holes). `name` is what the sentence calls the polygon.
std::variant<std::vector<Vec2d>, std::string> clean_polygon(const std::vector<Vec2d>& corners,
                                                            const std::string& name = "the polygon");

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

/// The three integrals over a polygon, summed over the fan of triangles (first corner, corner i, corner i + 1): thesis
/// 3.7 and 3.8. Triangles that lie outside a concave polygon count negative and cancel. Measuring from the first corner
/// instead of the origin keeps all digits when the polygon is far away. The observer sees TriangleAdded.
template <typename Observer = NoObserver>
double area_of(std::span<const Vec2d> corners, Observer observer = {});

/// The centre of mass at equal density. The area must not be zero.
template <typename Observer = NoObserver>
Vec2d centroid_of(std::span<const Vec2d> corners, Observer observer = {});

/// The second moment of area about the centroid, m^4: times density, the moment of inertia (thesis 3.15). The area must
/// not be zero. It is summed over the triangles (centroid, corner i, corner i + 1), so that a convex polygon's is a sum
/// of positive terms. Moving the moment about another point to the centroid by the parallel-axis theorem (thesis 3.16)
/// would take a difference, which can lose all its digits, and its sign.
double second_moment_of(std::span<const Vec2d> corners);

}  // namespace proofreel
