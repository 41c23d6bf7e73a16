#pragma once

/// How two pictures differ to somebody who looks at them: which pixels, how many, by how much, and where most densely.
/// For whether they are equal byte for byte, golden/compare.h is enough.

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "golden/region.h"
#include "render/image.h"

namespace proofreel {

struct DifferenceSettings {
  double threshold = 0.1;          ///< 0..1: how far apart colours may be before they count as different (golden/yiq.h)
  bool count_antialiased = false;  ///< pixels that look like anti-aliasing count as different too
  int shift_px = 0;                ///< colours found this near in the other picture, both ways, are not different
  int window_px = 16;              ///< side of the window in which differences are counted
  Region region;                   ///< what is ignored is taken as equal
  int threads = 1;
};

/// What became of one pixel. The order is that of severity.
enum class PixelClass : std::uint8_t {
  same,         ///< equal, or ignored
  similar,      ///< within the threshold
  antialiased,  ///< beyond it, but only as the smoothed edge of something
  shifted,      ///< beyond it, but found nearby
  different
};

/// The class of every pixel. Rows without any difference take no memory.
class DifferenceMap {
 public:
  DifferenceMap() = default;
  DifferenceMap(int width_px, int height_px) : width_px_(width_px), rows_(static_cast<std::size_t>(height_px)) {}

  int width_px() const { return width_px_; }
  int height_px() const { return static_cast<int>(rows_.size()); }
  /// Empty when all its pixels are the same.
  const std::vector<PixelClass>& row(int y) const { return rows_[static_cast<std::size_t>(y)]; }
  /// All the same at first.
  std::vector<PixelClass>& make_row(int y) {
    std::vector<PixelClass>& row = rows_[static_cast<std::size_t>(y)];
    row.resize(static_cast<std::size_t>(width_px_));
    return row;
  }
  PixelClass at(int x, int y) const { return row(y).empty() ? PixelClass::same : row(y)[static_cast<std::size_t>(x)]; }

 private:
  int width_px_ = 0;
  std::vector<std::vector<PixelClass>> rows_;
};

/// The window that holds most different pixels.
struct DensestWindow {
  PixelRect rect;
  std::int64_t different = 0;
};

struct DifferenceCounts {
  bool same_size = true;     ///< when false, all else is 0
  std::int64_t total = 0;    ///< pixels compared: those of the picture without the ignored ones
  std::int64_t unequal = 0;  ///< pixels with any byte that differs
  std::int64_t different = 0;
  std::int64_t antialiased = 0;
  std::int64_t shifted = 0;
  int max_channel = 0;                 ///< the largest difference of one channel, 0..255, alpha included
  std::array<double, 3> mean_bias{};   ///< of red, green and blue: B - A, averaged over the compared pixels
  std::array<double, 3> quiet_bias{};  ///< the same without what antialiased and shifted pixels contribute
  DensestWindow densest;
};

struct Difference {
  DifferenceCounts counts;
  DifferenceMap map;
};

/// Compares what `settings` ask for. Counts with shift_px = 0 are those of pixelmatch 7. Throws UsageError when the
/// region's mask does not fit the pictures.
Difference difference_between(const Image& a, const Image& b, const DifferenceSettings& settings);

/// How much may differ before two pictures count as different. A number of pixels alone would be blind to few that
/// matter and to a faint tint of all.
struct DifferenceLimits {
  std::int64_t different = 0;          ///< pixels
  std::optional<std::int64_t> window;  ///< pixels in the densest window
  double bias = 2;                     ///< of any channel, of 255
};

/// Which limit does not hold, as a sentence; empty when all do.
std::string broken_limit(const DifferenceCounts& counts, const DifferenceLimits& limits);

}  // namespace proofreel
