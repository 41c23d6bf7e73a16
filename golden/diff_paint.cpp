#include "golden/diff_paint.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "golden/yiq.h"

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

/// A frame just outside of the densest window, where the picture is so large that one has to search for it.
void frame_densest(Image& image, const PixelRect& window) {
  constexpr int gap = 4, line = 2;
  if (window.width_px == 0 || image.width_px < 8 * window.width_px || image.height_px < 8 * window.height_px) return;
  const PixelRect outer{window.x_px - gap - line, window.y_px - gap - line, window.width_px + 2 * (gap + line),
                        window.height_px + 2 * (gap + line)};
  fill_rect(image, {outer.x_px, outer.y_px, outer.width_px, line}, frame_color);
  fill_rect(image, {outer.x_px, outer.y_px + outer.height_px - line, outer.width_px, line}, frame_color);
  fill_rect(image, {outer.x_px, outer.y_px, line, outer.height_px}, frame_color);
  fill_rect(image, {outer.x_px + outer.width_px - line, outer.y_px, line, outer.height_px}, frame_color);
}

}  // namespace

void fill_rect(Image& image, const PixelRect& rect, Color color) {
  const int left = std::max(rect.x_px, 0), right = std::min(rect.x_px + rect.width_px, image.width_px);
  const int top = std::max(rect.y_px, 0), bottom = std::min(rect.y_px + rect.height_px, image.height_px);
  for (int y = top; y < bottom; ++y) {
    for (int x = left; x < right; ++x) put(image.row(y) + 4 * static_cast<std::size_t>(x), color);
  }
}

Color heat_color(double part) {
  constexpr std::array<Color, 5> stops{
      {{84, 30, 130, 255}, {160, 45, 115, 255}, {222, 82, 62, 255}, {250, 160, 30, 255}, {252, 255, 170, 255}}};
  const double place = std::clamp(part, 0.0, 1.0) * (stops.size() - 1);
  const auto stop = std::min(static_cast<std::size_t>(place), stops.size() - 2);
  return mixed(stops[stop], stops[stop + 1], place - static_cast<double>(stop));
}

Image overlay_picture(const Compared& c, const Region& region) {
  Image image =
      painted(c, [](PixelClass k, const std::uint8_t* a, const std::uint8_t*) { return overlay_color(k, a); });
  hatch_ignored(image, region, hatch_on_pale);
  frame_densest(image, c.difference.counts.densest.rect);
  return image;
}

Image heat_picture(const Compared& c, const Region& region) {
  Image image = painted(c, [](PixelClass k, const std::uint8_t* a, const std::uint8_t* b) {
    if (k == PixelClass::same) return dark(a);
    // The distance is a square; one root more, and faint differences have colours of their own.
    return heat_color(std::sqrt(std::sqrt(yiq_distance(a, b, 0) / largest_yiq_distance)));
  });
  hatch_ignored(image, region, hatch_on_dark);
  return image;
}

Image mask_picture(const Compared& c) {
  return painted(c, [](PixelClass k, const std::uint8_t*, const std::uint8_t*) {
    return k == PixelClass::different ? vermilion : Color{0, 0, 0, 0};
  });
}

}  // namespace proofreel
