#include "render/pixel_convert.h"

#include <cassert>

#include "render/vectorised.h"

namespace proofreel {
namespace {

// BT.709: Y = 0.2126 R + 0.7152 G + 0.0722 B, Cb = (B - Y) / 1.8556, Cr = (R - Y) / 1.5748; scaled to limited range and
// by 2^16. Each row of colour factors adds up to exactly 0, so that gray stays gray; the luma factors add up to
// 219 / 255, so that white is exactly 235.
constexpr std::uint32_t y_red = 11966, y_green = 40254, y_blue = 4064;
constexpr std::int32_t u_red = -6596, u_green = -22189, u_blue = 28785;
constexpr std::int32_t v_red = 28784, v_green = -26145, v_blue = -2639;
constexpr std::uint32_t y_offset = (16U << 16U) + (1U << 15U);
constexpr std::int32_t uv_offset = (128 << 18) + (1 << 17);  // sums of four pixels: two bits more

PROOFREEL_VECTORISED
void convert_luma_row(const std::uint8_t* __restrict rgba, std::uint8_t* __restrict y, int width) {
  for (int i = 0; i < width; ++i) {
    const std::uint32_t r = rgba[4 * i], g = rgba[4 * i + 1], b = rgba[4 * i + 2];
    y[i] = static_cast<std::uint8_t>((y_red * r + y_green * g + y_blue * b + y_offset) >> 16U);
  }
}

PROOFREEL_VECTORISED
void convert_color_row(const std::uint8_t* __restrict upper, const std::uint8_t* __restrict lower,
                       std::uint8_t* __restrict u, std::uint8_t* __restrict v, int width) {
  for (int i = 0; i < width; ++i) {
    const int k = 8 * i;
    const std::int32_t r = upper[k] + upper[k + 4] + lower[k] + lower[k + 4];
    const std::int32_t g = upper[k + 1] + upper[k + 5] + lower[k + 1] + lower[k + 5];
    const std::int32_t b = upper[k + 2] + upper[k + 6] + lower[k + 2] + lower[k + 6];
    u[i] = static_cast<std::uint8_t>((u_red * r + u_green * g + u_blue * b + uv_offset) >> 18);
    v[i] = static_cast<std::uint8_t>((v_red * r + v_green * g + v_blue * b + uv_offset) >> 18);
  }
}

}  // namespace

void convert_to_yuv420(const Image& image, const Yuv420& out) {
  convert_to_yuv420(image, {0, 0, image.width_px, image.height_px}, out);
}

void convert_to_yuv420(const Image& image, const PixelRect& area, const Yuv420& out) {
  assert(area.x_px % 2 == 0 && area.y_px % 2 == 0 && area.width_px % 2 == 0 && area.height_px % 2 == 0);
  for (int row = area.y_px; row < area.y_px + area.height_px; row += 2) {
    const std::uint8_t* upper = image.row(row) + 4 * area.x_px;
    const std::uint8_t* lower = upper + image.row_bytes();
    std::uint8_t* y = out.y + static_cast<std::ptrdiff_t>(row) * out.y_stride + area.x_px;
    const std::ptrdiff_t color = static_cast<std::ptrdiff_t>(row / 2) * out.uv_stride + area.x_px / 2;
    convert_luma_row(upper, y, area.width_px);
    convert_luma_row(lower, y + out.y_stride, area.width_px);
    convert_color_row(upper, lower, out.u + color, out.v + color, area.width_px / 2);
  }
}

}  // namespace proofreel
