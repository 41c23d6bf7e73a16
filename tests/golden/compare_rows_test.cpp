#include "golden/compare_rows.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cstdlib>
#include <vector>

#include "golden/yiq.h"
#include "tests/render/test_image.h"

namespace proofreel {
namespace {

/// A copy of which about one byte in `every` is another.
Image changed(Image image, unsigned seed, unsigned every) {
  std::mt19937 random(seed);
  for (std::uint8_t& byte : image.rgba) {
    if (random() % every == 0) byte = static_cast<std::uint8_t>(random() & 255U);
  }
  return image;
}

/// The same sums, one byte after the other.
RowSums plain_sums(const std::uint8_t* a, const std::uint8_t* b, int width, int allowed) {
  RowSums sums;
  for (int x = 0; x < width; ++x) {
    int largest = 0;
    for (std::size_t channel = 0; channel < 4; ++channel) {
      const int difference =
          b[4 * static_cast<std::size_t>(x) + channel] - a[4 * static_cast<std::size_t>(x) + channel];
      largest = std::max(largest, std::abs(difference));
      sums.bias[channel] += difference;
    }
    sums.different += largest > 0 ? 1 : 0;
    sums.beyond += largest > allowed ? 1 : 0;
    sums.max_channel = std::max(sums.max_channel, largest);
  }
  return sums;
}

TEST_CASE("The sums of a row are those of its pixels one by one, at any width", "[rows]") {
  for (const int width : {1, 2, 3, 7, 8, 31, 255, 256, 257, 300, 1023}) {
    const Image a = noise_image(width, 1, 7, false);
    for (const unsigned every : {1U, 3U, 100U}) {
      const Image b = changed(a, every, every);
      for (const int allowed : {0, 1, 100, 255}) {
        CAPTURE(width, every, allowed);
        const RowSums fast = sums_of_row(a.row(0), b.row(0), width, allowed);
        const RowSums plain = plain_sums(a.row(0), b.row(0), width, allowed);
        REQUIRE(fast.different == plain.different);
        REQUIRE(fast.beyond == plain.beyond);
        REQUIRE(fast.max_channel == plain.max_channel);
        REQUIRE(fast.bias == plain.bias);
      }
    }
  }
}

TEST_CASE("Black against white over a long row overflows nothing", "[rows]") {
  const Image black = filled_image(16384, 1, 0, 0, 0, 0), white = filled_image(16384, 1, 255, 255, 255, 255);
  const RowSums up = sums_of_row(black.row(0), white.row(0), 16384, 254);
  REQUIRE(up.bias == std::array<std::int64_t, 4>{16384 * 255, 16384 * 255, 16384 * 255, 16384 * 255});
  REQUIRE(up.beyond == 16384);
  REQUIRE(sums_of_row(white.row(0), black.row(0), 16384, 255).bias[3] == -16384 * 255);
}

TEST_CASE("What reaches the distance is a candidate, what is equal is marked so, and few others are candidates",
          "[rows]") {
  for (const bool opaque : {true, false}) {
    const Image a = noise_image(1000, 1, 1, opaque), b = changed(a, 2, 9);
    std::vector<std::uint8_t> marks(1000);
    for (const double least : {0.0, 1.0, 50.0, 352.15, 5000.0}) {
      mark_row(a.row(0), b.row(0), 1000, least, marks.data());
      for (int x = 0; x < 1000; ++x) {
        const std::uint8_t *p = a.row(0) + 4 * x, *q = b.row(0) + 4 * x;
        const std::uint8_t mark = marks[static_cast<std::size_t>(x)];
        const double distance = yiq_distance(p, q, x);
        CAPTURE(opaque, least, x, distance);
        REQUIRE((mark == equal_pixel) == std::equal(p, p + 4, q));
        if (mark != equal_pixel && distance >= least) REQUIRE(mark == candidate_pixel);
        if (p[3] == 255 && q[3] == 255 && distance < 0.99 * least) REQUIRE(mark != candidate_pixel);
      }
    }
  }
}

}  // namespace
}  // namespace proofreel
