#include "render/canvas_batches.h"

#include <algorithm>

#include "engine/state_hash.h"

namespace proofreel {

BatchList::BatchList(int width_px, int height_px)
    : grid_(width_px, height_px), last_batch_(grid_.size()), tile_hashes_(grid_.size()) {}

void BatchList::add(ShapeKind kind, std::span<const float> values, const Quad& quad) {
  const TileSpan span = grid_.span_of(bounds_of(quad));
  find_tiles(quad, span);
  const std::size_t index = batch_from(last_batch_there(), kind);
  Batch& batch = batches_[index];
  batch.values.insert(batch.values.end(), values.begin(), values.end());
  batch.places.push_back(span);
  const std::uint64_t mark =
      chained_hash(static_cast<std::uint64_t>(kind), hash_of(values.data(), values.size_bytes()));
  for (const std::size_t tile : there_) {
    last_batch_[tile] = index;
    tile_hashes_[tile] = chained_hash(tile_hashes_[tile], mark);
  }
}

void BatchList::clear(std::uint64_t ground) {
  for (Batch& batch : batches_) {
    batch.values.clear();
    batch.places.clear();
  }
  used_ = 0;
  std::fill(last_batch_.begin(), last_batch_.end(), 0);
  std::fill(tile_hashes_.begin(), tile_hashes_.end(), ground);
}

/// A pixel counts where its centre is covered, which lies half a pixel inside its tile: roundings of the quad do no
/// harm.
void BatchList::find_tiles(const Quad& quad, const TileSpan& span) {
  there_.clear();
  for (int row = span.top; row < span.bottom; ++row) {
    for (int column = span.left; column < span.right; ++column) {
      if (may_touch(quad, grid_.bounds_of(column, row))) there_.push_back(grid_.number(column, row));
    }
  }
}

std::size_t BatchList::last_batch_there() const {
  std::size_t last = 0;
  for (const std::size_t tile : there_) last = std::max(last, last_batch_[tile]);
  return last;
}

/// The first batch of `kind` that is not before `first`; a new last one when there is none.
std::size_t BatchList::batch_from(std::size_t first, ShapeKind kind) {
  for (std::size_t i = first; i < used_; ++i) {
    if (batches_[i].kind == kind) return i;
  }
  if (used_ == batches_.size()) batches_.emplace_back();
  batches_[used_].kind = kind;
  return used_++;
}

}  // namespace proofreel
