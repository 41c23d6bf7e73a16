#pragma once

#include <cstdint>

#include "render/image.h"

namespace proofreel {

/// How two pictures differ. Channels count 0..255, alpha included.
struct Comparison {
  bool same_size = true;       ///< when false, all else is 0
  std::int64_t different = 0;  ///< pixels that are not equal
  std::int64_t beyond = 0;     ///< pixels with a channel that differs by more than was allowed
  std::int64_t total = 0;      ///< pixels compared
  int max_channel = 0;         ///< the largest difference of one channel
  int worst_x_px = 0;          ///< where that is, from the top left corner
  int worst_y_px = 0;
};

/// Compares pixel by pixel, allowing every channel to differ by `allowed`.
Comparison compare(const Image& a, const Image& b, int allowed);

}  // namespace proofreel
