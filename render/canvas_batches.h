#pragma once

/// What a canvas is asked to draw, sorted into few draw calls.

#include <cstdint>
#include <span>
#include <vector>

#include "engine/aabb.h"
#include "render/canvas_shaders.h"

namespace proofreel {

/// Instances of one kind that are drawn by one call.
struct Batch {
  ShapeKind kind = ShapeKind::box;
  std::vector<float> values;
};

/// Changing programs costs llvmpipe about 10 microseconds, so a shape joins the earliest batch of its kind that is
/// drawn after everything it overlaps. Which that is, is looked up by tiles of the picture: each remembers the last
/// batch that touched it. The picture is the same as if all were drawn in the order of the calls.
class BatchList {
 public:
  BatchList(int width_px, int height_px);

  /// `values` are as many floats as the kind has; `bounds` is the part of the picture they may change, in pixels.
  void add(ShapeKind kind, std::span<const float> values, const Aabbd& bounds);
  void clear();
  std::span<const Batch> batches() const { return {batches_.data(), used_}; }

 private:
  struct Tiles {
    int left, right, top, bottom;  // closed
  };
  Tiles tiles_of(const Aabbd& bounds) const;
  std::size_t last_touching(const Tiles& tiles) const;
  std::size_t batch_from(std::size_t first, ShapeKind kind);

  int columns_;
  int rows_;
  std::vector<std::size_t> last_batch_;  // by tile
  std::vector<Batch> batches_;           // kept with their memory from picture to picture
  std::size_t used_ = 0;
};

}  // namespace proofreel
