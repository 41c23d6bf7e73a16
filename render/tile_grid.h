#pragma once

/// A picture cut into squares, to know what lies where without looking at pixels.

#include <algorithm>
#include <cstddef>

#include "engine/aabb.h"
#include "render/image.h"

namespace proofreel {

/// A side of a tile.
inline constexpr int tile_px = 16;

/// A rectangle of tiles: columns from `left` to before `right`, rows from `top` to before `bottom`.
struct TileSpan {
  int left = 0;
  int right = 0;
  int top = 0;
  int bottom = 0;
  friend bool operator==(const TileSpan&, const TileSpan&) = default;
};

inline int tiles_in(const TileSpan& span) { return (span.right - span.left) * (span.bottom - span.top); }

inline bool overlaps(const TileSpan& a, const TileSpan& b) {
  return a.left < b.right && b.left < a.right && a.top < b.bottom && b.top < a.bottom;
}

/// The tiles of one picture are numbered row by row from the top left; those at its right and lower edge may be cut.
class TileGrid {
 public:
  TileGrid(int width_px, int height_px)
      : width_px_(width_px),
        height_px_(height_px),
        columns_((width_px + tile_px - 1) / tile_px),
        rows_((height_px + tile_px - 1) / tile_px) {}

  TileSpan whole() const { return {0, columns_, 0, rows_}; }
  std::size_t size() const { return static_cast<std::size_t>(tiles_in(whole())); }
  std::size_t number(int column, int row) const { return static_cast<std::size_t>(row * columns_ + column); }

  /// Of one tile, in pixels.
  Aabbd bounds_of(int column, int row) const {
    const Vec2d low{static_cast<double>(column) * tile_px, static_cast<double>(row) * tile_px};
    return {low, low + Vec2d{tile_px, tile_px}};
  }

  /// The tiles whose pixels `bounds` (px) may hold; what lies outside of the picture counts as being at its edge.
  TileSpan span_of(const Aabbd& bounds) const {
    return {at(bounds.lower.x, columns_), at(bounds.upper.x, columns_) + 1, at(bounds.lower.y, rows_),
            at(bounds.upper.y, rows_) + 1};
  }

  PixelRect pixels_of(const TileSpan& span) const {
    const int left = span.left * tile_px, top = span.top * tile_px;
    return {left, top, std::min(span.right * tile_px, width_px_) - left,
            std::min(span.bottom * tile_px, height_px_) - top};
  }

 private:
  static int at(double position, int tiles) {
    return static_cast<int>(std::clamp(position / tile_px, 0.0, static_cast<double>(tiles - 1)));
  }

  int width_px_;
  int height_px_;
  int columns_;
  int rows_;
};

}  // namespace proofreel
