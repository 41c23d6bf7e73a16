#include <sys/resource.h>

#include <catch2/catch.hpp>

#include "render/png.h"
#include "tests/render/png_bytes.h"
#include "tests/render/test_image.h"

namespace proofreel {
namespace {

using Catch::Matchers::Contains;
using Bytes = std::vector<std::uint8_t>;

Bytes pixels_of(const PngBytes& file) {
  const Image image = decode_png(file, "test.png");
  return {image.rgba.begin(), image.rgba.end()};
}

/// The most memory this process has held, MB.
double peak_megabytes() {
  rusage usage{};
  ::getrusage(RUSAGE_SELF, &usage);
  return static_cast<double>(usage.ru_maxrss) / 1024;
}

/// True for a picture or an ImageError; anything else is thrown on.
bool survives(const Bytes& bytes) {
  try {
    const Image image = decode_png(bytes, "hostile.png");
    return image.rgba.size() ==
           static_cast<std::size_t>(image.width_px) * static_cast<std::size_t>(image.height_px) * 4;
  } catch (const ImageError& error) {
    return std::string(error.what()).find("hostile.png") != std::string::npos;
  }
}

TEST_CASE("Of 16 bits per channel the upper 8 count", "[png]") {
  const PngBytes row{0, 0x12, 0x34, 0xAB, 0xFF, 0x00, 0xFF, 0x80, 0x00};
  REQUIRE(pixels_of(png_file({1, 1, 16, 6, 0}, row)) == Bytes{0x12, 0xAB, 0x00, 0x80});
  REQUIRE(pixels_of(png_file({1, 1, 16, 0, 0}, {0, 0x77, 0x01})) == Bytes{0x77, 0x77, 0x77, 0xFF});
}

TEST_CASE("Gray, with and without alpha, becomes RGBA", "[png]") {
  REQUIRE(pixels_of(png_file({2, 1, 8, 4, 0}, {0, 10, 20, 30, 40})) == Bytes{10, 10, 10, 20, 30, 30, 30, 40});
  REQUIRE(pixels_of(png_file({2, 1, 8, 0, 0}, {0, 10, 30})) == Bytes{10, 10, 10, 255, 30, 30, 30, 255});
  // One bit: black and white.
  REQUIRE(pixels_of(png_file({2, 1, 1, 0, 0}, {0, 0x40})) == Bytes{0, 0, 0, 255, 255, 255, 255, 255});
}

TEST_CASE("A palette gives its colours, transparent ones too", "[png]") {
  PngBytes chunks = png_chunk("PLTE", {255, 0, 0, 0, 255, 0, 0, 0, 255});
  const PngBytes alpha = png_chunk("tRNS", {255, 128});
  chunks.insert(chunks.end(), alpha.begin(), alpha.end());
  REQUIRE(pixels_of(png_file({3, 1, 2, 3, 0}, {0, 0x18}, chunks)) ==
          Bytes{255, 0, 0, 255, 0, 255, 0, 128, 0, 0, 255, 255});
  REQUIRE(pixels_of(png_file({1, 1, 8, 3, 0}, {0, 3}, chunks)) == Bytes{0, 0, 0, 255});  // there is no colour 3
  REQUIRE_THROWS_AS(pixels_of(png_file({1, 1, 8, 3, 0}, {0, 0})), ImageError);           // there is no palette
}

TEST_CASE("An interlaced picture is the same as one that is not", "[png]") {
  struct Pass {
    std::uint32_t x, y, dx, dy;
  };
  constexpr Pass passes[] = {{0, 0, 8, 8}, {4, 0, 8, 8}, {0, 4, 4, 8}, {2, 0, 4, 4},
                             {0, 2, 2, 4}, {1, 0, 2, 2}, {0, 1, 1, 2}};
  for (const auto& [width, height] : {std::pair{1, 1}, {5, 3}, {8, 8}, {17, 23}}) {
    const Image image = noise_image(width, height, 8, false);
    PngBytes rows;
    for (const Pass& pass : passes) {
      for (auto y = static_cast<int>(pass.y); y < height; y += static_cast<int>(pass.dy)) {
        if (static_cast<int>(pass.x) < width) rows.push_back(0);
        for (auto x = static_cast<int>(pass.x); x < width; x += static_cast<int>(pass.dx)) {
          rows.insert(rows.end(), image.row(y) + 4 * x, image.row(y) + 4 * x + 4);
        }
      }
    }
    const PngHeader header{static_cast<std::uint32_t>(width), static_cast<std::uint32_t>(height), 8, 6, 1};
    REQUIRE(pixels_of(png_file(header, rows)) == Bytes(image.rgba.begin(), image.rgba.end()));
  }
}

TEST_CASE("A PNG cut at every hundredth byte is refused with a sentence", "[png]") {
  for (const bool opaque : {true, false}) {
    const Bytes whole = encode_png(noise_image(80, 60, 3, opaque));
    for (std::size_t size = 0; size < whole.size(); size += 100) {
      CAPTURE(size);
      const Bytes part(whole.begin(), whole.begin() + static_cast<std::ptrdiff_t>(size));
      REQUIRE_THROWS_AS(decode_png(part, "cut.png"), ImageError);
    }
  }
}

TEST_CASE("Whatever bits are flipped, there is a picture or a sentence", "[png]") {
  const PngBytes palette = png_chunk("PLTE", PngBytes(3 * 16, 90));
  const std::vector<Bytes> files{encode_png(noise_image(30, 20, 4, true)), encode_png(filled_image(200, 100, 1, 2, 3)),
                                 png_file({9, 2, 4, 3, 0}, PngBytes(12, 1), palette),
                                 png_file({9, 9, 8, 4, 1}, PngBytes(190, 0))};
  std::mt19937 random(11);
  for (const Bytes& file : files) {
    for (int i = 0; i < 1500; ++i) {
      Bytes flipped = file;
      const int flips = 1 + static_cast<int>(random() % 4);
      for (int k = 0; k < flips; ++k) {
        flipped[random() % flipped.size()] ^= static_cast<std::uint8_t>(1U << random() % 8);
      }
      REQUIRE(survives(flipped));
    }
  }
}

TEST_CASE("Garbage behind the signature is survived", "[png]") {
  std::mt19937 random(12);
  const Bytes whole = encode_png(filled_image(9, 9, 5, 5, 5));
  for (int i = 0; i < 2000; ++i) {
    Bytes bytes(whole.begin(), whole.begin() + static_cast<std::ptrdiff_t>(random() % 2 == 0 ? 8 : 33));
    const std::size_t size = random() % 200;
    for (std::size_t k = 0; k < size; ++k) bytes.push_back(static_cast<std::uint8_t>(random() & 255U));
    REQUIRE(survives(bytes));
  }
}

TEST_CASE("Headers that claim more than a picture may have are refused before memory is taken", "[png]") {
  const double before = peak_megabytes();
  for (const auto& [width, height] : {std::pair{0x80000000U, 0x80000000U},
                                      {0x7fffffffU, 0x7fffffffU},
                                      {0xffffffffU, 1U},
                                      {16385U, 1U},
                                      {16384U, 16384U},
                                      {0U, 5U}}) {
    CAPTURE(width, height);
    REQUIRE_THROWS_AS(decode_png(png_file({width, height, 8, 6, 0}, {0, 0, 0, 0, 0}), "big.png"), ImageError);
  }
  REQUIRE_THROWS_WITH(decode_png(png_file({16384, 16384, 1, 0, 0}, {0}), "big.png"), Contains("too large"));
  REQUIRE(peak_megabytes() - before < 100);
}

TEST_CASE("A text or colour profile that unpacks to gigabytes is refused", "[png]") {
  const double before = peak_megabytes();
  PngBytes bomb = compressed(PngBytes(std::size_t{64} << 20U, 'a'));
  const auto chunk = [&bomb](const std::string& type, const std::string& start) {
    PngBytes data(start.begin(), start.end());
    data.insert(data.end(), bomb.begin(), bomb.end());
    return png_chunk(type, data);
  };
  const std::string name("name\0\0", 6);
  for (const PngBytes& extra :
       {chunk("zTXt", name), chunk("iCCP", name), chunk("iTXt", std::string("name\0\1\0\0\0", 9))}) {
    REQUIRE_THROWS_WITH(decode_png(png_file({}, {0, 1, 2, 3, 4}, extra), "bomb.png"), Contains("bomb.png"));
  }
  REQUIRE(peak_megabytes() - before < 400);  // of which the test itself takes some
}

TEST_CASE("Pixels that unpack to more than the picture needs stop there", "[png]") {
  const double before = peak_megabytes();
  const PngBytes file = png_file({4, 4, 8, 6, 0}, PngBytes(std::size_t{64} << 20U, 0));
  REQUIRE(survives(file));
  REQUIRE(peak_megabytes() - before < 300);
}

TEST_CASE("The largest picture that is read takes its own memory once", "[png]") {
  const double before = peak_megabytes();
  const PngBytes file = png_file({8192, 8192, 1, 0, 0}, PngBytes(std::size_t{1025} * 8192, 0));
  REQUIRE(file.size() < 20000);
  REQUIRE(decode_png(file, "flat.png").rgba.size() == static_cast<std::size_t>(max_image_pixels) * 4);
  REQUIRE(peak_megabytes() - before < 400);
}

}  // namespace
}  // namespace proofreel
