#include "golden/compare_rows.h"

#include <algorithm>

#include "golden/packed_pixel.h"
#include "render/vectorised.h"

namespace proofreel {
namespace {

inline std::int32_t channel(std::uint32_t pixel, unsigned shift) {
  return static_cast<std::int32_t>(pixel >> shift & 255U);
}

inline std::int32_t magnitude(std::int32_t value) { return value < 0 ? -value : value; }

/// Sums over a piece of a row that is short enough for 32 bits.
struct PieceSums {
  std::int32_t different, beyond, largest, red, green, blue, alpha;
};
constexpr int longest_piece_px = 1 << 20;

PROOFREEL_VECTORISED
void add_up(const std::uint8_t* __restrict a, const std::uint8_t* __restrict b, int count, std::int32_t allowed,
            PieceSums& sums) {
  std::int32_t different = 0, beyond = 0, largest = 0, red = 0, green = 0, blue = 0, alpha = 0;
  for (int i = 0; i < count; ++i) {
    const std::uint32_t p = packed_pixel(a + 4 * i), q = packed_pixel(b + 4 * i);
    const std::int32_t dr = channel(q, 0) - channel(p, 0), dg = channel(q, 8) - channel(p, 8);
    const std::int32_t db = channel(q, 16) - channel(p, 16), da = channel(q, 24) - channel(p, 24);
    const std::int32_t most = std::max(std::max(magnitude(dr), magnitude(dg)), std::max(magnitude(db), magnitude(da)));
    different += most > 0 ? 1 : 0;
    beyond += most > allowed ? 1 : 0;
    largest = std::max(largest, most);
    red += dr, green += dg, blue += db, alpha += da;
  }
  sums = {different, beyond, largest, red, green, blue, alpha};
}

PROOFREEL_VECTORISED
void mark(const std::uint8_t* __restrict a, const std::uint8_t* __restrict b, int count, float least,
          std::uint8_t* __restrict marks) {
  for (int i = 0; i < count; ++i) {
    const std::uint32_t p = packed_pixel(a + 4 * i), q = packed_pixel(b + 4 * i);
    const auto dr = static_cast<float>(channel(p, 0) - channel(q, 0));
    const auto dg = static_cast<float>(channel(p, 8) - channel(q, 8));
    const auto db = static_cast<float>(channel(p, 16) - channel(q, 16));
    const float y = dr * 0.29889531F + dg * 0.58662247F + db * 0.11448223F;
    const float in_phase = dr * 0.59597799F - dg * 0.27417610F - db * 0.32180189F;
    const float quadrature = dr * 0.21147017F - dg * 0.52261711F + db * 0.31114694F;
    const float distance = 0.5053F * y * y + 0.299F * in_phase * in_phase + 0.1957F * quadrature * quadrature;
    const std::uint32_t reaches = distance >= least ? 1 : 0;
    const std::uint32_t translucent = (p & q) < 0xFF000000U ? 1 : 0;
    const std::uint32_t differs = p != q ? 1 : 0;
    marks[i] = static_cast<std::uint8_t>(differs + (differs & (reaches | translucent)));
  }
}

}  // namespace

RowSums sums_of_row(const std::uint8_t* a, const std::uint8_t* b, int width_px, int allowed) {
  RowSums row;
  for (int x = 0; x < width_px; x += longest_piece_px) {
    const std::size_t byte = 4 * static_cast<std::size_t>(x);
    PieceSums piece;
    add_up(a + byte, b + byte, std::min(longest_piece_px, width_px - x), allowed, piece);
    row.different += piece.different;
    row.beyond += piece.beyond;
    row.max_channel = std::max(row.max_channel, piece.largest);
    row.bias[0] += piece.red;
    row.bias[1] += piece.green;
    row.bias[2] += piece.blue;
    row.bias[3] += piece.alpha;
  }
  return row;
}

void mark_row(const std::uint8_t* a, const std::uint8_t* b, int width_px, double least, std::uint8_t* marks) {
  // Far more than single precision can be off: nothing that reaches `least` is missed.
  constexpr double safe = 0.999;
  mark(a, b, width_px, static_cast<float>(least * safe), marks);
}

}  // namespace proofreel
