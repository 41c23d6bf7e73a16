#pragma once

#include <string_view>

#include "render/canvas.h"
#include "render/font.h"
#include "render/image.h"

namespace proofreel {

/// Where a line of letters goes, pixels.
struct LetterLine {
  int x_px = 0;
  int baseline_px = 0;
  int end_px = 0;  ///< where it stops, if not before at the picture's edge
};

/// Letters straight into an image, without OpenGL: for the titles of pictures that are put together from others.
class Lettering {
 public:
  /// `size_px` is the em.
  void write(Image& image, std::string_view utf8, int size_px, const LetterLine& line, Color color) const;

  /// How wide that line is, rounded up.
  int width_px(std::string_view utf8, int size_px) const;

 private:
  Font font_;
};

}  // namespace proofreel
