#pragma once

/// Cuts a concave polygon into convex ones, since collision and mass know convex shapes only. No corners are added.

#include <string>
#include <variant>
#include <vector>

#include "engine/observer.h"
#include "engine/vec2.h"

namespace proofreel {

using ConvexParts = std::vector<std::vector<Vec2d>>;

/// The smallest number of convex parts that diagonals can cut `outline` into, each with at most max_polygon_vertices
/// corners and none thinner than a millionth of its extent, so that each makes a sound ShapeDef. A convex outline with
/// few enough corners comes back as it is. Where no cut avoids a thin part: a sentence that names its corner.
///
/// `outline` must be what clean_polygon returns. Parts are counter-clockwise and always the same for the same outline;
/// a corner at which a part goes straight on is not listed as one of its corners.
///
/// By dynamic programming over pairs of corners that see each other (Keil 1985; Keil & Snoeyink 2002): the part at a
/// diagonal is a convex chain from one end to the other, and what lies behind each link of the chain is a smaller
/// problem solved before. Of all chains only those are kept that no other can stand in for: one with no more parts and
/// corners and no larger angles at both ends. O(n^3) for n corners, since few are: 256 corners take at most a third of
/// a second. Thickness is looked at only when the first solution has a thin part; then it takes some ten times as long.
/// With r concave corners there are from r / 2 + 1 to 2 r + 1 parts (Hertel & Mehlhorn 1983); where only the limit
/// of corners forbids a part, one more than necessary is possible.
///
/// The observer sees CutChosen for every diagonal cut along.
template <typename Observer = NoObserver>
std::variant<ConvexParts, std::string> convex_parts(const std::vector<Vec2d>& outline, Observer observer = {});

}  // namespace proofreel
