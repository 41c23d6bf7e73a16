#include "render/font_atlas.h"

#include <algorithm>

namespace proofreel {

const AtlasGlyph& FontAtlas::glyph(const Font& font, int glyph, int size_px, int phase) {
  const std::tuple<int, int, int> key{glyph, size_px, phase};
  const auto found = glyphs_.find(key);
  if (found != glyphs_.end()) return found->second;
  return glyphs_.emplace(key, place(font.rasterize(glyph, size_px, phase))).first->second;
}

AtlasGlyph FontAtlas::place(const GlyphBitmap& bitmap) {
  if (bitmap.width_px == 0 || bitmap.width_px > width) return {};
  if (row_x_ + bitmap.width_px > width) {
    row_y_ += row_height_;
    row_x_ = 0;
    row_height_ = 0;
  }
  row_height_ = std::max(row_height_, bitmap.height_px);
  const std::size_t needed = static_cast<std::size_t>(row_y_ + row_height_) * width;
  if (coverage_.size() < needed) coverage_.resize(std::max(needed, 2 * coverage_.size()));
  for (int y = 0; y < bitmap.height_px; ++y) {
    std::copy_n(bitmap.coverage.begin() + y * bitmap.width_px, bitmap.width_px,
                coverage_.begin() + (row_y_ + y) * width + row_x_);
  }
  const AtlasGlyph placed{row_x_, row_y_, bitmap.width_px, bitmap.height_px, bitmap.left_px, bitmap.top_px};
  row_x_ += bitmap.width_px;
  return placed;
}

}  // namespace proofreel
