#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace proofreel {

/// A picture: RGBA8, rows from the top, no padding. One buffer is drawn into, compared and encoded.
struct Image {
  int width_px = 0;
  int height_px = 0;
  std::vector<std::uint8_t> rgba;

  Image() = default;
  Image(int width, int height)
      : width_px(width),
        height_px(height),
        rgba(static_cast<std::size_t>(width) * static_cast<std::size_t>(height) * 4) {}
};

}  // namespace proofreel
