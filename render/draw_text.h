#pragma once

/// Numbers on axes and lines of text.

#include <string>
#include <string_view>
#include <vector>

#include "render/canvas.h"

namespace proofreel {

/// Capital letters and digits of the typeface reach this part of the em above the baseline.
inline constexpr double cap_height = 0.73;
/// From one baseline to the next, in em.
inline constexpr double line_height = 1.3;

/// Ticks of an axis at 1, 2 or 5 times a power of ten.
struct Ticks {
  double first = 0;
  double step = 1;
  int count = 0;
  int decimals = 0;  ///< digits after the point that tell them apart
  double at(int i) const { return first + i * step; }
};

/// The ticks in [low, high], at most `most` of them (2 or more), as close as that allows.
Ticks ticks_in(double low, double high, int most);

/// With a typographic minus, and in powers of ten where a plain number would be longer than eight characters. The same
/// in every locale.
std::string number_text(double value, int decimals);

/// Breaks a text into lines no wider than `width` where it has spaces; a longer word has a line of its own.
std::vector<std::string> wrapped(Canvas& canvas, std::string_view text, int size_px, double width);

/// On one line and no wider than `width`: what is too long ends in three dots.
std::string shortened(Canvas& canvas, const std::string& text, int size_px, double width);

}  // namespace proofreel
