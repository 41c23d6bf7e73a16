#include "golden/compare.h"

#include <catch2/catch.hpp>

namespace proofreel {
namespace {

TEST_CASE("An image does not differ from itself", "[compare]") {
  const Image image(20, 10);
  const Comparison c = compare(image, image, 0);
  REQUIRE(c.same_size);
  REQUIRE(c.total == 200);
  REQUIRE(c.different == 0);
  REQUIRE(c.beyond == 0);
  REQUIRE(c.max_channel == 0);
}

TEST_CASE("One channel of one pixel is found, with its place and size", "[compare]") {
  for (const std::size_t channel : {0U, 1U, 2U, 3U}) {
    const Image a(20, 10);
    Image b = a;
    b.rgba[(7 * 20 + 13) * 4 + channel] = 5;
    for (const Comparison& c : {compare(a, b, 0), compare(b, a, 0)}) {
      REQUIRE(c.different == 1);
      REQUIRE(c.beyond == 1);
      REQUIRE(c.max_channel == 5);
      REQUIRE(c.worst_x_px == 13);
      REQUIRE(c.worst_y_px == 7);
    }
  }
}

TEST_CASE("A difference up to what is allowed counts as different but not as beyond", "[compare]") {
  const Image a(4, 1);
  Image b = a;
  for (std::size_t i = 0; i < 4; ++i) b.rgba[i * 4] = static_cast<std::uint8_t>(i);
  const Comparison c = compare(a, b, 2);
  REQUIRE(c.different == 3);
  REQUIRE(c.beyond == 1);
  REQUIRE(c.max_channel == 3);
}

TEST_CASE("Black against white differs by all there is", "[compare]") {
  const Image a(3, 3);
  Image b(3, 3);
  for (std::uint8_t& byte : b.rgba) byte = 255;
  REQUIRE(compare(a, b, 254).beyond == 9);
  REQUIRE(compare(a, b, 255).beyond == 0);
}

TEST_CASE("Images of other size are not compared, even with as many pixels", "[compare]") {
  REQUIRE_FALSE(compare(Image(4, 2), Image(2, 4), 0).same_size);
  REQUIRE(compare(Image(4, 2), Image(2, 4), 0).total == 0);
  REQUIRE(compare(Image(), Image(), 0).same_size);
}

}  // namespace
}  // namespace proofreel
