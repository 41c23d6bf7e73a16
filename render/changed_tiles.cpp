#include "render/changed_tiles.h"

#include <algorithm>
#include <atomic>
#include <limits>

namespace proofreel {
namespace {

/// A rectangle more costs about as much as drawing so many tiles: every program is started once more for it.
constexpr int price_of_a_part = 64;

class Cover {
 public:
  Cover(const TileGrid& grid, std::span<const unsigned char> marked) : grid_(grid), marked_(marked) {}

  /// Covers what is marked within `span` by its bounds, or where they hold too much else, half by half.
  void add(const TileSpan& span) {
    int marked = 0;
    const TileSpan bounds = bounds_within(span, marked);
    if (marked == 0) return;
    if (tiles_in(bounds) - marked <= price_of_a_part) return parts_.push_back(bounds);
    TileSpan first = bounds, second = bounds;
    if (bounds.right - bounds.left > bounds.bottom - bounds.top) {
      first.right = second.left = (bounds.left + bounds.right) / 2;
    } else {
      first.bottom = second.top = (bounds.top + bounds.bottom) / 2;
    }
    add(first);
    add(second);
  }

  std::vector<TileSpan> take() { return std::move(parts_); }

 private:
  TileSpan bounds_within(const TileSpan& span, int& marked) const {
    TileSpan bounds{std::numeric_limits<int>::max(), 0, std::numeric_limits<int>::max(), 0};
    for (int row = span.top; row < span.bottom; ++row) {
      for (int column = span.left; column < span.right; ++column) {
        if (marked_[grid_.number(column, row)] == 0) continue;
        bounds = {std::min(bounds.left, column), std::max(bounds.right, column + 1), std::min(bounds.top, row),
                  std::max(bounds.bottom, row + 1)};
        ++marked;
      }
    }
    return bounds;
  }

  const TileGrid& grid_;
  std::span<const unsigned char> marked_;
  std::vector<TileSpan> parts_;
};

std::uint64_t next_series() {
  static std::atomic<std::uint64_t> last{0};
  return ++last;
}

/// Drawing all of a picture costs less than drawing more than half of it in parts, since its tiles are cleared as one.
bool is_most_of(const TileGrid& grid, std::span<const TileSpan> parts) {
  int price = 0;
  for (const TileSpan& part : parts) price += tiles_in(part) + price_of_a_part;
  return 2 * price > tiles_in(grid.whole());
}

}  // namespace

std::vector<TileSpan> parts_that_hold(const TileGrid& grid, std::span<const unsigned char> marked) {
  Cover cover(grid, marked);
  cover.add(grid.whole());
  return cover.take();
}

ChangedTiles::ChangedTiles(const TileGrid& grid) : grid_(grid), hashes_(grid.size()), drawn_in_(grid.size()) {}

std::vector<TileSpan> ChangedTiles::begin(std::span<const std::uint64_t> hashes) {
  std::vector<unsigned char> changed(grid_.size(), 1);
  if (known_) {
    for (std::size_t i = 0; i < hashes.size(); ++i) changed[i] = hashes[i] != hashes_[i] ? 1 : 0;
  } else {
    series_ = next_series();
    number_ = 0;
  }
  known_ = false;
  std::vector<TileSpan> parts = parts_that_hold(grid_, changed);
  if (parts.empty()) return parts;
  ++number_;
  changes_.clear();
  for (const TileSpan& part : parts) {
    changes_.push_back(grid_.pixels_of(part));
    for (int row = part.top; row < part.bottom; ++row)
      std::fill_n(&drawn_in_[grid_.number(part.left, row)], part.right - part.left, number_);
  }
  hashes_.assign(hashes.begin(), hashes.end());
  if (is_most_of(grid_, parts)) return {grid_.whole()};
  return parts;
}

std::vector<TileSpan> ChangedTiles::parts_since(const Edition& held) const {
  if (held.series != series_) return {grid_.whole()};
  std::vector<unsigned char> newer(grid_.size());
  for (std::size_t i = 0; i < newer.size(); ++i) newer[i] = drawn_in_[i] > held.number ? 1 : 0;
  return parts_that_hold(grid_, newer);
}

}  // namespace proofreel
