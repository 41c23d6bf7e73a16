#include "golden/flat_rows.h"

#include <algorithm>

#include "golden/packed_pixel.h"
#include "render/vectorised.h"

namespace proofreel {
namespace {

/// Three neighbours of the pixel in one row that have its colour.
inline std::uint32_t equal_in_row(const std::uint8_t* row, std::uint32_t color) {
  return (packed_pixel(row - 4) == color ? 1U : 0U) + (packed_pixel(row) == color ? 1U : 0U) +
         (packed_pixel(row + 4) == color ? 1U : 0U);
}

/// For pixels with neighbours on all sides: clears the flags of those that are not flat in this picture.
PROOFREEL_VECTORISED
void keep_flat(const std::uint8_t* above, const std::uint8_t* middle, const std::uint8_t* below, int count,
               std::uint8_t* flags) {
  for (int i = 0; i < count; ++i) {
    const std::uint32_t color = packed_pixel(middle + 4 * i);
    const std::uint32_t equal = equal_in_row(above + 4 * i, color) + equal_in_row(middle + 4 * i, color) - 1U +
                                equal_in_row(below + 4 * i, color);
    flags[i] = static_cast<std::uint8_t>(flags[i] & (equal > 2 ? 1U : 0U));
  }
}

/// The same for one pixel at the border.
bool is_flat_at_border(const Image& image, int x, int y) {
  const auto at = [&image](int u, int v) { return packed_pixel(image.row(v) + 4 * static_cast<std::size_t>(u)); };
  int equal = 1;
  for (int v = std::max(y - 1, 0); v <= std::min(y + 1, image.height_px - 1); ++v) {
    for (int u = std::max(x - 1, 0); u <= std::min(x + 1, image.width_px - 1); ++u) {
      equal += (u != x || v != y) && at(u, v) == at(x, y) ? 1 : 0;
    }
  }
  return equal > 2;
}

PROOFREEL_VECTORISED
void add_flags(const std::uint8_t* __restrict from, std::uint8_t* __restrict to, int count) {
  for (int i = 0; i < count; ++i) to[i] = static_cast<std::uint8_t>(to[i] | from[i]);
}

}  // namespace

FlatRows::FlatRows(const Image& a, const Image& b) : a_(a), b_(b), near_(static_cast<std::size_t>(a.width_px)) {
  for (Row& row : rows_) row.resize(near_.size());
}

void FlatRows::compute(int y) {
  Row& flags = rows_[static_cast<std::size_t>(y % 3)];
  std::fill(flags.begin(), flags.end(), std::uint8_t{1});
  known_[static_cast<std::size_t>(y % 3)] = y;
  const int width = a_.width_px, last = width - 1;
  const bool whole = y > 0 && y + 1 < a_.height_px && width > 2;
  for (const Image* image : {&a_, &b_}) {
    if (whole) {
      keep_flat(image->row(y - 1) + 4, image->row(y) + 4, image->row(y + 1) + 4, width - 2, flags.data() + 1);
    }
    for (int x = 0; x < width; x += whole ? last : 1) {
      if (!is_flat_at_border(*image, x, y)) flags[static_cast<std::size_t>(x)] = 0;
    }
  }
}

void FlatRows::move_to(int y) {
  if (y == middle_) return;
  middle_ = y;
  std::fill(near_.begin(), near_.end(), std::uint8_t{0});
  const int width = a_.width_px;
  for (int v = std::max(0, y - 1); v <= std::min(y + 1, a_.height_px - 1); ++v) {
    if (known_[static_cast<std::size_t>(v % 3)] != v) compute(v);
    const std::uint8_t* flags = row(v).data();
    add_flags(flags, near_.data(), width);
    add_flags(flags + 1, near_.data(), width - 1);
    add_flags(flags, near_.data() + 1, width - 1);
  }
}

}  // namespace proofreel
