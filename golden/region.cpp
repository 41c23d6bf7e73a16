#include "golden/region.h"

#include <algorithm>
#include <numeric>

namespace proofreel {
namespace {

void ignore_part(const PixelRect& rect, std::span<std::uint8_t> ignored) {
  const auto width = static_cast<std::int64_t>(ignored.size());
  const std::int64_t from = std::clamp<std::int64_t>(rect.x_px, 0, width);
  const std::int64_t to = std::clamp<std::int64_t>(std::int64_t{rect.x_px} + rect.width_px, from, width);
  std::fill(ignored.begin() + from, ignored.begin() + to, std::uint8_t{1});
}

bool is_in_row(const PixelRect& rect, int y) { return y >= rect.y_px && y < std::int64_t{rect.y_px} + rect.height_px; }

void ignore_dark(const std::uint8_t* mask, std::span<std::uint8_t> ignored) {
  for (std::uint8_t& pixel : ignored) {
    const bool dark = (mask[0] | mask[1] | mask[2]) == 0 || mask[3] == 0;
    pixel = dark ? 1 : 0;
    mask += 4;
  }
}

}  // namespace

int Region::ignored_in_row(int y, std::span<std::uint8_t> ignored) const {
  std::fill(ignored.begin(), ignored.end(), std::uint8_t{0});
  if (mask_) ignore_dark(mask_->row(y), ignored);
  for (const PixelRect& rect : ignored_) {
    if (is_in_row(rect, y)) ignore_part(rect, ignored);
  }
  return std::accumulate(ignored.begin(), ignored.end(), 0);
}

}  // namespace proofreel
