#include "render/title_card.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "render/draw_text.h"
#include "render/theme.h"
#include "render/usage_error.h"

namespace proofreel {
namespace {

/// Lines of one size.
struct Paragraph {
  std::vector<std::string> lines;
  int size_px = 0;
  double height() const {
    return lines.empty() ? 0 : (cap_height + static_cast<double>(lines.size() - 1) * line_height) * size_px;
  }
};

bool fits_across(Canvas& canvas, const Paragraph& paragraph, double width) {
  return std::all_of(paragraph.lines.begin(), paragraph.lines.end(),
                     [&](const std::string& line) { return canvas.text_width(line, paragraph.size_px) <= width; });
}

/// In at most so many lines that all fit into `width`; in smaller letters where need be, down to `smallest_px`.
Paragraph fitting(Canvas& canvas, const std::string& text, int size_px, int smallest_px, double width,
                  std::size_t lines) {
  const auto fits = [&](const Paragraph& paragraph) {
    return paragraph.lines.size() <= lines && fits_across(canvas, paragraph, width);
  };
  Paragraph paragraph{wrapped(canvas, text, size_px, width), size_px};
  while (!fits(paragraph) && paragraph.size_px > smallest_px) {
    --paragraph.size_px;
    paragraph.lines = wrapped(canvas, text, paragraph.size_px, width);
  }
  return paragraph;
}

void draw_paragraph(Canvas& canvas, const Paragraph& paragraph, Vec2d top_left, Color color) {
  double baseline = top_left.y + cap_height * paragraph.size_px;
  for (const std::string& line : paragraph.lines) {
    canvas.text(line, {top_left.x, baseline}, paragraph.size_px, Align::left, color);
    baseline += line_height * paragraph.size_px;
  }
}

/// How far the film has come from the card to its first picture, 0..1.
double way_to_first(std::int64_t i, std::int64_t count, int fps) {
  const std::int64_t fade = std::min<std::int64_t>(count / 2, 4 * fps / 5);
  const std::int64_t done = i - (count - fade) + 1;
  return done <= 0 ? 0 : static_cast<double>(done) / static_cast<double>(fade + 1);
}

/// Starts and ends at rest; 0..256.
int eased(double part) {
  const double s = std::clamp(part, 0.0, 1.0);
  return static_cast<int>(256 * s * s * (3 - 2 * s) + 0.5);
}

/// `share` of 256 of the image, the rest of the colour.
void mix(const Image& image, Color color, int share, Image& out) {
  out = image;
  const std::array<int, 4> behind{color.r, color.g, color.b, color.a};
  for (std::size_t k = 0; k < out.rgba.size(); ++k)
    out.rgba[k] = static_cast<std::uint8_t>((image.rgba[k] * share + behind[k % 4] * (256 - share) + 128) / 256);
}

}  // namespace

void draw_title_card(Canvas& canvas, const TitleCard& card, Theme theme, Image& image) {
  const Palette& palette = palette_of(theme);
  const Sizes sizes = sizes_of(canvas.width_px(), canvas.height_px());
  const double left = std::floor(std::max(sizes.margin, 0.09 * canvas.width_px()));
  const double width = canvas.width_px() - 2 * left;
  constexpr std::size_t most_title_lines = 3, most_lines = 6;
  const Paragraph title = fitting(canvas, card.title, 7 * sizes.title / 5, sizes.text, width, most_title_lines);
  const Paragraph description = fitting(canvas, card.description, sizes.text, sizes.small, width, most_lines);
  const double gap = std::round(0.7 * sizes.title);
  const double rule = std::max(2.0, std::round(3 * sizes.unit));
  const double whole = title.height() + (description.lines.empty() ? 0 : 2 * gap + rule + description.height());
  if (whole > canvas.height_px() - 2 * sizes.margin || !fits_across(canvas, title, width) ||
      !fits_across(canvas, description, width))
    throw UsageError("--title-card: title and description do not fit into a picture of " +
                     std::to_string(canvas.width_px()) + "x" + std::to_string(canvas.height_px()) +
                     ": choose a larger --size, or shorten them.");
  double y = std::floor(0.46 * (canvas.height_px() - whole));  // the eye's middle lies above the ruler's
  canvas.clear(palette.background);
  draw_paragraph(canvas, title, {left, y}, palette.ink);
  y = std::floor(y + title.height() + gap);
  if (!description.lines.empty()) {
    const Color accent = palette.curves[0];
    canvas.rectangle({left, y}, {left + 2.0 * sizes.title, y + rule}, 0, {accent, accent, 0});
    draw_paragraph(canvas, description, {left, y + rule + gap}, palette.quiet_ink);
  }
  canvas.finish(image);
}

void mix_into(const Image& card, const Image& first, Theme theme, std::int64_t i, std::int64_t count, int fps,
              Image& out) {
  const double way = way_to_first(i, count, fps);
  const Color background = palette_of(theme).background;
  if (way < 0.5) return mix(card, background, 256 - eased(2 * way), out);
  mix(first, background, eased(2 * way - 1), out);
}

}  // namespace proofreel
