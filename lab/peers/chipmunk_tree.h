#pragma once

/// Chipmunk's spatial indices by themselves, for the benchmark of our broad phase. They compute in double precision,
/// fatten boxes by rules of their own (the tree; the hash not at all) and tell every pair at every step.

#include <cstddef>
#include <memory>
#include <vector>

#include "engine/aabb.h"

namespace proofreel {

class ChipmunkIndex {
 public:
  enum class Kind { tree, hash };

  ChipmunkIndex(Kind kind, const std::vector<BasicAabb<float>>& boxes);
  ~ChipmunkIndex();
  ChipmunkIndex(const ChipmunkIndex&) = delete;
  ChipmunkIndex& operator=(const ChipmunkIndex&) = delete;

  /// Moves the boxes there, finds all pairs and returns how many. Displacements are what the boxes move by next.
  std::size_t step(const std::vector<BasicAabb<float>>& boxes, const std::vector<BasicVec2<float>>& displacements);

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace proofreel
