#pragma once

/// From RGB to what video encoders eat: luma and two colour differences after ITU-R BT.709, limited range
/// (Y 16..235, Cb and Cr 16..240), colour at half the resolution both ways (4:2:0).

#include <cstdint>

#include "render/image.h"

namespace proofreel {

/// Where the three planes of one picture lie. Strides in bytes.
struct Yuv420 {
  std::uint8_t* y = nullptr;
  std::uint8_t* u = nullptr;
  std::uint8_t* v = nullptr;
  int y_stride = 0;
  int uv_stride = 0;
};

/// Every colour sample is the mean of its 2 x 2 pixels, so it sits in their centre. Alpha is ignored. Width and height
/// must be even. Within 1 of libswscale's accurate conversion, at a fifth of its time.
void convert_to_yuv420(const Image& image, const Yuv420& out);
/// Only this part of the picture, whose edges must be even, too.
void convert_to_yuv420(const Image& image, const PixelRect& area, const Yuv420& out);

}  // namespace proofreel
