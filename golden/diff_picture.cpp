#include "golden/diff_picture.h"

#include <algorithm>
#include <cmath>

#include "golden/diff_paint.h"
#include "render/usage_error.h"

namespace proofreel {
namespace {

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
  fill_rect(image, {0, 0, image.width_px, image.height_px}, ground);
  const bool titled = has_titles(c.expected, c.actual);
  const Lettering letters;
  int x = 0;
  const auto add = [&](const Image& panel, const std::string& title) {
    copy(panel, image, x, titled ? title_px : 0);
    if (titled) letters.write(image, title, letters_px, {x + 8, 19, x + panel.width_px - 4}, words);
    x += panel.width_px + gap_px;
  };
  add(c.expected, titles.expected);
  add(c.actual, titles.actual);
  if (same_size(c.expected, c.actual)) add(heat_picture(c, region), titles.difference);
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
  if (style == DiffStyle::overlay) return overlay_picture(compared, region);
  return style == DiffStyle::heat ? heat_picture(compared, region) : mask_picture(compared);
}

Image with_timeline(const Image& picture, const std::vector<double>& shares, std::size_t now) {
  constexpr int margin = 6;
  Image image = Image::uncleared(picture.width_px, picture.height_px + timeline_px);
  copy(picture, image, 0, 0);
  fill_rect(image, {0, picture.height_px, image.width_px, timeline_px}, ground);
  const int width = image.width_px - 2 * margin, highest = timeline_px - 2 * margin;
  const auto x_of = [&](std::size_t frame) {
    return margin +
           static_cast<int>(static_cast<std::int64_t>(frame) * width / static_cast<std::int64_t>(shares.size()));
  };
  const int bottom = image.height_px - margin;
  fill_rect(image, {margin, bottom, width, 1}, Color{120, 120, 120, 255});
  for (std::size_t frame = 0; frame < shares.size(); ++frame) {
    const int height = static_cast<int>(std::ceil(std::sqrt(std::sqrt(shares[frame])) * highest));
    const int bar = std::max(1, x_of(frame + 1) - x_of(frame) - 1);
    fill_rect(image, {x_of(frame), bottom - height, bar, height}, heat_color(frame == now ? 1.0 : 0.6));
  }
  fill_rect(image, {x_of(now), picture.height_px + 2, 2, timeline_px - 4}, words);
  return image;
}

}  // namespace proofreel
