#include "lab/page_picture.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <string>

#include "render/lettering.h"

namespace proofreel {
namespace {

constexpr Color ink{30, 33, 40, 255}, heading{20, 60, 130, 255};
constexpr int margin_px = 120, letters_px = 26, line_px = 40, lines_per_paragraph = 9, paragraphs_per_photo = 6;

/// Numbers that look random and are the same everywhere.
class Dice {
 public:
  explicit Dice(std::uint32_t seed) : state_(seed * 2654435761U + 1) {}
  std::uint32_t roll(std::uint32_t sides) {
    state_ = state_ * 1664525U + 1013904223U;
    return (state_ >> 16U) % sides;
  }

 private:
  std::uint32_t state_;
};

std::string line_of_words(Dice& dice) {
  constexpr std::array<const char*, 16> words{"body",    "contact", "island",   "of",     "the",   "rests",
                                              "impulse", "on",      "friction", "a",      "joint", "carries",
                                              "that",    "chain",   "without",  "sinking"};
  std::string line;
  while (line.size() < 78) line.append(words[dice.roll(words.size())]).append(" ");
  return line;
}

void draw_paragraph(Image& page, const Lettering& letters, int x, int y, std::uint32_t seed) {
  Dice dice(seed);
  letters.write(page, "On " + line_of_words(dice).substr(0, 30), 38, {x, y, page.width_px}, heading);
  for (int line = 1; line < lines_per_paragraph; ++line) {
    letters.write(page, line_of_words(dice), letters_px, {x, y + line * line_px, page.width_px}, ink);
  }
}

/// Soft colours with grain, as cameras give them.
void draw_photo(Image& page, int x, int y, int width, int height, std::uint32_t seed) {
  Dice dice(seed);
  const int warm = static_cast<int>(dice.roll(120));
  for (int v = y; v < std::min(y + height, page.height_px); ++v) {
    for (int u = x; u < std::min(x + width, page.width_px); ++u) {
      const int grain = static_cast<int>(dice.roll(9));
      std::uint8_t* pixel = page.row(v) + 4 * static_cast<std::size_t>(u);
      pixel[0] = static_cast<std::uint8_t>(warm + (u - x) * 100 / width + grain);
      pixel[1] = static_cast<std::uint8_t>(60 + (v - y) * 120 / height + grain);
      pixel[2] = static_cast<std::uint8_t>(220 - warm - (v - y) * 60 / height + grain);
    }
  }
}

}  // namespace

Image page_picture(int width_px, int height_px, bool changed) {
  Image page(width_px, height_px);
  std::fill(page.rgba.begin(), page.rgba.end(), std::uint8_t{255});
  const Lettering letters;
  const int column = (width_px - 3 * margin_px) / 2, paragraph_px = (lines_per_paragraph + 2) * line_px;
  std::uint32_t number = 0;
  for (int y = margin_px; y + paragraph_px < height_px; y += paragraph_px) {
    for (const int x : {margin_px, 2 * margin_px + column}) {
      ++number;
      const bool photo = number % paragraphs_per_photo == 0;
      const bool other = changed && (photo ? number == 3 * paragraphs_per_photo : number % 8 == 1);
      const std::uint32_t seed = number + (other ? 1000U : 0U);
      if (photo) {
        draw_photo(page, x, y, column, paragraph_px - line_px, seed);
      } else {
        draw_paragraph(page, letters, x, y, seed);
      }
    }
  }
  return page;
}

}  // namespace proofreel
