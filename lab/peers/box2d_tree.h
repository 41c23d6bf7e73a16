#pragma once

/// Box2D's broad phase by itself, for the benchmark of ours. Many boxes per call, so that the call costs neither side
/// anything.

#include <cstddef>
#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

#include "engine/aabb.h"

namespace proofreel {

using BoxF = BasicAabb<float>;
using Vec2f = BasicVec2<float>;
/// Positions of two boxes in the list, the smaller first.
using BoxPair = std::pair<std::uint32_t, std::uint32_t>;

class Box2dBroadPhase {
 public:
  /// What Box2D fattens boxes by, m.
  static float margin();

  explicit Box2dBroadPhase(const std::vector<BoxF>& boxes);
  ~Box2dBroadPhase();
  Box2dBroadPhase(const Box2dBroadPhase&) = delete;
  Box2dBroadPhase& operator=(const Box2dBroadPhase&) = delete;

  /// Every box now and what it moves by until the next call: stays in its fat box, or gets a new one that reaches
  /// `margin` to all sides and four times the displacement ahead.
  void move(const std::vector<BoxF>& boxes, const std::vector<Vec2f>& displacements);
  /// Overlapping fat boxes of which one has moved. Box2D tells them anew each time; who is known already is left to the
  /// caller.
  void update_pairs(std::vector<BoxPair>& pairs);
  /// How many fat boxes overlap each of these, in sum.
  std::size_t query(const std::vector<BoxF>& boxes) const;
  BoxF fat_box(std::uint32_t index) const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace proofreel
