#include <box2d/box2d.h>

#include <algorithm>
#include <cassert>

#include "lab/manifold_side.h"

namespace proofreel {
namespace {

b2Vec2 to_b2(Vec2d v) { return {static_cast<float>(v.x), static_cast<float>(v.y)}; }

b2Transform to_b2(const Posed& pose) {
  b2Rot rotation;
  rotation.c = static_cast<float>(pose.rotation.c);
  rotation.s = static_cast<float>(pose.rotation.s);
  return {to_b2(pose.position), rotation};
}

/// Box2D knows two shapes: discs and polygons.
struct Shape {
  bool disc = false;
  b2CircleShape circle;
  b2PolygonShape polygon;

  float radius() const { return disc ? circle.m_radius : polygon.m_radius; }
};

Shape shape_of(const ShapeDef& def) {
  assert(def.points.size() <= b2_maxPolygonVertices);
  Shape shape;
  shape.disc = def.points.size() == 1;
  if (shape.disc) {
    shape.circle.m_p = to_b2(def.points[0]);
    shape.circle.m_radius = static_cast<float>(def.radius);
    return shape;
  }
  std::vector<b2Vec2> points;
  for (const Vec2d p : def.points) points.push_back(to_b2(p));
  shape.polygon.Set(points.data(), static_cast<int32>(points.size()));
  shape.polygon.m_radius = 0;  // else it would compute manifolds of shapes 1 cm apart, which the others do not
  return shape;
}

class Box2dManifolds final : public ManifoldSide {
 public:
  Box2dManifolds(const std::vector<ShapePair>& pairs, bool in_world)
      : in_world_(in_world), manifolds_(pairs.size()), world_manifolds_(pairs.size()) {
    for (const ShapePair& p : pairs) {
      pairs_.push_back({shape_of(p.a), shape_of(p.b), to_b2(p.pose_a), to_b2(p.pose_b)});
    }
  }

  void collide_all() override {
    for (std::size_t i = 0; i < pairs_.size(); ++i) {
      collide(pairs_[i], manifolds_[i]);
      if (in_world_ && manifolds_[i].pointCount > 0) world_manifolds_[i] = world_manifold(i);
    }
  }

  Touch touch(std::size_t pair) const override {
    const b2Manifold& m = manifolds_[pair];
    if (m.pointCount == 0) return {};
    const b2WorldManifold world = world_manifold(pair);
    const float separation = *std::min_element(world.separations, world.separations + m.pointCount);
    const Vec2d normal{static_cast<double>(world.normal.x), static_cast<double>(world.normal.y)};
    return {m.pointCount, normal, static_cast<double>(separation)};
  }

 private:
  struct Pair {
    Shape a;
    Shape b;
    b2Transform pose_a;
    b2Transform pose_b;
  };

  /// Of a disc and a polygon, the disc comes second.
  static void collide(const Pair& p, b2Manifold& m) {
    if (p.a.disc && p.b.disc) {
      b2CollideCircles(&m, &p.a.circle, p.pose_a, &p.b.circle, p.pose_b);
    } else if (p.b.disc) {
      b2CollidePolygonAndCircle(&m, &p.a.polygon, p.pose_a, &p.b.circle, p.pose_b);
    } else {
      b2CollidePolygons(&m, &p.a.polygon, p.pose_a, &p.b.polygon, p.pose_b);
    }
  }

  b2WorldManifold world_manifold(std::size_t pair) const {
    const Pair& p = pairs_[pair];
    b2WorldManifold world;
    world.Initialize(&manifolds_[pair], p.pose_a, p.a.radius(), p.pose_b, p.b.radius());
    return world;
  }

  bool in_world_;
  std::vector<Pair> pairs_;
  std::vector<b2Manifold> manifolds_;
  std::vector<b2WorldManifold> world_manifolds_;
};

}  // namespace

std::unique_ptr<ManifoldSide> box2d_manifolds(const std::vector<ShapePair>& pairs, bool in_world) {
  return std::make_unique<Box2dManifolds>(pairs, in_world);
}

}  // namespace proofreel
