#include "golden/difference.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <future>

#include "golden/compare_rows.h"
#include "golden/densest.h"
#include "golden/flat_rows.h"
#include "golden/yiq.h"
#include "render/usage_error.h"
#include "scenarios/formatted.h"

namespace proofreel {
namespace {

/// What the rows compared so far add up to.
struct Sums {
  std::int64_t total = 0, unequal = 0, different = 0, antialiased = 0, shifted = 0;
  int max_channel = 0;
  std::array<std::int64_t, 3> bias{}, forgiven_bias{};

  void add(const RowSums& row) {
    unequal += row.different;
    max_channel = std::max(max_channel, row.max_channel);
    for (std::size_t i = 0; i < 3; ++i) bias[i] += row.bias[i];
  }
  void add(const Sums& other) {
    total += other.total, unequal += other.unequal, different += other.different;
    antialiased += other.antialiased, shifted += other.shifted;
    max_channel = std::max(max_channel, other.max_channel);
    for (std::size_t i = 0; i < 3; ++i) bias[i] += other.bias[i], forgiven_bias[i] += other.forgiven_bias[i];
  }
};

/// Compares some rows of two pictures. One object per thread; they write to different rows of one map.
class Comparer {
 public:
  Comparer(const Image& a, const Image& b, const DifferenceSettings& settings, DifferenceMap& map)
      : a_(a),
        b_(b),
        settings_(settings),
        map_(map),
        most_(largest_yiq_distance * settings.threshold * settings.threshold),
        flat_(a, b),
        ignored_(settings.region.is_everything() ? 0 : static_cast<std::size_t>(a.width_px)),
        row_of_b_(settings.region.is_everything() ? 0 : a.row_bytes()) {}

  Sums rows(int first, int end) {
    for (int y = first; y < end; ++y) compare_row(y);
    return sums_;
  }

 private:
  void compare_row(int y) {
    sums_.total += a_.width_px;
    const std::uint8_t* b = b_.row(y);
    if (!settings_.region.is_everything()) b = without_ignored(y);
    if (std::memcmp(a_.row(y), b, a_.row_bytes()) == 0) return;
    sums_.add(sums_of_row(a_.row(y), b, a_.width_px, 0));
    std::vector<PixelClass>& classes = map_.make_row(y);
    mark_row(a_.row(y), b, a_.width_px, most_, reinterpret_cast<std::uint8_t*>(classes.data()));
    classify(y, classes);
  }

  /// Row `y` of B with what is ignored replaced by A.
  const std::uint8_t* without_ignored(int y) {
    const int ignored = settings_.region.ignored_in_row(y, ignored_);
    if (ignored == 0) return b_.row(y);
    sums_.total -= ignored;
    std::copy_n(b_.row(y), row_of_b_.size(), row_of_b_.begin());
    for (std::size_t x = 0; x < ignored_.size(); ++x) {
      if (ignored_[x] != 0) std::copy_n(a_.row(y) + 4 * x, 4, &row_of_b_[4 * x]);
    }
    return row_of_b_.data();
  }

  /// Replaces candidates by what they are; each is looked at once, whatever it becomes.
  void classify(int y, std::vector<PixelClass>& classes) {
    static_assert(static_cast<int>(PixelClass::same) == equal_pixel);
    static_assert(static_cast<int>(PixelClass::similar) == close_pixel);
    constexpr auto candidate = static_cast<PixelClass>(candidate_pixel);
    for (auto pixel = classes.begin(); (pixel = std::find(pixel, classes.end(), candidate)) != classes.end(); ++pixel) {
      const auto x = static_cast<int>(pixel - classes.begin());
      *pixel = class_of(x, y);
      count(*pixel, x, y);
    }
  }

  PixelClass class_of(int x, int y) {
    if (yiq_distance(pixel(a_, x, y), pixel(b_, x, y), index_of(x, y)) <= most_) return PixelClass::similar;
    if (!settings_.count_antialiased && looks_antialiased(x, y)) return PixelClass::antialiased;
    if (settings_.shift_px > 0 && is_near(a_, b_, x, y) && is_near(b_, a_, x, y)) return PixelClass::shifted;
    return PixelClass::different;
  }

  bool looks_antialiased(int x, int y) {
    flat_.move_to(y);
    return is_antialiased(a_, flat_, x, y) || is_antialiased(b_, flat_, x, y);
  }

  /// Whether the colour of `image` there is found nearby in `other`.
  bool is_near(const Image& image, const Image& other, int x, int y) const {
    const int r = settings_.shift_px;
    for (int v = std::max(0, y - r); v <= std::min(other.height_px - 1, y + r); ++v) {
      for (int u = std::max(0, x - r); u <= std::min(other.width_px - 1, x + r); ++u) {
        if (yiq_distance(pixel(image, x, y), pixel(other, u, v), index_of(x, y)) <= most_) return true;
      }
    }
    return false;
  }

