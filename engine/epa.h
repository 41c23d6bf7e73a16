#pragma once

/// How deep two overlapping convex shapes are in each other, and the shortest way out: the expanding polytope algorithm
/// (van den Bergen 2001; thesis chapter 4.4), which goes on where GJK (gjk.h) ends.
///
/// The cores overlap when the origin is inside the Minkowski difference B - A. The shortest way out leads through the
/// edge of B - A nearest the origin. Starting from GJK's last simplex, a polygon inside B - A is blown up: take its
/// edge nearest the origin, ask for the corner of B - A farthest out across it, and put that corner between the edge's
/// ends. When there is no corner farther out, the edge is one of B - A itself.

#include "engine/gjk.h"

namespace proofreel {
inline namespace PROOFREEL_PRECISION {

/// Of the cores, in A's frame.
struct Penetration {
  Vec2 normal;     ///< unit, from A to B: moved along it by `depth`, B's core only touches A's
  real depth = 0;  ///< not negative; radii not counted
  Vec2 on_a;       ///< on A's core, the point deepest in B
  Vec2 on_b;       ///< on B's core, the point deepest in A: on_a - depth * normal
  int iterations = 0;
};

/// For cores that overlap or touch; `simplex` is what GJK left in its cache. A Minkowski difference without area has
/// depth 0: that of collinear segments (or of a disc's centre on one) is left across it, and of two coincident points
/// along A's +y. Ends always: a polygon cannot have more corners than both hulls together.
template <typename Observer = NoObserver>
Penetration core_penetration(const HullPair& pair, const SimplexCache& simplex, Observer observer = {});

}  // namespace PROOFREEL_PRECISION
}  // namespace proofreel
