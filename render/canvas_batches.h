#pragma once

/// What a canvas is asked to draw, sorted into few draw calls.

#include <cstdint>
#include <span>
#include <vector>

#include "render/canvas_geometry.h"
#include "render/canvas_shaders.h"
#include "render/tile_grid.h"

namespace proofreel {

/// Instances of one kind that are drawn by one call.
struct Batch {
  ShapeKind kind = ShapeKind::box;
  std::vector<float> values;
  std::vector<TileSpan> places;  ///< of every instance, bounds of the tiles it may touch
};

/// Changing programs costs llvmpipe about 10 microseconds, so a shape joins the earliest batch of its kind that is
/// drawn after everything it overlaps. Which that is, is looked up by tiles of the picture: each remembers the last
/// batch that touched it. The picture is the same as if all were drawn in the order of the calls.
class BatchList {
 public:
  BatchList(int width_px, int height_px);

  /// `values` are as many floats as the kind has; `quad` is the part of the picture they may change, in pixels.
  void add(ShapeKind kind, std::span<const float> values, const Quad& quad);
  /// Begins anew; `ground` is a number that stands for what the marks will lie on.
  void clear(std::uint64_t ground);
  std::span<const Batch> batches() const { return {batches_.data(), used_}; }
  /// A hash for every tile: equal exactly when the ground is and the marks that may touch it, in their order.
  std::span<const std::uint64_t> tile_hashes() const { return tile_hashes_; }

 private:
  void find_tiles(const Quad& quad, const TileSpan& span);
  std::size_t last_batch_there() const;
  std::size_t batch_from(std::size_t first, ShapeKind kind);

  TileGrid grid_;
  std::vector<std::size_t> there_;       // the tiles that the mark being added may touch
  std::vector<std::size_t> last_batch_;  // by tile
  std::vector<std::uint64_t> tile_hashes_;
  std::vector<Batch> batches_;  // kept with their memory from picture to picture
  std::size_t used_ = 0;
};

}  // namespace proofreel
