#include "render/palette.h"

#include <algorithm>
#include <array>
#include <limits>

namespace proofreel {
namespace {

constexpr std::size_t most_colors = 255;
constexpr std::uint8_t transparent_index = 255;

struct Counted {
  std::array<int, 3> color{};
  std::uint64_t pixels = 0;
};

/// Colours [first, last) of a list.
struct Box {
  std::size_t first = 0;
  std::size_t last = 0;
  int channel = 0;     ///< in which they differ most
  double spread = -1;  ///< sum of squared distances from the mean in that channel
};

Box box_of(const std::vector<Counted>& colors, std::size_t first, std::size_t last) {
  Box box{first, last};
  for (int channel = 0; channel < 3; ++channel) {
    const auto c = static_cast<std::size_t>(channel);
    double n = 0, sum = 0, squares = 0;
    for (std::size_t i = first; i < last; ++i) {
      const auto pixels = static_cast<double>(colors[i].pixels);
      n += pixels;
      sum += pixels * colors[i].color[c];
      squares += pixels * colors[i].color[c] * colors[i].color[c];
    }
    const double spread = squares - sum * sum / n;
    if (spread > box.spread) box.channel = channel, box.spread = spread;
  }
  return box;
}

/// Where half of the pixels are on either side, and a colour at least.
std::size_t middle_of(std::vector<Counted>& colors, const Box& box) {
  const auto c = static_cast<std::size_t>(box.channel);
  const auto begin = colors.begin() + static_cast<std::ptrdiff_t>(box.first);
  std::sort(begin, colors.begin() + static_cast<std::ptrdiff_t>(box.last), [c](const Counted& a, const Counted& b) {
    return a.color[c] != b.color[c] ? a.color[c] < b.color[c] : a.color < b.color;
  });
  std::uint64_t all = 0;
  for (std::size_t i = box.first; i < box.last; ++i) all += colors[i].pixels;
  std::uint64_t below = 0;
  std::size_t middle = box.first;
  while (middle + 1 < box.last && (middle == box.first || 2 * below < all)) below += colors[middle++].pixels;
  return middle;
}

std::uint32_t packed(const std::array<int, 3>& c) {
  return static_cast<std::uint32_t>(c[0]) << 16U | static_cast<std::uint32_t>(c[1]) << 8U |
         static_cast<std::uint32_t>(c[2]);
}

/// The colour that makes up most of it, or else the mean.
std::uint32_t color_of(const std::vector<Counted>& colors, const Box& box) {
  std::uint64_t n = 0;
  std::array<std::uint64_t, 3> sum{};
  const Counted* most = &colors[box.first];
  for (std::size_t i = box.first; i < box.last; ++i) {
    n += colors[i].pixels;
    for (std::size_t c = 0; c < 3; ++c) sum[c] += colors[i].pixels * static_cast<std::uint64_t>(colors[i].color[c]);
    if (colors[i].pixels > most->pixels) most = &colors[i];
  }
  if (2 * most->pixels > n) return packed(most->color);
  return packed({static_cast<int>((sum[0] + n / 2) / n), static_cast<int>((sum[1] + n / 2) / n),
                 static_cast<int>((sum[2] + n / 2) / n)});
}

std::vector<Box> cut(std::vector<Counted>& colors) {
  std::vector<Box> boxes{box_of(colors, 0, colors.size())};
  while (boxes.size() < most_colors) {
    const auto widest =
        std::max_element(boxes.begin(), boxes.end(), [](const Box& a, const Box& b) { return a.spread < b.spread; });
    if (widest->spread <= 0) break;  // every colour has a box of its own
    const Box whole = *widest;
    const std::size_t middle = middle_of(colors, whole);
    *widest = box_of(colors, whole.first, middle);
    boxes.push_back(box_of(colors, middle, whole.last));
  }
  return boxes;
}

/// 0..63, no two neighbours alike.
constexpr std::array<std::array<int, 8>, 8> bayer{{{0, 32, 8, 40, 2, 34, 10, 42},
                                                   {48, 16, 56, 24, 50, 18, 58, 26},
                                                   {12, 44, 4, 36, 14, 46, 6, 38},
                                                   {60, 28, 52, 20, 62, 30, 54, 22},
                                                   {3, 35, 11, 43, 1, 33, 9, 41},
                                                   {51, 19, 59, 27, 49, 17, 57, 25},
                                                   {15, 47, 7, 39, 13, 45, 5, 37},
                                                   {63, 31, 55, 23, 61, 29, 53, 21}}};

/// -8..7: about as far as colours of a full palette are apart.
int offset_at(int x, int y) { return bayer[static_cast<std::size_t>(y & 7)][static_cast<std::size_t>(x & 7)] / 4 - 8; }

std::size_t cell_of(int r, int g, int b) { return static_cast<std::size_t>(r >> 2 << 12 | g >> 2 << 6 | b >> 2); }

}  // namespace

void ColorCounts::add(const Image& image) {
  const std::size_t size = image.rgba.size();
  for (std::size_t i = 0; i < size;) {
    const std::uint8_t* p = image.rgba.data() + i;
    std::size_t end = i + 4;  // drawn pictures have long runs of one colour
    while (end < size && std::equal(p, p + 4, image.rgba.data() + end)) end += 4;
    if (p[3] >= 128) counts_[packed({p[0], p[1], p[2]})] += (end - i) / 4;
    i = end;
  }
}

std::vector<std::pair<std::uint32_t, std::uint64_t>> ColorCounts::sorted() const {
  std::vector<std::pair<std::uint32_t, std::uint64_t>> list(counts_.begin(), counts_.end());
  std::sort(list.begin(), list.end());
  return list;
}

Palette::Palette(const ColorCounts& counts) : nearest_(std::size_t{1} << 18, std::int16_t{-1}) {
  std::vector<Counted> colors;
  for (const auto& [color, pixels] : counts.sorted()) {
    const auto channel = [&color = color](unsigned shift) { return static_cast<int>(color >> shift & 255U); };
    colors.push_back({{channel(16), channel(8), channel(0)}, pixels});
  }
  if (!colors.empty()) {
    for (const Box& box : cut(colors)) {
      const std::uint32_t color = color_of(colors, box);
      exact_.emplace(color, static_cast<std::uint8_t>(colors_.size()));
      colors_.push_back(0xFF000000U | color);
    }
  }
  colors_.resize(most_colors, 0xFF000000U);
  colors_.push_back(0);
}

std::uint8_t Palette::nearest(int r, int g, int b) {
  std::int16_t& known = nearest_[cell_of(r, g, b)];
  if (known >= 0) return static_cast<std::uint8_t>(known);
  int least = std::numeric_limits<int>::max();
  for (std::size_t i = 0; i < most_colors; ++i) {
    const auto off = [this, i](unsigned shift, int value) {
      return static_cast<int>(colors_[i] >> shift & 255U) - value;
    };
    const int dr = off(16, r), dg = off(8, g), db = off(0, b);
    const int distance = 2 * dr * dr + 4 * dg * dg + db * db;  // about as eyes weigh them
    if (distance < least) least = distance, known = static_cast<std::int16_t>(i);
  }
  return static_cast<std::uint8_t>(known);
}

std::vector<std::uint8_t> Palette::dithered(const Image& image) {
  std::vector<std::uint8_t> indices(image.rgba.size() / 4);
  std::size_t i = 0;
  for (int y = 0; y < image.height_px; ++y) {
    const std::uint8_t* p = image.row(y);
    for (int x = 0; x < image.width_px; ++x, p += 4, ++i) {
      if (p[3] < 128) {
        indices[i] = transparent_index;
      } else if (const auto own = exact_.find(packed({p[0], p[1], p[2]})); own != exact_.end()) {
        indices[i] = own->second;
      } else {
        const auto moved = [offset = offset_at(x, y)](int value) { return std::clamp(value + offset, 0, 255); };
        indices[i] = nearest(moved(p[0]), moved(p[1]), moved(p[2]));
      }
    }
  }
  return indices;
}

}  // namespace proofreel
