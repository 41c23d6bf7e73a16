#include <chipmunk/chipmunk.h>

#include <algorithm>
#include <limits>

#include "lab/manifold_side.h"

namespace proofreel {
namespace {

cpVect to_cp(Vec2d v) { return cpv(v.x, v.y); }

/// A shape on a body of its own, in no space.
struct Shape {
  std::unique_ptr<cpBody, decltype(&cpBodyFree)> body{cpBodyNew(1, 1), cpBodyFree};
  std::unique_ptr<cpShape, decltype(&cpShapeFree)> shape{nullptr, cpShapeFree};
};

Shape shape_of(const ShapeDef& def, const Posed& pose) {
  Shape made;
  std::vector<cpVect> points;
  for (const Vec2d p : def.points) points.push_back(to_cp(p));
  cpShape* shape = points.size() == 1
                       ? cpCircleShapeNew(made.body.get(), def.radius, points[0])
                       : cpPolyShapeNewRaw(made.body.get(), static_cast<int>(points.size()), points.data(), def.radius);
  made.shape.reset(shape);
  cpShapeUpdate(shape, cpTransformNew(pose.rotation.c, pose.rotation.s, -pose.rotation.s, pose.rotation.c,
                                      pose.position.x, pose.position.y));
  return made;
}

class ChipmunkManifolds final : public ManifoldSide {
 public:
  explicit ChipmunkManifolds(const std::vector<ShapePair>& pairs) : manifolds_(pairs.size()) {
    for (const ShapePair& p : pairs) pairs_.push_back({shape_of(p.a, p.pose_a), shape_of(p.b, p.pose_b)});
  }

  void collide_all() override {
    for (std::size_t i = 0; i < pairs_.size(); ++i) {
      manifolds_[i] = cpShapesCollide(pairs_[i].a.shape.get(), pairs_[i].b.shape.get());
    }
  }

  Touch touch(std::size_t pair) const override {
    const cpContactPointSet& m = manifolds_[pair];
    if (m.count == 0) return {};
    // From the points, because `distance` has the wrong sign where Chipmunk changes the order of the shapes.
    double separation = std::numeric_limits<double>::max();
    for (int i = 0; i < m.count; ++i) {
      const double along = cpvdot(cpvsub(m.points[i].pointB, m.points[i].pointA), m.normal);
      separation = std::min(separation, along);
    }
    return {m.count, {m.normal.x, m.normal.y}, separation};
  }

 private:
  struct Pair {
    Shape a;
    Shape b;
  };
  std::vector<Pair> pairs_;
  std::vector<cpContactPointSet> manifolds_;
};

}  // namespace

std::unique_ptr<ManifoldSide> chipmunk_manifolds(const std::vector<ShapePair>& pairs) {
  return std::make_unique<ChipmunkManifolds>(pairs);
}

}  // namespace proofreel
