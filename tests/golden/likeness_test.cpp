#include "golden/likeness.h"

#include <catch2/catch.hpp>

namespace proofreel {
namespace {

/// Grey of no regular kind.
Image texture() {
  Image image(32, 24);
  std::uint32_t seed = 7;
  for (std::uint8_t& byte : image.rgba)
    byte = static_cast<std::uint8_t>(40 + ((seed = seed * 1664525U + 1013904223U) >> 25U));
  return image;
}

Image moved(const Image& image, int dx, int dy) {
  Image result = image;
  for (int y = 0; y < image.height_px; ++y) {
    for (int x = 0; x < image.width_px; ++x) {
      const int u = std::clamp(x - dx, 0, image.width_px - 1), v = std::clamp(y - dy, 0, image.height_px - 1);
      std::copy_n(image.row(v) + 4 * u, 4, result.row(y) + 4 * x);
    }
  }
  return result;
}

TEST_CASE("A picture moved by up to three pixels either way is recognised", "[likeness]") {
  CHECK(likeness(texture(), moved(texture(), 1, 0)) == "It is the reference moved 1 px right.");
  CHECK(likeness(texture(), moved(texture(), -3, 0)) == "It is the reference moved 3 px left.");
  CHECK(likeness(texture(), moved(texture(), 0, -1)) == "It is the reference moved 1 px up.");
  CHECK(likeness(texture(), moved(texture(), -2, 2)) == "It is the reference moved 2 px left and 2 px down.");
  CHECK(likeness(texture(), moved(texture(), 4, 0)).empty());
}

TEST_CASE("A tint of the whole picture, and an equal difference of some pixels, are recognised", "[likeness]") {
  Image tinted = texture();
  for (std::size_t i = 0; i < tinted.rgba.size(); i += 4)
    tinted.rgba[i] = static_cast<std::uint8_t>(tinted.rgba[i] + 5);
  CHECK(likeness(texture(), tinted) == "The whole picture is tinted: red +5, green 0, blue 0 of 255.");
  Image partly = texture();
  for (int x = 5; x < 12; ++x) --partly.row(9)[4 * x + 2];
  CHECK(likeness(texture(), partly) == "All of them differ by the same: red 0, green 0, blue -1 of 255.");
}

TEST_CASE("Equal pictures and those that differ anyhow are like nothing", "[likeness]") {
  CHECK(likeness(texture(), texture()).empty());
  Image anyhow = texture();
  anyhow.row(9)[40] = 3;
  anyhow.row(12)[41] = 9;
  CHECK(likeness(texture(), anyhow).empty());
}

TEST_CASE("A plain picture with a spot at its edge was not moved", "[likeness]") {
  const Image plain(32, 24);
  Image spotted(32, 24);
  spotted.row(10)[0] = 200;
  spotted.row(11)[1] = 100;
  CHECK(likeness(plain, spotted).empty());
}

}  // namespace
}  // namespace proofreel
