#pragma once

#include <optional>
#include <span>
#include <vector>

#include "render/image.h"

namespace proofreel {

/// Which pixels are compared: all, but for what is ignored.
class Region {
 public:
  /// Leaves a rectangle out; what of it lies outside the picture does not matter.
  void ignore(const PixelRect& rect) { ignored_.push_back(rect); }
  /// Leaves out all pixels that are black or fully transparent in `mask`. Pictures must then have its size.
  void keep_only(Image mask) { mask_ = std::move(mask); }

  bool has_room_for(int width_px, int height_px) const {
    return !mask_ || (mask_->width_px == width_px && mask_->height_px == height_px);
  }
  const std::optional<Image>& mask() const { return mask_; }
  bool is_everything() const { return ignored_.empty() && !mask_; }
  /// Sets to 1 what is ignored in row `y`, to 0 the rest; returns how many are ignored.
  int ignored_in_row(int y, std::span<std::uint8_t> ignored) const;

 private:
  std::vector<PixelRect> ignored_;
  std::optional<Image> mask_;
};

}  // namespace proofreel
