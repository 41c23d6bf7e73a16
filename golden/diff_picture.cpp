#include "golden/diff_picture.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "golden/yiq.h"
#include "render/usage_error.h"

namespace proofreel {
namespace {

constexpr Color vermilion{213, 60, 0, 255}, yellow{240, 215, 40, 255}, blue{60, 150, 220, 255},
    pink{255, 190, 175, 255};
constexpr Color frame_color{0, 60, 160, 255};
constexpr Color hatch_on_pale{170, 170, 175, 255}, hatch_on_dark{95, 98, 108, 255};

int gray_of(const std::uint8_t* pixel) { return (77 * pixel[0] + 151 * pixel[1] + 28 * pixel[2]) / 256; }

void put(std::uint8_t* pixel, Color color) {
  pixel[0] = color.r;
  pixel[1] = color.g;
  pixel[2] = color.b;
  pixel[3] = color.a;
}

Color gray(int value) {
  const auto v = static_cast<std::uint8_t>(value);
  return {v, v, v, 255};
}

/// Faint enough that colours stand out, strong enough to see where they are.
Color pale(const std::uint8_t* pixel) { return gray(255 - (255 - gray_of(pixel)) * pixel[3] / 255 / 5); }
Color dark(const std::uint8_t* pixel) { return gray(gray_of(pixel) * pixel[3] / 255 / 4); }

Color overlay_color(PixelClass pixel_class, const std::uint8_t* pixel) {
  switch (pixel_class) {
    case PixelClass::same:
      return pale(pixel);
    case PixelClass::similar:
      return pink;
    case PixelClass::antialiased:
      return yellow;
    case PixelClass::shifted:
      return blue;
    case PixelClass::different:
      return vermilion;
  }
  return {};
}

/// Paints every pixel by what `color` says of it: the class, then the expected and the actual pixel.
template <typename ColorOf>
Image painted(const Compared& c, const ColorOf& color) {
  Image image = Image::uncleared(c.expected.width_px, c.expected.height_px);
  for (int y = 0; y < image.height_px; ++y) {
    const std::uint8_t *a = c.expected.row(y), *b = c.actual.row(y);
    std::uint8_t* out = image.row(y);
    for (int x = 0; x < image.width_px; ++x, a += 4, b += 4, out += 4) put(out, color(c.difference.map.at(x, y), a, b));
  }
  return image;
}

void hatch_ignored(Image& image, const Region& region, Color hatch) {
  if (region.is_everything()) return;
  std::vector<std::uint8_t> ignored(static_cast<std::size_t>(image.width_px));
  for (int y = 0; y < image.height_px; ++y) {
    if (region.ignored_in_row(y, ignored) == 0) continue;
    for (int x = 0; x < image.width_px; ++x) {
      const bool on_line = (x + y) % 8 < 2;
      if (ignored[static_cast<std::size_t>(x)] != 0 && on_line)
        put(image.row(y) + 4 * static_cast<std::size_t>(x), hatch);
    }
  }
}

void fill(Image& image, const PixelRect& rect, Color color) {
  const int left = std::max(rect.x_px, 0), right = std::min(rect.x_px + rect.width_px, image.width_px);
  const int top = std::max(rect.y_px, 0), bottom = std::min(rect.y_px + rect.height_px, image.height_px);
  for (int y = top; y < bottom; ++y) {
    for (int x = left; x < right; ++x) put(image.row(y) + 4 * static_cast<std::size_t>(x), color);
  }
}

/// A frame just outside of the densest window, where the picture is so large that one has to search for it.
void frame_densest(Image& image, const PixelRect& window) {
  constexpr int gap = 4, line = 2;
  if (window.width_px == 0 || image.width_px < 8 * window.width_px || image.height_px < 8 * window.height_px) return;
  const PixelRect outer{window.x_px - gap - line, window.y_px - gap - line, window.width_px + 2 * (gap + line),
                        window.height_px + 2 * (gap + line)};
  fill(image, {outer.x_px, outer.y_px, outer.width_px, line}, frame_color);
  fill(image, {outer.x_px, outer.y_px + outer.height_px - line, outer.width_px, line}, frame_color);
  fill(image, {outer.x_px, outer.y_px, line, outer.height_px}, frame_color);
  fill(image, {outer.x_px + outer.width_px - line, outer.y_px, line, outer.height_px}, frame_color);
}

Image overlay(const Compared& c, const Region& region) {
  Image image =
      painted(c, [](PixelClass k, const std::uint8_t* a, const std::uint8_t*) { return overlay_color(k, a); });
  hatch_ignored(image, region, hatch_on_pale);
  frame_densest(image, c.difference.counts.densest.rect);
  return image;
}

/// From violet to pale yellow, lighter all the way, so that it also reads in print.
Color heat_color(double part) {
  constexpr std::array<Color, 5> stops{
      {{84, 30, 130, 255}, {160, 45, 115, 255}, {222, 82, 62, 255}, {250, 160, 30, 255}, {252, 255, 170, 255}}};
  const double place = std::clamp(part, 0.0, 1.0) * (stops.size() - 1);
  const auto stop = std::min(static_cast<std::size_t>(place), stops.size() - 2);
  return mixed(stops[stop], stops[stop + 1], place - static_cast<double>(stop));
}

Image heat(const Compared& c, const Region& region) {
  Image image = painted(c, [](PixelClass k, const std::uint8_t* a, const std::uint8_t* b) {
    if (k == PixelClass::same) return dark(a);
    // The distance is a square; one root more, and faint differences have colours of their own.
    return heat_color(std::sqrt(std::sqrt(yiq_distance(a, b, 0) / largest_yiq_distance)));
  });
  hatch_ignored(image, region, hatch_on_dark);
  return image;
}

Image mask(const Compared& c) {
  return painted(c, [](PixelClass k, const std::uint8_t*, const std::uint8_t*) {
    return k == PixelClass::different ? vermilion : Color{0, 0, 0, 0};
  });
}

// Side by side: panels on a dark ground, titles above them.

constexpr int gap_px = 4, title_px = 28, letters_px = 15, least_titled_px = 140, timeline_px = 48;
constexpr Color ground{32, 36, 44, 255}, words{232, 234, 238, 255};

bool has_titles(const Image& expected, const Image& actual) {
  return std::min(expected.width_px, actual.width_px) >= least_titled_px;
}

bool same_size(const Image& a, const Image& b) { return a.width_px == b.width_px && a.height_px == b.height_px; }

std::int64_t even(std::int64_t value) { return value + value % 2; }

void copy(const Image& from, Image& to, int x_px, int y_px) {
  for (int y = 0; y < from.height_px; ++y) {
    std::copy_n(from.row(y), from.row_bytes(), to.row(y + y_px) + 4 * static_cast<std::size_t>(x_px));
  }
}

Image side_by_side(const Compared& c, const Region& region, const DiffTitles& titles) {
  const PictureSize size = diff_picture_size(DiffStyle::side, c.expected, c.actual);
  Image image = Image::uncleared(static_cast<int>(size.width_px), static_cast<int>(size.height_px));
  fill(image, {0, 0, image.width_px, image.height_px}, ground);
  const bool titled = has_titles(c.expected, c.actual);
  const Lettering letters;
  int x = 0;
  const auto add = [&](const Image& panel, const std::string& title) {
    copy(panel, image, x, titled ? title_px : 0);
    if (titled) letters.write(image, title, letters_px, x + 8, 19, x + panel.width_px - 4, words);
    x += panel.width_px + gap_px;
  };
  add(c.expected, titles.expected);
  add(c.actual, titles.actual);
  if (same_size(c.expected, c.actual)) add(heat(c, region), titles.difference);
  return image;
}

}  // namespace

std::optional<DiffStyle> diff_style_named(std::string_view name) {
  if (name == "side") return DiffStyle::side;
  if (name == "overlay") return DiffStyle::overlay;
  if (name == "heat") return DiffStyle::heat;
  if (name == "mask") return DiffStyle::mask;
  return std::nullopt;
}

PictureSize diff_picture_size(DiffStyle style, const Image& expected, const Image& actual) {
  if (style != DiffStyle::side && same_size(expected, actual)) return {expected.width_px, expected.height_px};
  std::int64_t width = std::int64_t{expected.width_px} + gap_px + actual.width_px;
  if (same_size(expected, actual)) width += gap_px + expected.width_px;
  const std::int64_t height = std::max(expected.height_px, actual.height_px);
  return {even(width), even(height + (has_titles(expected, actual) ? title_px : 0))};  // films have even sizes
}

Image diff_picture(DiffStyle style, const Compared& compared, const Region& region, const DiffTitles& titles) {
  const PictureSize size = diff_picture_size(style, compared.expected, compared.actual);
  if (size.width_px * size.height_px > max_drawn_pixels) {
    throw UsageError("Side by side these pictures are too large to be drawn: ask for --style overlay, heat or mask.");
  }
  if (style == DiffStyle::side || !compared.difference.counts.same_size) return side_by_side(compared, region, titles);
  if (style == DiffStyle::overlay) return overlay(compared, region);
  return style == DiffStyle::heat ? heat(compared, region) : mask(compared);
}

Image with_timeline(const Image& picture, const std::vector<double>& shares, std::size_t now) {
  constexpr int margin = 6;
  Image image = Image::uncleared(picture.width_px, picture.height_px + timeline_px);
  copy(picture, image, 0, 0);
  fill(image, {0, picture.height_px, image.width_px, timeline_px}, ground);
  const int width = image.width_px - 2 * margin, highest = timeline_px - 2 * margin;
  const auto x_of = [&](std::size_t frame) {
    return margin +
           static_cast<int>(static_cast<std::int64_t>(frame) * width / static_cast<std::int64_t>(shares.size()));
  };
  const int bottom = image.height_px - margin;
  fill(image, {margin, bottom, width, 1}, gray(120));
  for (std::size_t frame = 0; frame < shares.size(); ++frame) {
    const int height = static_cast<int>(std::ceil(std::sqrt(std::sqrt(shares[frame])) * highest));
    const int bar = std::max(1, x_of(frame + 1) - x_of(frame) - 1);
    fill(image, {x_of(frame), bottom - height, bar, height}, heat_color(frame == now ? 1.0 : 0.6));
  }
  fill(image, {x_of(now), picture.height_px + 2, 2, timeline_px - 4}, words);
  return image;
}

}  // namespace proofreel
