/// Compiled twice, with the engine of each precision.

#include <new>

#include "engine/collide.h"
#include "lab/manifold_side.h"

namespace proofreel {
inline namespace PROOFREEL_PRECISION {
namespace {

class OurManifolds final : public ManifoldSide {
 public:
  explicit OurManifolds(const std::vector<ShapePair>& pairs) : manifolds_(pairs.size()) {
    for (const ShapePair& p : pairs) {
      pairs_.push_back({make_hull(p.a, {}), make_hull(p.b, {}), Pose(p.pose_a), Pose(p.pose_b)});
    }
  }

  void collide_all() override {
    for (std::size_t i = 0; i < pairs_.size(); ++i) {
      const Pair& p = pairs_[i];
      // Made in place, as Box2D does: a copy would wait for what was only just written.
      ::new (static_cast<void*>(&manifolds_[i])) Manifold(collide(p.a, p.pose_a, p.b, p.pose_b, real(0)));
    }
  }

  Touch touch(std::size_t pair) const override {
    const Manifold& m = manifolds_[pair];
    return {m.count, Vec2d(m.normal), static_cast<double>(deepest(m))};
  }

 private:
  struct Pair {
    Hull a;
    Hull b;
    Pose pose_a;
    Pose pose_b;
  };
  std::vector<Pair> pairs_;
  std::vector<Manifold> manifolds_;
};

}  // namespace

std::unique_ptr<ManifoldSide> our_manifolds(const std::vector<ShapePair>& pairs) {
  return std::make_unique<OurManifolds>(pairs);
}

}  // namespace PROOFREEL_PRECISION
}  // namespace proofreel
