#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace proofreel {

/// What a PNG file says of itself in its first chunk. The defaults are 8-bit RGBA without interlacing.
struct PngHeader {
  std::uint32_t width = 1;
  std::uint32_t height = 1;
  std::uint8_t bit_depth = 8;
  std::uint8_t color_type = 6;  ///< 0 gray, 2 RGB, 3 palette, 4 gray and alpha, 6 RGBA
  std::uint8_t interlace = 0;   ///< 1: Adam7
};

using PngBytes = std::vector<std::uint8_t>;

/// A chunk with its length and checksum.
PngBytes png_chunk(const std::string& type, const PngBytes& data);

/// `data` as a zlib stream.
PngBytes compressed(const PngBytes& data);

/// A whole file: signature, header, `before` (chunks), the pixels, the end. `rows` holds every row with its filter byte
/// in front, of all passes when interlaced.
PngBytes png_file(const PngHeader& header, const PngBytes& rows, const PngBytes& before = {});

}  // namespace proofreel
