#include "render/pixel_convert.h"

#include <catch2/catch.hpp>
#include <cmath>
#include <cstdlib>

#include "tests/render/test_image.h"

extern "C" {
#include <libswscale/swscale.h>
}

namespace proofreel {
namespace {

struct Planes {
  explicit Planes(const Image& image)
      : width(image.width_px),
        y(static_cast<std::size_t>(image.width_px) * static_cast<std::size_t>(image.height_px)),
        u(y.size() / 4),
        v(y.size() / 4) {}
  Yuv420 view() { return {y.data(), u.data(), v.data(), width, width / 2}; }

  int width;
  std::vector<std::uint8_t> y, u, v;
};

Planes ours(const Image& image) {
  Planes planes(image);
  convert_to_yuv420(image, planes.view());
  return planes;
}

/// libswscale, told to be as exact as it can and to average colour over 2 x 2 pixels.
Planes theirs(const Image& image) {
  Planes planes(image);
  SwsContext* context = sws_getContext(
      image.width_px, image.height_px, AV_PIX_FMT_RGBA, image.width_px, image.height_px, AV_PIX_FMT_YUV420P,
      SWS_AREA | SWS_ACCURATE_RND | SWS_FULL_CHR_H_INP | SWS_BITEXACT, nullptr, nullptr, nullptr);
  REQUIRE(context != nullptr);
  const int* bt709 = sws_getCoefficients(SWS_CS_ITU709);
  sws_setColorspaceDetails(context, bt709, 1, bt709, 0, 0, 1 << 16, 1 << 16);
  const std::uint8_t* const from[] = {image.rgba.data()};
  const int from_stride[] = {image.width_px * 4};
  std::uint8_t* const to[] = {planes.y.data(), planes.u.data(), planes.v.data()};
  const int to_stride[] = {planes.width, planes.width / 2, planes.width / 2};
  sws_scale(context, from, from_stride, 0, image.height_px, to, to_stride);
  sws_freeContext(context);
  return planes;
}

int largest_difference(const std::vector<std::uint8_t>& a, const std::vector<std::uint8_t>& b) {
  int largest = 0;
  for (std::size_t i = 0; i < a.size(); ++i) largest = std::max(largest, std::abs(a[i] - b[i]));
  return largest;
}

void require_one_color(const Image& image, int y, int u, int v) {
  const Planes planes = ours(image);
  CAPTURE(int(planes.y.front()), int(planes.u.front()), int(planes.v.front()));
  REQUIRE(planes.y == std::vector<std::uint8_t>(planes.y.size(), static_cast<std::uint8_t>(y)));
  REQUIRE(planes.u == std::vector<std::uint8_t>(planes.u.size(), static_cast<std::uint8_t>(u)));
  REQUIRE(planes.v == std::vector<std::uint8_t>(planes.v.size(), static_cast<std::uint8_t>(v)));
}

TEST_CASE("Conversion agrees with libswscale to 1 on noise and on film-like pictures", "[convert]") {
  for (const Image& image :
       {noise_image(640, 360, 3, true), noise_image(1280, 32, 5, true), filled_image(64, 64, 0, 136, 0)}) {
    const Planes a = ours(image), b = theirs(image);
    REQUIRE(largest_difference(a.y, b.y) <= 1);
    REQUIRE(largest_difference(a.u, b.u) <= 1);
    REQUIRE(largest_difference(a.v, b.v) <= 1);
  }
}

/// How far our value is from the exact one, for a block of 1 x 1 (luma) or 2 x 2 pixels (colour).
double error_at(const Image& image, int x, int y, int side, int value, char plane) {
  double rgb[3] = {};
  for (int k = 0; k < side * side; ++k) {
    const int pixel = (y * side + k / side) * image.width_px + x * side + k % side;
    for (std::size_t c = 0; c < 3; ++c) {
      rgb[c] += image.rgba[static_cast<std::size_t>(pixel) * 4 + c] / static_cast<double>(side * side);
    }
  }
  const double luma = 0.2126 * rgb[0] + 0.7152 * rgb[1] + 0.0722 * rgb[2];
  if (plane == 'y') return std::fabs(16 + luma * 219 / 255 - value);
  const double difference = plane == 'u' ? (rgb[2] - luma) / 1.8556 : (rgb[0] - luma) / 1.5748;
  return std::fabs(128 + difference * 224 / 255 - value);
}

TEST_CASE("Every value is the nearest to what BT.709 says, at any even size", "[convert]") {
  for (const auto& [width, height] : {std::pair{2, 2}, {6, 4}, {1922, 34}}) {
    const Image image = noise_image(width, height, 8, true);
    const Planes planes = ours(image);
    double worst = 0;
    for (int i = 0; i < width * height; ++i) {
      worst = std::max(worst, error_at(image, i % width, i / width, 1, planes.y[static_cast<std::size_t>(i)], 'y'));
    }
    for (int i = 0; i < width * height / 4; ++i) {
      const int x = i % (width / 2), y = i / (width / 2);
      worst = std::max(worst, error_at(image, x, y, 2, planes.u[static_cast<std::size_t>(i)], 'u'));
      worst = std::max(worst, error_at(image, x, y, 2, planes.v[static_cast<std::size_t>(i)], 'v'));
    }
    REQUIRE(worst < 0.51);
  }
}

TEST_CASE("Black, white and all grays have no colour and span the limited range", "[convert]") {
  require_one_color(filled_image(34, 6, 0, 0, 0), 16, 128, 128);
  require_one_color(filled_image(34, 6, 255, 255, 255), 235, 128, 128);
  for (int gray = 0; gray < 256; ++gray) {
    const auto g = static_cast<std::uint8_t>(gray);
    require_one_color(filled_image(4, 2, g, g, g), (16 * 255 + 219 * gray + 127) / 255, 128, 128);
  }
}

TEST_CASE("The primaries have the values BT.709 gives them", "[convert]") {
  require_one_color(filled_image(4, 2, 255, 0, 0), 63, 102, 240);
  require_one_color(filled_image(4, 2, 0, 255, 0), 173, 42, 26);
  require_one_color(filled_image(4, 2, 0, 0, 255), 32, 240, 118);
}

TEST_CASE("A part of a picture is converted as in the whole, and nothing beside it is touched", "[convert]") {
  const Image before = noise_image(66, 34, 11, true), after = noise_image(66, 34, 12, true);
  const Planes whole = ours(after), old = ours(before);
  for (const PixelRect& area : {PixelRect{0, 0, 66, 34}, {16, 2, 32, 16}, {64, 32, 2, 2}, {0, 10, 18, 24}}) {
    Planes planes = old;
    convert_to_yuv420(after, area, planes.view());
    const auto is_inside = [&area](int x, int y) {
      return x >= area.x_px && x < area.x_px + area.width_px && y >= area.y_px && y < area.y_px + area.height_px;
    };
    int wrong = 0;
    for (int i = 0; i < 66 * 34; ++i) {
      const auto at = static_cast<std::size_t>(i);
      wrong += planes.y[at] != (is_inside(i % 66, i / 66) ? whole : old).y[at] ? 1 : 0;
    }
    for (int i = 0; i < 33 * 17; ++i) {
      const auto at = static_cast<std::size_t>(i);
      const Planes& from = is_inside(2 * (i % 33), 2 * (i / 33)) ? whole : old;
      wrong += planes.u[at] != from.u[at] || planes.v[at] != from.v[at] ? 1 : 0;
    }
    CHECK(wrong == 0);
  }
}

TEST_CASE("Alpha changes nothing", "[convert]") {
  Image image = noise_image(32, 32, 6, true);
  const Planes opaque = ours(image);
  for (std::size_t i = 3; i < image.rgba.size(); i += 4) image.rgba[i] = 0;
  REQUIRE(ours(image).y == opaque.y);
  REQUIRE(ours(image).u == opaque.u);
}

TEST_CASE("Rows wider than the picture are left alone beyond it", "[convert]") {
  const Image image = noise_image(6, 2, 7, true);
  std::vector<std::uint8_t> y(64, 99), u(32, 99), v(32, 99);
  convert_to_yuv420(image, {y.data(), u.data(), v.data(), 32, 16});
  REQUIRE(y[6] == 99);
  REQUIRE(y[31] == 99);
  REQUIRE(y[32 + 6] == 99);
  REQUIRE(u[3] == 99);
  REQUIRE(v[3] == 99);
}

}  // namespace
}  // namespace proofreel
