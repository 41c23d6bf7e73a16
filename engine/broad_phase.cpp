#include "engine/broad_phase.h"

#include <algorithm>

namespace proofreel {
inline namespace PROOFREEL_PRECISION {
namespace {

/// How often a shape may leave its box, on average over all, before the tree is built anew.
constexpr std::size_t moves_per_rebuild = 3;

}  // namespace

real pair_length(const Shape& a, const Shape& b) {
  if (a.hull.thickness <= 0) return b.hull.thickness > 0 ? b.hull.thickness : real(0.01) * std::max(a.reach, b.reach);
  return b.hull.thickness > 0 ? std::min(a.hull.thickness, b.hull.thickness) : a.hull.thickness;
}

void BroadPhase::mark_as_moved(ShapeIndex index) {
  if (index >= is_moved_.size()) is_moved_.resize(index + 1);
  if (is_moved_[index] != 0) return;
  is_moved_[index] = 1;
  moved_.push_back(index);
}

void BroadPhase::add(ShapeIndex index, Shape& shape, const Aabb& box) {
  shape.proxy = tree_.insert(box, index);
  mark_as_moved(index);
}

void BroadPhase::remove(ShapeIndex index, const Shape& shape) {
  tree_.remove(shape.proxy);
  is_moved_[index] = 0;
}

void BroadPhase::move(ShapeIndex index, const Shape& shape, const Aabb& box, Vec2 displacement) {
  if (contains(tree_.aabb(shape.proxy), swept(box, displacement))) return;
  // Room for a few ticks to come, so that a body in motion does not leave its box every time.
  const real margin = real(0.1) * (shape.hull.thickness > 0 ? shape.hull.thickness : shape.reach);
  tree_.move(shape.proxy, swept(expanded(box, margin), real(4) * displacement));
  ++moves_since_rebuild_;
  mark_as_moved(index);
}

/// Leaves that change their boxes in place slowly spoil the tree. To build it anew costs as much as a few moves of
/// every leaf do, so now and then it pays. The pairs found do not depend on it.
void BroadPhase::rebuild_if_worn() {
  if (moves_since_rebuild_ <= moves_per_rebuild * is_moved_.size()) return;
  tree_.rebuild();
  moves_since_rebuild_ = 0;
}

std::vector<ShapePair> BroadPhase::new_pairs(const std::vector<Shape>& shapes, const std::vector<Body>& bodies) {
  std::vector<ShapePair> pairs;
  const auto may_meet = [&](ShapePair pair) {
    const Body& a = bodies[shapes[pair.a].body];
    const Body& b = bodies[shapes[pair.b].body];
    const bool moves = a.type == BodyType::dynamic || b.type == BodyType::dynamic;
    return shapes[pair.a].body != shapes[pair.b].body && moves && filters_agree(a.filter, b.filter);
  };
  rebuild_if_worn();
  std::vector<ProxyId> leaves;
  for (const ShapeIndex i : moved_) {
    if (is_moved_[i] != 0) leaves.push_back(shapes[i].proxy);
    is_moved_[i] = 0;
  }
  moved_.clear();
  tree_.for_each_pair_of(leaves, [&](ProxyId p, ProxyId q) {
    const auto [a, b] = std::minmax({tree_.owner(p), tree_.owner(q)});
    if (!known_.contains(a, b) && may_meet({a, b})) pairs.push_back({a, b});
  });
  for (const ShapePair pair : pairs) known_.insert(pair.a, pair.b);
  std::sort(pairs.begin(), pairs.end(), [](ShapePair p, ShapePair q) { return p.a != q.a ? p.a < q.a : p.b < q.b; });
  return pairs;
}

}  // namespace PROOFREEL_PRECISION
}  // namespace proofreel
