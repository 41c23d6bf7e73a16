#include "render/lettering.h"

#include <algorithm>

namespace proofreel {
namespace {

std::uint8_t blended(std::uint8_t below, std::uint8_t above, int coverage) {
  return static_cast<std::uint8_t>((below * (255 - coverage) + above * coverage + 127) / 255);
}

void blend(std::uint8_t* pixel, Color color, int coverage) {
  pixel[0] = blended(pixel[0], color.r, coverage);
  pixel[1] = blended(pixel[1], color.g, coverage);
  pixel[2] = blended(pixel[2], color.b, coverage);
  pixel[3] = blended(pixel[3], 255, coverage);
}

void blend(Image& image, const GlyphBitmap& glyph, const LetterLine& line, int x_px, Color color) {
  const int last_x = std::min(line.end_px, image.width_px), last_y = image.height_px;
  for (int row = 0; row < glyph.height_px; ++row) {
    const int y = line.baseline_px + glyph.top_px + row;
    if (y < 0 || y >= last_y) continue;
    for (int column = 0; column < glyph.width_px; ++column) {
      const int x = x_px + glyph.left_px + column;
      if (x < 0 || x >= last_x) continue;
      blend(image.row(y) + 4 * static_cast<std::size_t>(x), color,
            glyph.coverage[static_cast<std::size_t>(row) * static_cast<std::size_t>(glyph.width_px) +
                           static_cast<std::size_t>(column)]);
    }
  }
}

}  // namespace

int Lettering::width_px(std::string_view utf8, int size_px) const {
  return static_cast<int>((font_.layout(utf8, size_px).width + pen_per_pixel - 1) / pen_per_pixel);
}

void Lettering::write(Image& image, std::string_view utf8, int size_px, const LetterLine& line, Color color) const {
  for (const PlacedGlyph& placed : font_.layout(utf8, size_px).glyphs) {
    const int whole = static_cast<int>(placed.x / pen_per_pixel);
    const int phase = static_cast<int>(placed.x % pen_per_pixel * glyph_phases / pen_per_pixel);
    blend(image, font_.rasterize(placed.glyph, size_px, phase), line, line.x_px + whole, color);
  }
}

}  // namespace proofreel
