#pragma once

/// Questions about single shapes, all answered by GJK (gjk.h): do they overlap, what does a ray or a moving shape hit
/// first? Shapes are closed: touching counts as overlap.
///
/// A cast is an approach in jumps (van den Bergen 2004): while the shapes are apart, the plane square to the line
/// between their nearest points separates them, so nothing can be hit before that plane is; jump there and look again.
/// The distance of convex shapes along a straight way is a convex function, and this is Newton's method on it: it never
/// jumps too far, and an approach that has once turned into a retreat stays one.

#include <optional>

#include "engine/epa.h"

namespace proofreel {
inline namespace PROOFREEL_PRECISION {

bool overlap(const Hull& a, const Pose& pose_a, const Hull& b, const Pose& pose_b);

struct CastHit {
  real fraction = 0;      ///< of the way, 0 to 1
  Vec2 point;             ///< on the surface of what was hit, world coordinates
  Vec2 normal;            ///< unit, out of the surface that was hit
  bool at_start = false;  ///< overlapping or touching already: fraction 0, normal along the shortest way out
};

/// Where hull `a`, moved by `translation` without turning, first touches hull `b`. Nothing when it does not.
/// An overlap at the start is a hit at the start, whatever the direction. Shapes that only touch at the start hit each
/// other when they approach; when they part or slide along each other, they do not.
template <typename Observer = NoObserver>
std::optional<CastHit> shape_cast(const Hull& a, const Pose& pose_a, Vec2 translation, const Hull& b,
                                  const Pose& pose_b, Observer observer = {});

/// Where the way from `from` to `to` first meets the hull: a cast of a point, so what is said there about the start
/// holds for a ray that starts inside or on the surface. A ray in line with a face hits the corner where the face
/// begins.
template <typename Observer = NoObserver>
std::optional<CastHit> ray_cast(const Hull& hull, const Pose& pose, Vec2 from, Vec2 to, Observer observer = {});

}  // namespace PROOFREEL_PRECISION
}  // namespace proofreel
