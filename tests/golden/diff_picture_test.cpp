#include "golden/diff_picture.h"

#include <catch2/catch.hpp>

#include "render/usage_error.h"
#include "tests/render/test_image.h"

namespace proofreel {
namespace {

Color pixel(const Image& image, int x, int y) {
  const std::uint8_t* p = image.row(y) + 4 * x;
  return {p[0], p[1], p[2], p[3]};
}

int brightness(Color c) { return c.r + c.g + c.b; }

/// Expected is light gray; the actual one has a black, a white and a hardly darker pixel.
struct Example {
  Image expected = filled_image(200, 40, 200, 200, 200);
  Image actual = expected;
  Difference difference;
  Example() {
    for (int channel = 0; channel < 3; ++channel) {
      actual.row(10)[4 * 20 + channel] = 0;
      actual.row(10)[4 * 30 + channel] = 255;
      actual.row(10)[4 * 40 + channel] = 199;
    }
    difference = difference_between(expected, actual, {});
  }
  Image draw(DiffStyle style, const Region& region = {}) const {
    return diff_picture(style, {expected, actual, difference}, region, {"expected", "actual", "difference"});
  }
};

TEST_CASE("An overlay tells different from similar pixels, and both from the rest", "[diff picture]") {
  const Image overlay = Example().draw(DiffStyle::overlay);
  REQUIRE((overlay.width_px == 200 && overlay.height_px == 40));
  const Color different = pixel(overlay, 20, 10), similar = pixel(overlay, 40, 10), same = pixel(overlay, 100, 10);
  REQUIRE(pixel(overlay, 30, 10) == different);
  REQUIRE_FALSE(different == similar);
  REQUIRE((same.r == same.g && same.g == same.b && same.r > 200));
  REQUIRE(different.r > different.g + 100);
}

TEST_CASE("Heat grows lighter with the difference, and every changed pixel shows", "[diff picture]") {
  const Image heat = Example().draw(DiffStyle::heat);
  const int ground = brightness(pixel(heat, 100, 10));
  REQUIRE(brightness(pixel(heat, 40, 10)) > ground);
  REQUIRE(brightness(pixel(heat, 30, 10)) > brightness(pixel(heat, 40, 10)));
  REQUIRE(brightness(pixel(heat, 20, 10)) > brightness(pixel(heat, 30, 10)));
}

TEST_CASE("A mask is transparent but for different pixels", "[diff picture]") {
  const Image mask = Example().draw(DiffStyle::mask);
  REQUIRE(pixel(mask, 20, 10).a == 255);
  REQUIRE(pixel(mask, 40, 10) == Color{0, 0, 0, 0});
  REQUIRE(pixel(mask, 0, 0) == Color{0, 0, 0, 0});
}

TEST_CASE("Side by side stand both pictures untouched, then the heat, in an even size", "[diff picture]") {
  const Example example;
  const Image side = example.draw(DiffStyle::side), heat = example.draw(DiffStyle::heat);
  const PictureSize size = diff_picture_size(DiffStyle::side, example.expected, example.actual);
  REQUIRE((side.width_px == size.width_px && side.height_px == size.height_px));
  REQUIRE((side.width_px == 608 && side.height_px == 68));
  REQUIRE(pixel(side, 20, 28 + 10) == pixel(example.expected, 20, 10));
  REQUIRE(pixel(side, 204 + 20, 28 + 10) == pixel(example.actual, 20, 10));
  REQUIRE(pixel(side, 408 + 20, 28 + 10) == pixel(heat, 20, 10));
}

TEST_CASE("Titles stand above the panels, and never beyond their panel", "[diff picture]") {
  const Example example;
  const auto titled = [&](const std::string& title) {
    return diff_picture(DiffStyle::side, {example.expected, example.actual, example.difference}, {}, {title, "", ""});
  };
  const Image none = titled(""), some = titled("expected"), endless = titled(std::string(300, 'W'));
  REQUIRE(none.rgba != some.rgba);
  for (int y = 0; y < endless.height_px; ++y) {
    for (int x = 200; x < endless.width_px; ++x) REQUIRE(pixel(endless, x, y) == pixel(none, x, y));
  }
}

TEST_CASE("Pictures of other size are shown beside each other, whatever style is asked for", "[diff picture]") {
  const Image a = filled_image(30, 20, 1, 2, 3), b = filled_image(15, 41, 4, 5, 6);
  const Difference difference = difference_between(a, b, {});
  for (const DiffStyle style : {DiffStyle::side, DiffStyle::overlay, DiffStyle::mask}) {
    const Image image = diff_picture(style, {a, b, difference}, {}, {});
    REQUIRE((image.width_px == 50 && image.height_px == 42));
    REQUIRE(pixel(image, 0, 0) == Color{1, 2, 3, 255});
    REQUIRE(pixel(image, 34, 40) == Color{4, 5, 6, 255});
  }
}

TEST_CASE("What would be too large side by side is refused, and drawn in another style", "[diff picture]") {
  const Image a(16000, 2600);
  const Difference difference = difference_between(a, a, {});
  REQUIRE_THROWS_AS(diff_picture(DiffStyle::side, {a, a, difference}, {}, {}), UsageError);
  REQUIRE(diff_picture(DiffStyle::mask, {a, a, difference}, {}, {}).width_px == 16000);
}

TEST_CASE("What is ignored is hatched", "[diff picture]") {
  Region region;
  region.ignore({100, 0, 16, 16});
  const Example example;
  const Image plain = example.draw(DiffStyle::overlay), hatched = example.draw(DiffStyle::overlay, region);
  int changed = 0;
  for (int y = 0; y < 40; ++y) {
    for (int x = 0; x < 200; ++x) {
      if (pixel(plain, x, y) == pixel(hatched, x, y)) continue;
      ++changed;
      REQUIRE((x >= 100 && x < 116 && y < 16));
    }
  }
  REQUIRE(changed == 64);  // a quarter
}

TEST_CASE("A timeline shows frames with one different pixel, and where one is", "[diff picture]") {
  const Image picture = filled_image(200, 40, 9, 9, 9);
  const std::vector<double> shares{0, 1e-6, 0.5, 1};
  const Image first = with_timeline(picture, shares, 0), last = with_timeline(picture, shares, 3);
  REQUIRE(first.height_px > 40);
  REQUIRE(first.height_px % 2 == 0);
  REQUIRE(first.rgba != last.rgba);
  const auto height = [&](int x) {
    int pixels = 0;
    for (int y = 40; y < first.height_px; ++y) pixels += brightness(pixel(first, x, y)) > 300 ? 1 : 0;
    return pixels;
  };
  REQUIRE(height(30) <= 1);  // the ground line alone
  REQUIRE(height(75) > height(30));
  REQUIRE(height(120) > height(75));
  REQUIRE(height(170) > height(120));
}

}  // namespace
}  // namespace proofreel
