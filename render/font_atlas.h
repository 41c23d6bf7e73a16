#pragma once

/// All glyphs drawn so far, side by side in one picture, at the sizes they were asked for.

#include <map>
#include <tuple>

#include "render/font.h"

namespace proofreel {

/// Where a glyph lies in the atlas and on the picture.
struct AtlasGlyph {
  int x_px = 0;
  int y_px = 0;
  int width_px = 0;  ///< 0 for a space
  int height_px = 0;
  int left_px = 0;  ///< of the glyph's origin
  int top_px = 0;   ///< of the baseline, y down
};

/// Grows downwards, so what lies in it never moves.
class FontAtlas {
 public:
  /// `phase`: see Font::rasterize.
  const AtlasGlyph& glyph(const Font& font, int glyph, int size_px, int phase);

  int width_px() const { return width; }
  int height_px() const { return static_cast<int>(coverage_.size()) / width; }
  const std::vector<std::uint8_t>& coverage() const { return coverage_; }
  /// How many there are by now.
  std::size_t glyphs() const { return glyphs_.size(); }

 private:
  AtlasGlyph place(const GlyphBitmap& bitmap);

  static constexpr int width = 1024;
  std::map<std::tuple<int, int, int>, AtlasGlyph> glyphs_;  // glyph, size, phase
  std::vector<std::uint8_t> coverage_;
  int row_x_ = 0;       // where the next glyph goes
  int row_y_ = 0;       // top of the row being filled
  int row_height_ = 0;  // of its tallest glyph
};

}  // namespace proofreel