  void count(PixelClass found, int x, int y) {
    if (found == PixelClass::different) ++sums_.different;
    if (found == PixelClass::antialiased) ++sums_.antialiased;
    if (found == PixelClass::shifted) ++sums_.shifted;
    if (found != PixelClass::antialiased && found != PixelClass::shifted) return;
    for (std::size_t i = 0; i < 3; ++i) sums_.forgiven_bias[i] += pixel(b_, x, y)[i] - pixel(a_, x, y)[i];
  }

  static const std::uint8_t* pixel(const Image& image, int x, int y) {
    return image.row(y) + 4 * static_cast<std::size_t>(x);
  }
  std::int64_t index_of(int x, int y) const { return static_cast<std::int64_t>(y) * a_.width_px + x; }

  const Image& a_;
  const Image& b_;
  const DifferenceSettings& settings_;
  DifferenceMap& map_;
  double most_;  ///< the largest distance that is not different
  FlatRows flat_;
  std::vector<std::uint8_t> ignored_;
  std::vector<std::uint8_t> row_of_b_;
  Sums sums_;
};

/// Compares all rows, in bands side by side.
Sums compare_all(const Image& a, const Image& b, const DifferenceSettings& settings, DifferenceMap& map) {
  constexpr int least_rows = 64;  // a thread has to be worth starting
  const int bands = std::clamp(a.height_px / least_rows, 1, std::max(1, settings.threads));
  const auto first_of = [&](int band) {
    return static_cast<int>(static_cast<std::int64_t>(a.height_px) * band / bands);
  };
  std::vector<std::future<Sums>> others;
  for (int band = 1; band < bands; ++band) {
    others.push_back(std::async(std::launch::async, [&, band] {
      return Comparer(a, b, settings, map).rows(first_of(band), first_of(band + 1));
    }));
  }
  Sums sums = Comparer(a, b, settings, map).rows(0, first_of(1));
  for (std::future<Sums>& other : others) sums.add(other.get());
  return sums;
}

DifferenceCounts counts_of(const Sums& sums) {
  DifferenceCounts counts;
  counts.total = sums.total, counts.unequal = sums.unequal, counts.different = sums.different;
  counts.antialiased = sums.antialiased, counts.shifted = sums.shifted;
  counts.max_channel = sums.max_channel;
  if (sums.total == 0) return counts;
  for (std::size_t i = 0; i < 3; ++i) {
    counts.mean_bias[i] = static_cast<double>(sums.bias[i]) / static_cast<double>(sums.total);
    counts.quiet_bias[i] = static_cast<double>(sums.bias[i] - sums.forgiven_bias[i]) / static_cast<double>(sums.total);
  }
  return counts;
}

void check_mask(const Region& region, const Image& a) {
  if (region.has_room_for(a.width_px, a.height_px)) return;
  const auto text = [](const Image& i) { return std::to_string(i.width_px) + "x" + std::to_string(i.height_px); };
  throw UsageError("The mask is " + text(*region.mask()) + ", but the pictures are " + text(a) +
                   ": a mask has the size of the pictures.");
}

std::string rounded(double value) { return formatted("%.3g", value); }

}  // namespace

Difference difference_between(const Image& a, const Image& b, const DifferenceSettings& settings) {
  Difference difference;
  difference.counts.same_size = a.width_px == b.width_px && a.height_px == b.height_px;
  if (!difference.counts.same_size) return difference;
  check_mask(settings.region, a);
  difference.map = DifferenceMap(a.width_px, a.height_px);
  difference.counts = counts_of(compare_all(a, b, settings, difference.map));
  if (difference.counts.different > 0) difference.counts.densest = densest_window(difference.map, settings.window_px);
  return difference;
}

std::string broken_limit(const DifferenceCounts& counts, const DifferenceLimits& limits) {
  if (!counts.same_size) return "the sizes differ";
  if (counts.different > limits.different) {
    return std::to_string(counts.different) + " pixels differ, " + std::to_string(limits.different) + " may";
  }
  if (limits.window && counts.densest.different > *limits.window) {
    return std::to_string(counts.densest.different) + " pixels of one window differ, " +
           std::to_string(*limits.window) + " may";
  }
  constexpr std::array<const char*, 3> names{"red", "green", "blue"};
  for (std::size_t i = 0; i < 3; ++i) {
    if (std::abs(counts.quiet_bias[i]) <= limits.bias) continue;
    return std::string(names[i]) + " is " + rounded(counts.quiet_bias[i]) + " of 255 off on average, " +
           rounded(limits.bias) + " is allowed";
  }
  return {};
}

}  // namespace proofreel
