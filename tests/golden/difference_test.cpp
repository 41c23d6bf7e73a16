#include "golden/difference.h"

#include <catch2/catch.hpp>

#include "golden/densest.h"
#include "golden/yiq.h"
#include "render/usage_error.h"
#include "tests/render/test_image.h"

namespace proofreel {
namespace {

using Catch::Matchers::Contains;

Image white(int width, int height) { return filled_image(width, height, 255, 255, 255); }

void paint(Image& image, const PixelRect& rect, std::uint8_t gray) {
  for (int y = rect.y_px; y < rect.y_px + rect.height_px; ++y) {
    for (int x = rect.x_px; x < rect.x_px + rect.width_px; ++x) {
      for (int channel = 0; channel < 3; ++channel) image.row(y)[4 * x + channel] = gray;
    }
  }
}

/// A black rectangle on white.
Image rectangle(int width, int height, const PixelRect& rect) {
  Image image = white(width, height);
  paint(image, rect, 0);
  return image;
}

/// White, a column of `gray` at 10, black to the right of it.
Image edge(std::uint8_t gray) {
  Image image = rectangle(20, 20, {10, 0, 10, 20});
  paint(image, {10, 0, 1, 20}, gray);
  return image;
}

DifferenceCounts counts(const Image& a, const Image& b, const DifferenceSettings& settings = {}) {
  return difference_between(a, b, settings).counts;
}

TEST_CASE("A picture does not differ from itself at any threshold", "[difference]") {
  const Image image = noise_image(50, 40, 1, false);
  for (const double threshold : {0.0, 0.1, 1.0}) {
    DifferenceSettings settings;
    settings.threshold = threshold;
    const DifferenceCounts c = counts(image, image, settings);
    REQUIRE(c.total == 2000);
    REQUIRE((c.different == 0 && c.antialiased == 0 && c.unequal == 0 && c.max_channel == 0));
    REQUIRE(c.densest.different == 0);
  }
}

TEST_CASE("A block painted over differs in its pixels, and the densest window lies on it", "[difference]") {
  const Image a = white(100, 80);
  Image b = a;
  paint(b, {30, 20, 5, 4}, 0);
  b.row(70)[4 * 90] = 0;  // and one far away
  const DifferenceCounts c = counts(a, b);
  REQUIRE(c.different == 21);
  REQUIRE(c.unequal == 21);
  REQUIRE(c.max_channel == 255);
  REQUIRE(c.densest.different == 20);
  REQUIRE(c.densest.rect == PixelRect{19, 8, 16, 16});  // the first that holds all of it
  REQUIRE(c.mean_bias[0] == Approx(-255.0 * 21 / 8000));
  REQUIRE(c.mean_bias[1] == Approx(-255.0 * 20 / 8000));
}

TEST_CASE("What differs only as a smoothed edge is counted by itself", "[difference]") {
  DifferenceCounts c = counts(edge(128), edge(200));
  REQUIRE(c.different == 0);
  REQUIRE(c.antialiased == 20);
  REQUIRE(c.mean_bias[0] == Approx(72.0 * 20 / 400));
  REQUIRE(c.quiet_bias[0] == 0);
  REQUIRE(broken_limit(c, {}).empty());
  DifferenceSettings all;
  all.count_antialiased = true;
  c = counts(edge(128), edge(200), all);
  REQUIRE(c.different == 20);
  REQUIRE(c.antialiased == 0);
}

TEST_CASE("Every pixel beyond the threshold counts, and no other", "[difference]") {
  const Image a = noise_image(97, 31, 3, false);
  Image b = a;
  std::mt19937 random(4);
  for (std::uint8_t& byte : b.rgba) byte = static_cast<std::uint8_t>(byte ^ (random() % 5 == 0 ? random() & 63U : 0U));
  for (const double threshold : {0.0, 0.01, 0.03, 0.1, 0.3}) {
    std::int64_t expected = 0;
    for (int y = 0; y < 31; ++y) {
      for (int x = 0; x < 97; ++x) {
        const double distance = yiq_distance(a.row(y) + 4 * x, b.row(y) + 4 * x, y * 97 + x);
        expected += distance > largest_yiq_distance * threshold * threshold ? 1 : 0;
      }
    }
    DifferenceSettings settings;
    settings.threshold = threshold;
    settings.count_antialiased = true;
    REQUIRE(counts(a, b, settings).different == expected);
  }
}

TEST_CASE("However many threads compare, the answer is the same", "[difference]") {
  const Image a = noise_image(40, 333, 5, true), b = noise_image(40, 333, 6, true);
  DifferenceSettings settings;
  const Difference one = difference_between(a, b, settings);
  for (const int threads : {2, 3, 8}) {
    settings.threads = threads;
    const Difference many = difference_between(a, b, settings);
    REQUIRE(many.counts.different == one.counts.different);
    REQUIRE(many.counts.antialiased == one.counts.antialiased);
    REQUIRE(many.counts.mean_bias == one.counts.mean_bias);
    for (int y = 0; y < 333; ++y) REQUIRE(many.map.row(y) == one.map.row(y));
  }
}

TEST_CASE("Something moved by a pixel is forgiven when that is asked for, something gone is not", "[difference]") {
  const Image a = rectangle(20, 20, {5, 5, 6, 6}), moved = rectangle(20, 20, {6, 5, 6, 6}), gone = white(20, 20);
  REQUIRE(counts(a, moved).different == 12);
  DifferenceSettings shift;
  shift.shift_px = 1;
  REQUIRE(counts(a, moved, shift).different == 0);
  REQUIRE(counts(a, moved, shift).shifted == 12);
  REQUIRE(counts(a, gone, shift).different == 36);
  REQUIRE(counts(gone, a, shift).different == 36);
  // By two pixels: 24 differ, and the inner 4 of whose ends (two columns on each side) find their colours round the
  // corner.
  REQUIRE(counts(a, rectangle(20, 20, {7, 5, 6, 6}), shift).different == 20);
}

TEST_CASE("Rectangles and masks leave pixels out of every figure", "[difference]") {
  const Image a = white(30, 20);
  Image b = a;
  paint(b, {0, 0, 30, 20}, 0);
  DifferenceSettings settings;
  settings.region.ignore({-5, -5, 15, 10});  // 10 x 5 of it lie inside
  settings.region.ignore({20, 10, 1000, 1000});
  DifferenceCounts c = counts(a, b, settings);
  REQUIRE(c.total == 600 - 50 - 100);
  REQUIRE(c.different == c.total);
  REQUIRE(c.unequal == c.total);
  REQUIRE(c.mean_bias[2] == -255);
  Image mask = filled_image(30, 20, 0, 0, 0);
  paint(mask, {3, 4, 10, 2}, 1);
  mask.row(4)[4 * 3 + 3] = 0;  // transparent: out
  settings.region = {};
  settings.region.keep_only(mask);
  c = counts(a, b, settings);
  REQUIRE(c.total == 19);
  REQUIRE(c.different == 19);
}

TEST_CASE("Where everything is ignored, nothing differs", "[difference]") {
  DifferenceSettings settings;
  settings.region.ignore({0, 0, 10, 10});
  const DifferenceCounts c = counts(white(10, 10), filled_image(10, 10, 0, 0, 0), settings);
  REQUIRE(c.total == 0);
  REQUIRE(broken_limit(c, {}).empty());
}

TEST_CASE("A mask of another size is refused", "[difference]") {
  DifferenceSettings settings;
  settings.region.keep_only(white(9, 10));
  REQUIRE_THROWS_AS(counts(white(10, 10), white(10, 10), settings), UsageError);
}

TEST_CASE("Pictures of other size are not compared", "[difference]") {
  const DifferenceCounts c = counts(white(4, 2), white(2, 4));
  REQUIRE_FALSE(c.same_size);
  REQUIRE(c.total == 0);
  REQUIRE_THAT(broken_limit(c, {}), Contains("size"));
}

TEST_CASE("Empty pictures are equal", "[difference]") { REQUIRE(broken_limit(counts({}, {}), {}).empty()); }

TEST_CASE("A tint too faint for any single pixel breaks the limit of the bias", "[difference]") {
  const DifferenceCounts c = counts(filled_image(20, 20, 100, 100, 100), filled_image(20, 20, 100, 92, 100));
  REQUIRE(c.different == 0);
  REQUIRE(c.mean_bias == std::array<double, 3>{0, -8, 0});
  REQUIRE_THAT(broken_limit(c, {}), Contains("green") && Contains("-8"));
  DifferenceLimits wide;
  wide.bias = 8;
  REQUIRE(broken_limit(c, wide).empty());
}

TEST_CASE("Few pixels in one place break the limit of the window, the same number spread out does not",
          "[difference]") {
  const Image a = white(200, 200);
  Image block = a, dots = a;
  paint(block, {50, 50, 5, 4}, 0);
  for (int i = 0; i < 20; ++i) paint(dots, {(i % 5) * 40, (i / 5) * 50, 1, 1}, 0);
  DifferenceLimits limits;
  limits.different = 20;
  limits.window = 5;
  REQUIRE_THAT(broken_limit(counts(a, block), limits), Contains("20 pixels of one window"));
  REQUIRE(counts(a, dots).different == 20);
  REQUIRE(broken_limit(counts(a, dots), limits).empty());
  limits.different = 19;
  REQUIRE_THAT(broken_limit(counts(a, dots), limits), Contains("20 pixels differ, 19 may"));
}

/// The densest window by counting each one.
DensestWindow counted_window(const DifferenceMap& map, int side) {
  DensestWindow best;
  const int width = std::min(side, map.width_px()), height = std::min(side, map.height_px());
  for (int top = 0; top + height <= map.height_px(); ++top) {
    for (int left = 0; left + width <= map.width_px(); ++left) {
      std::int64_t count = 0;
      for (int y = top; y < top + height; ++y) {
        for (int x = left; x < left + width; ++x) count += map.at(x, y) == PixelClass::different ? 1 : 0;
      }
      if (count > best.different) best = {{left, top, width, height}, count};
    }
  }
  return best;
}

TEST_CASE("Sliding sums find the window that counting finds", "[difference]") {
  std::mt19937 random(9);
  for (const auto& [width, height] : {std::pair{1, 1}, {5, 40}, {40, 5}, {33, 29}}) {
    DifferenceMap map(width, height);
    for (int y = 0; y < height; y += 2) {
      for (PixelClass& pixel : map.make_row(y)) pixel = static_cast<PixelClass>(random() % 5);
    }
    for (const int side : {1, 2, 7, 16, 64}) {
      CAPTURE(width, height, side);
      const DensestWindow slid = densest_window(map, side), counted = counted_window(map, side);
      REQUIRE(slid.different == counted.different);
      REQUIRE(slid.rect == counted.rect);
    }
  }
}

}  // namespace
}  // namespace proofreel
