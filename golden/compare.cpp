#include "golden/compare.h"

#include <algorithm>
#include <cstdlib>
#include <cstring>

#include "golden/compare_rows.h"

namespace proofreel {
namespace {

int largest_difference(const std::uint8_t* a, const std::uint8_t* b) {
  int largest = 0;
  for (int channel = 0; channel < 4; ++channel) largest = std::max(largest, std::abs(a[channel] - b[channel]));
  return largest;
}

/// The first pixel of a row that differs by as much as any does.
int find_difference(const std::uint8_t* a, const std::uint8_t* b, int difference) {
  int x = 0;
  while (largest_difference(a + 4 * x, b + 4 * x) != difference) ++x;
  return x;
}

}  // namespace

Comparison compare(const Image& a, const Image& b, int allowed) {
  Comparison result;
  result.same_size = a.width_px == b.width_px && a.height_px == b.height_px;
  if (!result.same_size) return result;
  result.total = static_cast<std::int64_t>(a.width_px) * a.height_px;
  for (int y = 0; y < a.height_px; ++y) {
    if (std::memcmp(a.row(y), b.row(y), a.row_bytes()) == 0) continue;
    const RowSums row = sums_of_row(a.row(y), b.row(y), a.width_px, allowed);
    result.different += row.different;
    result.beyond += row.beyond;
    if (row.max_channel <= result.max_channel) continue;
    result.max_channel = row.max_channel;
    result.worst_x_px = find_difference(a.row(y), b.row(y), row.max_channel);
    result.worst_y_px = y;
  }
  return result;
}

}  // namespace proofreel
