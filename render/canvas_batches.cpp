#include "render/canvas_batches.h"

#include <algorithm>

namespace proofreel {
namespace {

constexpr int tile_px = 16;

int tile_at(double position, int tiles) {
  return static_cast<int>(std::clamp(position / tile_px, 0.0, static_cast<double>(tiles - 1)));
}

}  // namespace

BatchList::BatchList(int width_px, int height_px)
    : columns_((width_px + tile_px - 1) / tile_px),
      rows_((height_px + tile_px - 1) / tile_px),
      last_batch_(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_)) {}

void BatchList::add(ShapeKind kind, std::span<const float> values, const Aabbd& bounds) {
  const Tiles tiles = tiles_of(bounds);
  const std::size_t index = batch_from(last_touching(tiles), kind);
  Batch& batch = batches_[index];
  batch.values.insert(batch.values.end(), values.begin(), values.end());
  for (int row = tiles.top; row <= tiles.bottom; ++row) {
    std::fill(last_batch_.begin() + row * columns_ + tiles.left, last_batch_.begin() + row * columns_ + tiles.right + 1,
              index);
  }
}

void BatchList::clear() {
  for (Batch& batch : batches_) batch.values.clear();
  used_ = 0;
  std::fill(last_batch_.begin(), last_batch_.end(), 0);
}

BatchList::Tiles BatchList::tiles_of(const Aabbd& bounds) const {
  return {tile_at(bounds.lower.x, columns_), tile_at(bounds.upper.x, columns_), tile_at(bounds.lower.y, rows_),
          tile_at(bounds.upper.y, rows_)};
}

std::size_t BatchList::last_touching(const Tiles& tiles) const {
  std::size_t last = 0;
  for (int row = tiles.top; row <= tiles.bottom; ++row) {
    const auto begin = last_batch_.begin() + row * columns_;
    last = std::max(last, *std::max_element(begin + tiles.left, begin + tiles.right + 1));
  }
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
