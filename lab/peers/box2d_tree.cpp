#include "lab/peers/box2d_tree.h"

#include <box2d/box2d.h>

#include <algorithm>

namespace proofreel {
namespace {

b2Vec2 to_box2d(Vec2f v) { return {v.x, v.y}; }

b2AABB to_box2d(const BoxF& box) {
  b2AABB result;
  result.lowerBound = to_box2d(box.lower);
  result.upperBound = to_box2d(box.upper);
  return result;
}

void* index_as_data(std::size_t index) { return reinterpret_cast<void*>(index); }
std::uint32_t data_as_index(void* data) { return static_cast<std::uint32_t>(reinterpret_cast<std::size_t>(data)); }

struct PairList {
  std::vector<BoxPair>& pairs;
  void AddPair(void* a, void* b) { pairs.push_back(std::minmax(data_as_index(a), data_as_index(b))); }
};

struct Counter {
  std::size_t found = 0;
  bool QueryCallback(int32) {
    ++found;
    return true;
  }
};

}  // namespace

struct Box2dBroadPhase::Impl {
  b2BroadPhase broad_phase;
  std::vector<int32> proxies;
};

float Box2dBroadPhase::margin() { return b2_aabbExtension; }

Box2dBroadPhase::Box2dBroadPhase(const std::vector<BoxF>& boxes) : impl_(std::make_unique<Impl>()) {
  for (const BoxF& box : boxes) {
    const std::size_t index = impl_->proxies.size();
    impl_->proxies.push_back(impl_->broad_phase.CreateProxy(to_box2d(box), index_as_data(index)));
  }
}

Box2dBroadPhase::~Box2dBroadPhase() = default;

/// Box2D asks for the box of the whole way and adds four times the displacement to that; three quarters of it make
/// four displacements from where the box is now.
void Box2dBroadPhase::move(const std::vector<BoxF>& boxes, const std::vector<Vec2f>& displacements) {
  static_assert(b2_aabbMultiplier == 4.0F);
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    const BoxF way = swept(boxes[i], displacements[i]);
    impl_->broad_phase.MoveProxy(impl_->proxies[i], to_box2d(way), to_box2d(0.75F * displacements[i]));
  }
}

void Box2dBroadPhase::update_pairs(std::vector<BoxPair>& pairs) {
  pairs.clear();
  PairList list{pairs};
  impl_->broad_phase.UpdatePairs(&list);
}

std::size_t Box2dBroadPhase::query(const std::vector<BoxF>& boxes) const {
  Counter counter;
  for (const BoxF& box : boxes) impl_->broad_phase.Query(&counter, to_box2d(box));
  return counter.found;
}

BoxF Box2dBroadPhase::fat_box(std::uint32_t index) const {
  const b2AABB& box = impl_->broad_phase.GetFatAABB(impl_->proxies[index]);
  return {{box.lowerBound.x, box.lowerBound.y}, {box.upperBound.x, box.upperBound.y}};
}

}  // namespace proofreel
