#include "render/draw_text.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

namespace proofreel {
namespace {

/// 1, 2 or 5 times a power of ten.
struct RoundStep {
  double value = 1;
  int exponent = 0;  ///< of ten
};

double power_of_ten(int exponent) {
  double power = 1;
  for (int i = 0; i < std::abs(exponent); ++i) power *= 10;
  return exponent < 0 ? 1 / power : power;
}

/// The smallest round step of at least `least`.
RoundStep round_step(double least) {
  int exponent = 0;
  while (power_of_ten(exponent) > least && exponent > -300) --exponent;
  while (10 * power_of_ten(exponent) < least && exponent < 300) ++exponent;
  for (const double digit : {1.0, 2.0, 5.0}) {
    const double step = exponent < 0 ? digit / power_of_ten(-exponent) : digit * power_of_ten(exponent);
    if (step >= least) return {step, exponent};
  }
  return {power_of_ten(exponent + 1), exponent + 1};
}

/// With a typographic minus, and none before zero.
std::string with_minus(std::string text) {
  if (text.front() != '-') return text;
  const bool zero = text.find_first_of("123456789") == std::string::npos;
  return text.replace(0, 1, zero ? "" : "\u2212");
}

}  // namespace

Ticks ticks_in(double low, double high, int most) {
  const double span = high - low;
  if (!std::isfinite(span) || span <= 0) return {low, 1, 1, 0};
  RoundStep step = round_step(span / most);
  double first = std::ceil(low / step.value - 1e-9);
  double last = std::floor(high / step.value + 1e-9);
  if (last - first >= most) {
    step = round_step(1.01 * step.value);
    first = std::ceil(low / step.value - 1e-9);
    last = std::floor(high / step.value + 1e-9);
  }
  return {first * step.value, step.value, std::max(0, static_cast<int>(last - first) + 1), std::max(0, -step.exponent)};
}

std::string number_text(double value, int decimals) {
  constexpr std::size_t longest = 8;
  std::array<char, 512> buffer{};
  auto end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value, std::chars_format::fixed, decimals);
  std::string text(buffer.data(), end.ptr);
  if (text.size() > longest || end.ec != std::errc()) {
    end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value, std::chars_format::general, 3);
    text.assign(buffer.data(), end.ptr);
  }
  return with_minus(text);
}

std::vector<std::string> wrapped(Canvas& canvas, std::string_view text, int size_px, double width) {
  std::vector<std::string> lines;
  std::string line;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find_first_of(" \n"), text.size());
    const std::string word(text.substr(0, end));
    const bool breaks = end < text.size() && text[end] == '\n';
    const std::string longer = line.empty() ? word : line + " " + word;
    if (!line.empty() && canvas.text_width(longer, size_px) > width) {
      lines.push_back(line);
      line = word;
    } else {
      line = longer;
    }
    if (breaks) {
      lines.push_back(line);
      line.clear();
    }
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  if (!line.empty()) lines.push_back(line);
  return lines;
}

std::string shortened(Canvas& canvas, const std::string& text, int size_px, double width) {
  std::string line = text;
  std::replace(line.begin(), line.end(), '\n', ' ');
  if (canvas.text_width(line, size_px) <= width) return line;
  std::size_t end = line.size();
  const auto cut = [&] { return line.substr(0, end) + "\u2026"; };
  while (end > 0 && canvas.text_width(cut(), size_px) > width) {
    do --end;
    while (end > 0 && (static_cast<unsigned char>(line[end]) & 0xC0U) == 0x80U);  // no half characters
  }
  return cut();
}

}  // namespace proofreel
