#pragma once

#include <string_view>

#include "render/canvas.h"
#include "render/font.h"
#include "render/image.h"

namespace proofreel {

/// Letters straight into an image, without OpenGL: for the titles of pictures that are put together from others.
class Lettering {
 public:
  /// One line that starts at `x_px` on the baseline `y_px` and stops before `end_px` or the picture's edge. The em is
  /// `size_px`.
  void write(Image& image, std::string_view utf8, int size_px, int x_px, int y_px, int end_px, Color color) const;

  /// How wide that line is, rounded up.
  int width_px(std::string_view utf8, int size_px) const;

 private:
  Font font_;
};

}  // namespace proofreel
