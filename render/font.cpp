#include "render/font.h"

#include <cmath>

#include "render/font_data.h"

// Drawing glyphs to bitmaps calls only sqrt, floor, ceil and fabs, which are exact everywhere.
#define STB_TRUETYPE_IMPLEMENTATION
#define STBTT_STATIC
#include <stb/stb_truetype.h>

namespace proofreel {
namespace {

/// How many bytes follow the first byte of a character; -1 when no character starts so.
int following_bytes(unsigned char first) {
  if (first < 0x80) return 0;
  if (first >= 0xC2 && first < 0xE0) return 1;
  if (first >= 0xE0 && first < 0xF0) return 2;
  if (first >= 0xF0 && first < 0xF5) return 3;
  return -1;
}

constexpr char32_t replacement = 0xFFFD;

}  // namespace

char32_t take_character(std::string_view& text) {
  const auto first = static_cast<unsigned char>(text.front());
  text.remove_prefix(1);
  const int following = following_bytes(first);
  if (following < 0 || text.size() < static_cast<std::size_t>(following)) return replacement;
  char32_t character = following == 0 ? first : first & (0x3FU >> following);
  for (int i = 0; i < following; ++i) {
    const auto byte = static_cast<unsigned char>(text[static_cast<std::size_t>(i)]);
    if ((byte & 0xC0U) != 0x80U) return replacement;
    character = character << 6U | (byte & 0x3FU);
  }
  text.remove_prefix(static_cast<std::size_t>(following));
  return character;
}

struct Font::Impl {
  stbtt_fontinfo info{};
  std::int64_t units_per_em = 0;

  /// Font units to pen units, rounded to the nearest.
  Pen pen(std::int64_t units, int size_px) const {
    const std::int64_t scaled = 2 * units * size_px * pen_per_pixel + units_per_em;
    const std::int64_t quotient = scaled / (2 * units_per_em);
    return scaled % (2 * units_per_em) < 0 ? quotient - 1 : quotient;
  }
  float scale(int size_px) const { return static_cast<float>(size_px) / static_cast<float>(units_per_em); }
};

Font::Font() : impl_(std::make_unique<Impl>()) {
  stbtt_InitFont(&impl_->info, font_file(), 0);
  impl_->units_per_em = std::lround(1.0 / static_cast<double>(stbtt_ScaleForMappingEmToPixels(&impl_->info, 1)));
}

Font::~Font() = default;

TextLine Font::layout(std::string_view utf8, int size_px) const {
  TextLine line;
  int previous = -1;
  while (!utf8.empty()) {
    const char32_t character = take_character(utf8);
    const int glyph = stbtt_FindGlyphIndex(&impl_->info, static_cast<int>(character));
    int advance = 0;
    int bearing = 0;
    stbtt_GetGlyphHMetrics(&impl_->info, glyph, &advance, &bearing);
    if (previous >= 0) line.width += impl_->pen(stbtt_GetGlyphKernAdvance(&impl_->info, previous, glyph), size_px);
    line.glyphs.push_back({glyph, line.width});
    line.width += impl_->pen(advance, size_px);
    previous = glyph;
  }
  return line;
}

GlyphBitmap Font::rasterize(int glyph, int size_px, int phase) const {
  const float scale = impl_->scale(size_px);
  const float shift = static_cast<float>(phase) / static_cast<float>(glyph_phases);
  int right = 0;
  int bottom = 0;
  GlyphBitmap bitmap;
  stbtt_GetGlyphBitmapBoxSubpixel(&impl_->info, glyph, scale, scale, shift, 0, &bitmap.left_px, &bitmap.top_px, &right,
                                  &bottom);
  bitmap.width_px = right - bitmap.left_px;
  bitmap.height_px = bottom - bitmap.top_px;
  if (bitmap.width_px <= 0 || bitmap.height_px <= 0) return {};
  bitmap.coverage.resize(static_cast<std::size_t>(bitmap.width_px) * static_cast<std::size_t>(bitmap.height_px));
  stbtt_MakeGlyphBitmapSubpixel(&impl_->info, bitmap.coverage.data(), bitmap.width_px, bitmap.height_px,
                                bitmap.width_px, scale, scale, shift, 0, glyph);
  return bitmap;
}

std::vector<OutlinePiece> Font::outline(int glyph) const {
  stbtt_vertex* vertices = nullptr;
  const int count = stbtt_GetGlyphShape(&impl_->info, glyph, &vertices);
  const auto em = static_cast<double>(impl_->units_per_em);
  std::vector<OutlinePiece> pieces;
  for (int i = 0; i < count; ++i) {
    const stbtt_vertex& v = vertices[i];
    const auto kind = v.type == STBTT_vmove   ? OutlinePiece::Kind::move
                      : v.type == STBTT_vline ? OutlinePiece::Kind::line
                                              : OutlinePiece::Kind::curve;  // DejaVu has no cubic ones
    pieces.push_back({kind, {v.x / em, v.y / em}, {v.cx / em, v.cy / em}});
  }
  stbtt_FreeShape(&impl_->info, vertices);
  return pieces;
}

}  // namespace proofreel
