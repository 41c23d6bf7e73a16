#include "render/png.h"

#include <catch2/catch.hpp>

#include "tests/render/scratch_folder.h"
#include "tests/render/test_image.h"

namespace proofreel {
namespace {

using Catch::Matchers::Contains;

TEST_CASE("An image comes back from PNG byte for byte, opaque or not", "[png]") {
  for (const bool opaque : {true, false}) {
    for (const auto& [width, height] : {std::pair{1, 1}, {7, 3}, {480, 270}, {1, 300}}) {
      const Image image = noise_image(width, height, 5, opaque);
      const Image back = decode_png(encode_png(image), "test");
      REQUIRE(back.width_px == width);
      REQUIRE(back.height_px == height);
      REQUIRE(back.rgba == image.rgba);
    }
  }
}

TEST_CASE("The same image gives the same PNG bytes", "[png]") {
  const Image image = noise_image(64, 48, 9, true);
  REQUIRE(encode_png(image) == encode_png(image));
}

TEST_CASE("A flat frame of film compresses to a small fraction", "[png]") {
  REQUIRE(encode_png(filled_image(1920, 1080, 250, 250, 245)).size() < 20000);
}

TEST_CASE("A PNG cut anywhere is said to be truncated", "[png]") {
  const std::vector<std::uint8_t> bytes = encode_png(noise_image(40, 30, 2, true));
  for (const std::size_t size :
       {std::size_t{9}, std::size_t{30}, bytes.size() / 2, bytes.size() - 14, bytes.size() - 12}) {
    const std::vector<std::uint8_t> part(bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(size));
    CAPTURE(size);
    REQUIRE_THROWS_WITH(decode_png(part, "cut.png"), Contains("cut.png") && Contains("truncated"));
  }
}

TEST_CASE("What is not a PNG is named so", "[png]") {
  const std::vector<std::uint8_t> text(200, 'x');
  REQUIRE_THROWS_WITH(decode_png(text, "letter.png"), Contains("letter.png is not a PNG"));
  REQUIRE_THROWS_WITH(decode_png({}, "empty.png"), Contains("empty.png is not a PNG"));
}

TEST_CASE("A PNG whose bytes were changed is said to be damaged", "[png]") {
  std::vector<std::uint8_t> bytes = encode_png(noise_image(40, 30, 2, true));
  bytes[bytes.size() / 2] ^= 0x55U;
  REQUIRE_THROWS_AS(decode_png(bytes, "bad.png"), ImageError);
}

TEST_CASE("A PNG larger than anything drawn is refused before memory is taken for it", "[png]") {
  std::vector<std::uint8_t> bytes = encode_png(filled_image(4, 4, 1, 2, 3));
  bytes[16 + 2] = 0x7f;  // the second lowest byte of the width: 0x7f04 pixels, with a checksum that is now wrong
  REQUIRE_THROWS_AS(decode_png(bytes, "wide.png"), ImageError);
  const Image wide(max_image_side_px + 1, 1);
  REQUIRE_THROWS_WITH(decode_png(encode_png(wide), "wide.png"), Contains("too large"));
}

TEST_CASE("A file that is not there cannot be read", "[png]") {
  const ScratchFolder folder;
  REQUIRE_THROWS_WITH(read_png(folder / "none.png"), Contains("none.png"));
}

TEST_CASE("A written PNG is read back", "[png]") {
  const ScratchFolder folder;
  const Image image = noise_image(31, 17, 4, false);
  write_png(folder / "a.png", image);
  REQUIRE(read_png(folder / "a.png").rgba == image.rgba);
  REQUIRE(folder.file_count() == 1);
}

}  // namespace
}  // namespace proofreel
