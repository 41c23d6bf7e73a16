#include "golden/likeness.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <cstring>

#include "golden/words.h"

namespace proofreel {
namespace {

/// How far the actual picture is right of and below the expected one.
struct Shift {
  int x = 0;
  int y = 0;
};

/// Whether all of the picture that is in both, when moved back, is the same.
bool is_shifted_by(const Image& expected, const Image& actual, Shift by) {
  const int first_x = std::max(0, by.x), width = expected.width_px - std::abs(by.x);
  for (int y = std::max(0, by.y); y < expected.height_px + std::min(0, by.y); ++y) {
    const std::uint8_t* then = expected.row(y - by.y) + 4 * static_cast<std::size_t>(first_x - by.x);
    const std::uint8_t* now = actual.row(y) + 4 * static_cast<std::size_t>(first_x);
    if (std::memcmp(then, now, 4 * static_cast<std::size_t>(width)) != 0) return false;
  }
  return true;
}

constexpr int most_shift_px = 3;

/// What of the picture no such shift can move out of it.
bool is_inner(const Image& image, int x, int y) {
  return x >= most_shift_px && y >= most_shift_px && x < image.width_px - most_shift_px &&
         y < image.height_px - most_shift_px;
}

std::string text_of(Shift shift) {
  std::string text;
  if (shift.x != 0) text = words({std::to_string(std::abs(shift.x)), " px ", shift.x > 0 ? "right" : "left"});
  if (shift.x != 0 && shift.y != 0) text.append(" and ");
  if (shift.y != 0) text.append(words({std::to_string(std::abs(shift.y)), " px ", shift.y > 0 ? "down" : "up"}));
  return text;
}

std::string shift_between(const Image& expected, const Image& actual) {
  if (expected.width_px <= 2 * most_shift_px || expected.height_px <= 2 * most_shift_px) return "";
  for (int y = -most_shift_px; y <= most_shift_px; ++y) {
    for (int x = -most_shift_px; x <= most_shift_px; ++x) {
      const Shift shift{x, y};
      if ((x != 0 || y != 0) && is_shifted_by(expected, actual, shift)) {
        return words({"It is the reference moved ", text_of(shift), "."});
      }
    }
  }
  return "";
}

/// What all pixels that differ have in common, and how many of them lie where no shift would lose them.
struct Common {
  std::array<int, 3> first{};
  std::array<double, 3> sum{}, squares{};
  bool uniform = true;
  std::int64_t different = 0;
  std::int64_t inner = 0;
};

void add_pixel(Common& common, const std::uint8_t* then, const std::uint8_t* now) {
  for (std::size_t i = 0; i < 3; ++i) {
    const int difference = now[i] - then[i];
    if (common.different == 0) common.first[i] = difference;
    common.uniform = common.uniform && common.first[i] == difference;
    common.sum[i] += difference;
    common.squares[i] += difference * difference;
  }
  ++common.different;
}

Common common_of(const Image& expected, const Image& actual) {
  Common common;
  for (int y = 0; y < actual.height_px; ++y) {
    if (std::memcmp(expected.row(y), actual.row(y), actual.row_bytes()) == 0) continue;
    for (int x = 0; x < actual.width_px; ++x) {
      if (std::memcmp(expected.row(y) + 4 * x, actual.row(y) + 4 * x, 4) == 0) continue;
      add_pixel(common, expected.row(y) + 4 * x, actual.row(y) + 4 * x);
      common.inner += is_inner(actual, x, y) ? 1 : 0;
    }
  }
  return common;
}

std::string channels_text(const std::array<double, 3>& by) {
  constexpr std::array<const char*, 3> names{"red ", "green ", "blue "};
  std::string text;
  for (std::size_t i = 0; i < 3; ++i) {
    const auto rounded = static_cast<int>(by[i] < 0 ? by[i] - 0.5 : by[i] + 0.5);
    text.append(i > 0 ? ", " : "").append(names[i]).append(rounded > 0 ? "+" : "").append(std::to_string(rounded));
  }
  return text;
}

/// Whether all differ by about the same, and by little: what is merely other scatters.
bool is_tint(const Common& common, const std::array<double, 3>& mean) {
  constexpr double most = 64;
  double largest = 0, scatter = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const double variance = common.squares[i] / static_cast<double>(common.different) - mean[i] * mean[i];
    largest = std::max(largest, std::abs(mean[i]));
    scatter = std::max(scatter, std::sqrt(std::max(0.0, variance)));
  }
  return largest >= 0.5 && largest <= most && scatter <= 0.5 * largest;
}

std::string tint_of(const Common& common, std::int64_t total) {
  constexpr double whole_picture = 0.9;
  const auto count = static_cast<double>(common.different);
  std::array<double, 3> mean{};
  for (std::size_t i = 0; i < 3; ++i) mean[i] = common.sum[i] / count;
  if (count >= whole_picture * static_cast<double>(total) && is_tint(common, mean)) {
    const char* end = common.uniform ? " of 255." : " of 255 on average.";
    return words({"The whole picture is tinted: ", channels_text(mean), end});
  }
  if (!common.uniform || common.different < 2) return "";
  return words({"All of them differ by the same: ", channels_text(mean), " of 255."});
}

}  // namespace

std::string likeness(const Image& expected, const Image& actual) {
  const Common common = common_of(expected, actual);
  if (common.different == 0) return "";
  if (2 * common.inner > common.different) {
    const std::string shift = shift_between(expected, actual);
    if (!shift.empty()) return shift;
  }
  return tint_of(common, static_cast<std::int64_t>(actual.width_px) * actual.height_px);
}

}  // namespace proofreel
