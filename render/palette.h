#pragma once

/// Films in 255 colours: which ones, and every pixel as one of them.

#include <cstdint>
#include <unordered_map>
#include <vector>

#include "render/image.h"

namespace proofreel {

/// How often which colour stands in the pictures of a film.
class ColorCounts {
 public:
  void add(const Image& image);
  /// 0xRRGGBB and how many pixels, in order of colour. What is less than half opaque is not counted.
  std::vector<std::pair<std::uint32_t, std::uint64_t>> sorted() const;

 private:
  std::unordered_map<std::uint32_t, std::uint64_t> counts_;
};

/// Up to 255 colours by median cut (P. Heckbert 1982): the box of colours that differ most, weighted by how often they
/// stand, is cut in two until there are enough; a colour that makes up most of its box stands for it exactly, so that
/// flat fills come out as drawn. The 256th is nothing at all.
class Palette {
 public:
  explicit Palette(const ColorCounts& counts);

  /// 0xAARRGGBB; the last is transparent.
  const std::vector<std::uint32_t>& colors() const { return colors_; }
  /// An index per pixel. What is not in the palette is dithered in an ordered pattern (B. Bayer 1973), which stays
  /// where it is from frame to frame; what is, is left alone.
  std::vector<std::uint8_t> dithered(const Image& image);

 private:
  std::uint8_t nearest(int r, int g, int b);

  std::vector<std::uint32_t> colors_;
  std::unordered_map<std::uint32_t, std::uint8_t> exact_;
  std::vector<std::int16_t> nearest_;  ///< by the upper 6 bits of each channel; -1 where nobody has asked
};

}  // namespace proofreel
