#include "golden/densest.h"

#include <algorithm>
#include <cassert>

#include "render/vectorised.h"

namespace proofreel {
namespace {

/// Adds one row's different pixels to the columns' counts, or takes them away.
PROOFREEL_VECTORISED
std::int64_t add_to_columns(const PixelClass* __restrict row, std::int32_t* __restrict columns, int width,
                            std::int32_t sign) {
  std::int32_t count = 0;
  for (int x = 0; x < width; ++x) {
    const std::int32_t different = row[x] == PixelClass::different ? sign : 0;
    columns[x] += different;
    count += different;
  }
  return count;
}

/// Counts of different pixels per column, over the rows of the window.
class Columns {
 public:
  Columns(const DifferenceMap& map, int side_px)
      : map_(map), side_px_(side_px), counts_(static_cast<std::size_t>(map.width_px())) {}

  /// Makes row `bottom` the last of the window.
  void move_to(int bottom) {
    add(bottom, 1);
    if (bottom >= side_px_) add(bottom - side_px_, -1);
  }

  std::int64_t total() const { return total_; }

  /// Looks for a window in these rows that holds more than `best`.
  void search(int top, DensestWindow& best) const {
    const int side = std::min(side_px_, map_.width_px());
    std::int64_t inside = 0;
    for (int right = 0; right < map_.width_px(); ++right) {
      inside += counts_[static_cast<std::size_t>(right)];
      if (right >= side) inside -= counts_[static_cast<std::size_t>(right - side)];
      if (inside <= best.different) continue;
      best.different = inside;
      best.rect = {std::max(0, right - side + 1), top, side, std::min(side_px_, map_.height_px())};
    }
  }

 private:
  void add(int y, std::int32_t sign) {
    const std::vector<PixelClass>& row = map_.row(y);
    if (!row.empty()) total_ += add_to_columns(row.data(), counts_.data(), map_.width_px(), sign);
  }

  const DifferenceMap& map_;
  int side_px_;
  std::vector<std::int32_t> counts_;
  std::int64_t total_ = 0;
};

}  // namespace

DensestWindow densest_window(const DifferenceMap& map, int side_px) {
  assert(side_px >= 1);
  DensestWindow best;
  const std::int64_t full = std::int64_t{std::min(side_px, map.width_px())} * std::min(side_px, map.height_px());
  Columns columns(map, side_px);
  for (int bottom = 0; bottom < map.height_px() && best.different < full; ++bottom) {
    columns.move_to(bottom);
    // Rows that hold no more than the best window so far cannot hold a better one.
    if (columns.total() > best.different) columns.search(std::max(0, bottom - side_px + 1), best);
  }
  return best;
}

}  // namespace proofreel
