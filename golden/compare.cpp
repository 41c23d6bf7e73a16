#include "golden/compare.h"

#include <algorithm>
#include <cstdlib>
#include <cstring>

namespace proofreel {
namespace {

int largest_difference(const std::uint8_t* a, const std::uint8_t* b) {
  int largest = 0;
  for (int channel = 0; channel < 4; ++channel) largest = std::max(largest, std::abs(a[channel] - b[channel]));
  return largest;
}

}  // namespace

Comparison compare(const Image& a, const Image& b, int allowed) {
  Comparison result;
  result.same_size = a.width_px == b.width_px && a.height_px == b.height_px;
  if (!result.same_size) return result;
  result.total = static_cast<std::int64_t>(a.width_px) * a.height_px;
  for (std::int64_t pixel = 0; pixel < result.total; ++pixel) {
    const auto byte = static_cast<std::size_t>(pixel) * 4;
    const int difference = largest_difference(&a.rgba[byte], &b.rgba[byte]);
    if (difference == 0) continue;
    ++result.different;
    if (difference > allowed) ++result.beyond;
    if (difference <= result.max_channel) continue;
    result.max_channel = difference;
    result.worst_x_px = static_cast<int>(pixel % a.width_px);
    result.worst_y_px = static_cast<int>(pixel / a.width_px);
  }
  return result;
}

}  // namespace proofreel
