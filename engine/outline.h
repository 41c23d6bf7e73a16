#pragma once

/// What users give as the outline of a polygon, made ready for use or refused with a sentence. Lengths in metres. All
/// decisions about left and right are made by the exact predicates.

#include <string>
#include <variant>
#include <vector>

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

}  // namespace proofreel
