#include "golden/yiq.h"

#include <algorithm>
#include <array>
#include <catch2/catch.hpp>

#include "tests/render/test_image.h"

namespace proofreel {
namespace {

using Pixel = std::array<std::uint8_t, 4>;

double distance(const Pixel& a, const Pixel& b, std::int64_t index = 0) {
  return yiq_distance(a.data(), b.data(), index);
}

/// White on the left, black from column 4 on, and a column of `gray` between.
Image edge(std::uint8_t gray) {
  Image image = filled_image(8, 8, 255, 255, 255);
  for (int y = 0; y < 8; ++y) {
    for (int x = 3; x < 8; ++x) {
      for (int channel = 0; channel < 3; ++channel) image.row(y)[4 * x + channel] = x == 3 ? gray : 0;
    }
  }
  return image;
}

bool antialiased(const Image& image, const Image& other, int x, int y) {
  FlatRows flat(image, other);
  flat.move_to(y);
  return is_antialiased(image, flat, x, y);
}

TEST_CASE("Equal colours have no distance, black and white nearly all there is", "[yiq]") {
  REQUIRE(distance({1, 2, 3, 255}, {1, 2, 3, 255}) == 0);
  // Brightness alone: 0.5053 * 255^2; the other two axes are 0 for grays.
  REQUIRE(distance({0, 0, 0, 255}, {255, 255, 255, 255}) == Approx(0.5053 * 65025).epsilon(1e-7));
  REQUIRE(distance({0, 0, 0, 255}, {255, 255, 255, 255}) < largest_yiq_distance);
}

TEST_CASE("One channel weighs as its three axes do", "[yiq]") {
  // Red by 10: y = 2.9889531, i = 5.9597799, q = 2.1147017.
  REQUIRE(distance({110, 0, 0, 255}, {100, 0, 0, 255}) == Approx(4.514270 + 10.620174 + 0.875163).epsilon(1e-6));
  // Green by 10: y = 5.8662247, i = -2.7417610, q = -5.2261711.
  REQUIRE(distance({0, 110, 0, 255}, {0, 100, 0, 255}) == Approx(17.388683 + 2.247659 + 5.345127).epsilon(1e-6));
}

TEST_CASE("A distance is the same both ways", "[yiq]") {
  const Image noise = noise_image(64, 1, 3, false);
  for (int x = 0; x + 1 < 64; ++x) {
    const std::uint8_t *a = noise.row(0) + 4 * x, *b = a + 4;
    REQUIRE(yiq_distance(a, b, x) == yiq_distance(b, a, x));
  }
}

TEST_CASE("What is fully transparent in both cannot be seen to differ", "[yiq]") {
  REQUIRE(distance({255, 0, 0, 0}, {0, 255, 0, 0}, 17) == 0);
}

TEST_CASE("No opaque colour equals transparency wherever it lies", "[yiq]") {
  for (const Pixel& color : {Pixel{255, 255, 255, 255}, Pixel{0, 0, 0, 255}, Pixel{48, 48, 48, 255}}) {
    int visible = 0;
    for (std::int64_t index = 0; index < 16; ++index) visible += distance(color, {0, 0, 0, 0}, index) > 100 ? 1 : 0;
    REQUIRE(visible > 0);
  }
}

TEST_CASE("The gray column of a smoothed edge is anti-aliasing, whatever its gray", "[yiq]") {
  const Image a = edge(128), b = edge(200);
  for (int y = 0; y < 8; ++y) {
    REQUIRE(antialiased(a, b, 3, y));
    REQUIRE(antialiased(b, a, 3, y));
    REQUIRE_FALSE(antialiased(a, b, 4, y));
    REQUIRE_FALSE(antialiased(a, b, 1, y));
  }
}

TEST_CASE("An edge in one picture only is not anti-aliasing", "[yiq]") {
  const Image noise = noise_image(8, 8, 5, true);
  for (int y = 0; y < 8; ++y) REQUIRE_FALSE(antialiased(edge(128), noise, 3, y));
}

TEST_CASE("A lone pixel on a flat ground is not anti-aliasing", "[yiq]") {
  Image image = filled_image(5, 5, 255, 255, 255);
  image.row(2)[8] = 0;
  REQUIRE_FALSE(antialiased(image, image, 2, 2));
}

TEST_CASE("Pictures of one pixel, one row and one column have no anti-aliasing", "[yiq]") {
  for (const auto& [width, height] : {std::pair{1, 1}, {9, 1}, {1, 9}}) {
    const Image image = noise_image(width, height, 1, true);
    for (int y = 0; y < height; ++y) {
      for (int x = 0; x < width; ++x) REQUIRE_FALSE(antialiased(image, image, x, y));
    }
  }
}

/// Flatness by looking at every neighbour.
bool counted_flat(const Image& image, int x, int y) {
  const auto at = [&image](int u, int v) { return image.row(v)[4 * u]; };
  int equal = x == 0 || y == 0 || x == image.width_px - 1 || y == image.height_px - 1 ? 1 : 0;
  for (int v = std::max(0, y - 1); v <= std::min(image.height_px - 1, y + 1); ++v) {
    for (int u = std::max(0, x - 1); u <= std::min(image.width_px - 1, x + 1); ++u) {
      equal += (u != x || v != y) && at(u, v) == at(x, y) ? 1 : 0;
    }
  }
  return equal > 2;
}

/// Two colours at random, which differ in red, so that many areas are flat and many are not.
Image speckled(int width, int height, unsigned seed) {
  Image image = filled_image(width, height, 9, 9, 9);
  std::mt19937 random(seed);
  for (std::size_t i = 0; i < image.rgba.size(); i += 4) image.rgba[i] = random() % 3 == 0 ? 200 : 10;
  return image;
}

TEST_CASE("Flat areas are where counting neighbours finds them, in whatever order rows are asked for", "[yiq]") {
  for (const auto& [width, height] : {std::pair{1, 1}, {2, 2}, {1, 7}, {7, 1}, {3, 3}, {41, 23}}) {
    const Image a = speckled(width, height, 1), b = speckled(width, height, 2);
    FlatRows flat(a, b);
    for (int i = 0; i < 2 * height; ++i) {
      const int y = i < height ? i : i * 5 % height;
      flat.move_to(y);
      for (int x = 0; x < width; ++x) {
        bool near = false;
        for (int v = std::max(0, y - 1); v <= std::min(height - 1, y + 1); ++v) {
          CAPTURE(width, height, x, v);
          REQUIRE(flat.is_flat(x, v) == (counted_flat(a, x, v) && counted_flat(b, x, v)));
          for (int u = std::max(0, x - 1); u <= std::min(width - 1, x + 1); ++u) near = near || flat.is_flat(u, v);
        }
        REQUIRE(flat.has_flat_neighbour(x) == near);
      }
    }
  }
}

}  // namespace
}  // namespace proofreel
