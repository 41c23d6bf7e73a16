#pragma once

/// Pictures of a difference, for people.

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "golden/diff_paint.h"
#include "render/lettering.h"

namespace proofreel {

/// How a difference is shown.
/// - side: expected, actual and heat side by side, with titles;
/// - overlay: the expected picture pale and gray, different pixels vermilion, antialiased ones yellow, shifted ones
///   blue, similar ones pink, ignored ones hatched, and a frame round the densest window;
/// - heat: the expected picture dark and gray, and in it every pixel that is not equal, from violet (hardly visible) to
///   pale yellow (black against white);
/// - mask: different pixels vermilion, all else transparent.
enum class DiffStyle : std::uint8_t { side, overlay, heat, mask };
std::optional<DiffStyle> diff_style_named(std::string_view name);

/// The most pixels a picture of a difference may have: with what encoding it takes, 1.6 GB of memory.
inline constexpr std::int64_t max_drawn_pixels = 120'000'000;

/// What stands above the panels of a picture side by side; too narrow ones have none.
struct DiffTitles {
  std::string expected;
  std::string actual;
  std::string difference;
};

/// The size of what `diff_picture` gives, in pixels: width and height.
struct PictureSize {
  std::int64_t width_px = 0;
  std::int64_t height_px = 0;
};
PictureSize diff_picture_size(DiffStyle style, const Image& expected, const Image& actual);

/// Pictures of different size are always shown side by side, without heat. `region` is what was compared. Throws
/// UsageError when the result would have more than max_drawn_pixels.
Image diff_picture(DiffStyle style, const Compared& compared, const Region& region, const DiffTitles& titles);

/// Adds a strip below the picture: one bar per frame, as high as the fourth root of the share of pixels that differ (so
/// that one pixel shows), the frame `now` marked.
Image with_timeline(const Image& picture, const std::vector<double>& shares, std::size_t now);

}  // namespace proofreel
