#pragma once

/// What differs between two pictures of one size, painted. For all there is for people see golden/diff_picture.h.

#include "golden/difference.h"
#include "render/color.h"

namespace proofreel {

/// Two pictures and what was found out about them.
struct Compared {
  const Image& expected;
  const Image& actual;
  const Difference& difference;
};

/// The styles of golden/diff_picture.h; `region` is what was compared.
Image overlay_picture(const Compared& c, const Region& region);
Image heat_picture(const Compared& c, const Region& region);
Image mask_picture(const Compared& c);

/// From violet to pale yellow, lighter all the way, so that it also reads in print.
Color heat_color(double part);

/// What of `rect` lies outside of the picture does not matter.
void fill_rect(Image& image, const PixelRect& rect, Color color);

}  // namespace proofreel
