#pragma once

/// The narrow phases that `bench collision` sets beside each other, ours and the peers', behind one interface: each
/// gets the same pairs, keeps them in its own form and makes all their manifolds at one call.

#include <memory>
#include <vector>

#include "engine/pose.h"
#include "engine/scene.h"

namespace proofreel {

/// Two convex shapes where they are. Coordinates are relative to the poses, which stand for centres of mass.
struct ShapePair {
  ShapeDef a;
  ShapeDef b;
  Posed pose_a;
  Posed pose_b;
};

/// What a manifold says, in words all have in common.
struct Touch {
  int points = 0;
  Vec2d normal;           ///< unit, from A to B
  double separation = 0;  ///< of the deepest point, negative on overlap
};

class ManifoldSide {
 public:
  virtual ~ManifoldSide() = default;
  /// One manifold per pair, of what overlaps; points that are apart are not asked for.
  virtual void collide_all() = 0;
  /// Of the last call.
  virtual Touch touch(std::size_t pair) const = 0;
};

// Inline, as the engine has them: whoever calls names the one he wants.
inline namespace float32 {
std::unique_ptr<ManifoldSide> our_manifolds(const std::vector<ShapePair>& pairs);
}
inline namespace float64 {
std::unique_ptr<ManifoldSide> our_manifolds(const std::vector<ShapePair>& pairs);
}

/// Box2D 2.4 without the skin of its polygons: b2CollideCircles, b2CollidePolygonAndCircle, b2CollidePolygons. Discs
/// and polygons of at most 8 corners. These give points in the shapes' own coordinates; with `in_world` b2WorldManifold
/// follows, which makes of them what ours gives: normal and points in world axes, and separations.
std::unique_ptr<ManifoldSide> box2d_manifolds(const std::vector<ShapePair>& pairs, bool in_world);

/// Chipmunk 7: cpShapesCollide. It computes in double precision.
std::unique_ptr<ManifoldSide> chipmunk_manifolds(const std::vector<ShapePair>& pairs);

}  // namespace proofreel
