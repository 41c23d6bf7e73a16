#pragma once

/// Shapes and metrics of letters, and where they go in a line of text. Everything is computed from integers and from
/// float operations that round the same everywhere, never from the C library.

#include <cstdint>
#include <memory>
#include <string_view>
#include <vector>

#include "engine/vec2.h"

namespace proofreel {

/// Positions along a line, in 1/64 pixel: fine enough to space letters evenly, and exact to add up.
using Pen = std::int64_t;
inline constexpr Pen pen_per_pixel = 64;

/// Letters are rasterised at this many positions within a pixel, so that spacing stays even at small sizes.
inline constexpr int glyph_phases = 4;

/// One letter of a line.
struct PlacedGlyph {
  int glyph = 0;  ///< index in the font; 0 is the box for what the font lacks
  Pen x = 0;      ///< of its origin, from the start of the line
};

struct TextLine {
  std::vector<PlacedGlyph> glyphs;
  Pen width = 0;
};

/// How much of each pixel a glyph covers, 0..255, rows from the top.
struct GlyphBitmap {
  int width_px = 0;
  int height_px = 0;
  int left_px = 0;  ///< of the bitmap, from the glyph's origin
  int top_px = 0;   ///< of the bitmap, from the baseline, y down
  std::vector<std::uint8_t> coverage;
};

/// A piece of a glyph's outline. Em, y up, from the glyph's origin; every outline begins with a move and is closed.
struct OutlinePiece {
  enum class Kind : std::uint8_t { move, line, curve };  ///< curve: a parabola, by one control point
  Kind kind = Kind::move;
  Vec2d to;
  Vec2d control;
};

class Font {
 public:
  Font();
  ~Font();
  Font(const Font&) = delete;
  Font& operator=(const Font&) = delete;

  /// Where the letters of a line go, kerning included. Bytes that are not UTF-8 become boxes. `size_px` is the em.
  TextLine layout(std::string_view utf8, int size_px) const;
  /// The glyph moved right by `phase` / glyph_phases of a pixel.
  GlyphBitmap rasterize(int glyph, int size_px, int phase) const;
  std::vector<OutlinePiece> outline(int glyph) const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

/// Takes the first character off `text`; U+FFFD for bytes that are not UTF-8.
char32_t take_character(std::string_view& text);

}  // namespace proofreel
