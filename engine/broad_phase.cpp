#include "engine/broad_phase.h"

#include <algorithm>

namespace proofreel {
inline namespace PROOFREEL_PRECISION {

real pair_length(const Shape& a, const Shape& b) {
  if (a.hull.thickness <= 0) return b.hull.thickness > 0 ? b.hull.thickness : real(0.01) * std::max(a.reach, b.reach);
  return b.hull.thickness > 0 ? std::min(a.hull.thickness, b.hull.thickness) : a.hull.thickness;
}

void BroadPhase::add(ShapeIndex index, Shape& shape, const Aabb& box) {
  shape.proxy = tree_.insert(box, index);
  moved_.push_back(index);
}

void BroadPhase::remove(ShapeIndex index, const Shape& shape) {
  tree_.remove(shape.proxy);
  std::erase(moved_, index);
}

void BroadPhase::move(ShapeIndex index, const Shape& shape, const Aabb& box, Vec2 displacement) {
  if (contains(tree_.aabb(shape.proxy), swept(box, displacement))) return;
  // Room for a few ticks to come, so that a body in motion does not leave its box every time.
  const real margin = real(0.1) * (shape.hull.thickness > 0 ? shape.hull.thickness : shape.reach);
  tree_.move(shape.proxy, swept(expanded(box, margin), real(4) * displacement));
  moved_.push_back(index);
}

std::vector<ShapePair> BroadPhase::new_pairs(const std::vector<Shape>& shapes, const std::vector<Body>& bodies) {
  std::vector<ShapePair> pairs;
  const auto may_meet = [&](ShapeIndex i, ShapeIndex j) {
    const Body& a = bodies[shapes[i].body];
    const Body& b = bodies[shapes[j].body];
    const bool moves = a.type == BodyType::dynamic || b.type == BodyType::dynamic;
    return shapes[i].body != shapes[j].body && moves && filters_agree(a.filter, b.filter);
  };
  for (const ShapeIndex i : moved_) {
    tree_.query(tree_.aabb(shapes[i].proxy), [&](ProxyId, std::uint32_t j) {
      const ShapePair pair{std::min(i, j), std::max(i, j)};
      if (may_meet(i, j) && known_.insert(key(pair)).second) pairs.push_back(pair);
      return true;
    });
  }
  moved_.clear();
  std::sort(pairs.begin(), pairs.end(), [](ShapePair p, ShapePair q) { return key(p) < key(q); });
  return pairs;
}

}  // namespace PROOFREEL_PRECISION
}  // namespace proofreel
