#include "golden/yiq.h"

#include <algorithm>

#include "golden/packed_pixel.h"

namespace proofreel {
namespace {

/// A minus B, per channel.
struct ColorStep {
  double r, g, b;
};

/// One channel of the background: dark or light. The golden ratio and its square make patterns that never align.
double shade(double position) { return 48 + 159 * (static_cast<int>(position) % 2); }

ColorStep step_between(const std::uint8_t* a, const std::uint8_t* b, std::int64_t index) {
  const int dr = a[0] - b[0], dg = a[1] - b[1], db = a[2] - b[2];
  if ((a[3] & b[3]) == 255) return {static_cast<double>(dr), static_cast<double>(dg), static_cast<double>(db)};
  const int da = a[3] - b[3];
  const auto byte = static_cast<double>(4 * index);
  // 48 for red: pixels begin at even bytes, as the pattern is defined.
  return {(a[0] * a[3] - b[0] * b[3] - 48.0 * da) / 255,
          (a[1] * a[3] - b[1] * b[3] - shade(byte / 1.618033988749895) * da) / 255,
          (a[2] * a[3] - b[2] * b[3] - shade(byte / 2.618033988749895) * da) / 255};
}

double brightness(const ColorStep& c) { return c.r * 0.29889531 + c.g * 0.58662247 + c.b * 0.11448223; }

struct Extreme {
  double difference = 0;  ///< in brightness, of the middle pixel from this one
  int x = 0, y = 0;
};

}  // namespace

double yiq_distance(const std::uint8_t* a, const std::uint8_t* b, std::int64_t index) {
  if (packed_pixel(a) == packed_pixel(b)) return 0;
  const ColorStep c = step_between(a, b, index);
  const double y = brightness(c);
  const double i = c.r * 0.59597799 - c.g * 0.27417610 - c.b * 0.32180189;
  const double q = c.r * 0.21147017 - c.g * 0.52261711 + c.b * 0.31114694;
  return 0.5053 * y * y + 0.299 * i * i + 0.1957 * q * q;
}

bool is_antialiased(const Image& image, const FlatRows& flat, int x, int y) {
  if (!flat.has_flat_neighbour(x)) return false;
  const int left = std::max(x - 1, 0), right = std::min(x + 1, image.width_px - 1);
  const int top = std::max(y - 1, 0), bottom = std::min(y + 1, image.height_px - 1);
  const auto at = [&image](int u, int v) { return image.row(v) + 4 * static_cast<std::size_t>(u); };
  const std::int64_t index = static_cast<std::int64_t>(y) * image.width_px + x;
  int equal = left == x || right == x || top == y || bottom == y ? 1 : 0;  // beyond the border lies one
  Extreme darkest, brightest;
  // Column by column, as the definition has it: of equally dark neighbours the first counts.
  for (int u = left; u <= right; ++u) {
    for (int v = top; v <= bottom; ++v) {
      if (u == x && v == y) continue;
      const double difference = brightness(step_between(at(x, y), at(u, v), index));
      if (difference == 0 && ++equal > 2) return false;
      if (difference < brightest.difference) brightest = {difference, u, v};
      if (difference > darkest.difference) darkest = {difference, u, v};
    }
  }
  if (darkest.difference == 0 || brightest.difference == 0) return false;
  return flat.is_flat(darkest.x, darkest.y) || flat.is_flat(brightest.x, brightest.y);
}

}  // namespace proofreel
