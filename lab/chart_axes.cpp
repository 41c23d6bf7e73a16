#include "lab/chart_axes.h"

#include <algorithm>
#include <array>
#include <limits>

#include "render/draw_text.h"

namespace proofreel {
namespace {

/// Grows around values, and leaves some room.
class Range {
 public:
  void take(double place) {
    low_ = std::min(low_, place);
    high_ = std::max(high_, place);
  }
  void apply(Scale& scale) const {
    if (low_ > high_) return;
    const double least = scale.logarithmic ? 0.5 : 1e-9 * std::max(1.0, std::abs(high_));
    const double room = std::max((high_ - low_) * 0.05, least / 2);
    scale.low = low_ - room;
    scale.high = high_ + room;
  }

 private:
  double low_ = std::numeric_limits<double>::infinity();
  double high_ = -std::numeric_limits<double>::infinity();
};

void fit(const ChartAxis& axis, Scale& scale) {
  if (!axis.range) return;
  Range range;
  range.take(scale.place(axis.range->x));
  range.take(scale.place(axis.range->y));
  range.apply(scale);
}

std::vector<Tick> linear_ticks(const Scale& scale) {
  const Ticks ticks = ticks_in(scale.low, scale.high, 8);
  std::vector<Tick> list;
  for (int i = 0; i < ticks.count; ++i) list.push_back({ticks.at(i), number_text(ticks.at(i), ticks.decimals)});
  return list;
}

/// Whole powers of ten; twice and five times these too where there are few of them.
std::vector<Tick> power_ticks(const Scale& scale) {
  const double span = scale.high - scale.low;
  constexpr double readable_px = 46;
  const double per_decade_px = std::abs(scale.last_px - scale.first_px) / span;
  const int every = std::max(1, static_cast<int>(std::ceil(readable_px / per_decade_px)));
  std::vector<Tick> list;
  for (int e = static_cast<int>(std::floor(scale.low)); e <= static_cast<int>(std::ceil(scale.high)); ++e) {
    for (int digit = 1; digit <= 9; ++digit) {
      const double value = digit * std::pow(10.0, e);
      if (std::log10(value) < scale.low || std::log10(value) > scale.high) continue;
      const bool told = digit == 1 ? e % every == 0 : span < 2 && (digit == 2 || digit == 5);
      const std::string text = !told ? ""
                               : digit == 1 || e < -3 || e > 3
                                   ? (digit == 1 ? "" : std::to_string(digit) + "\u00B7") + power_of_ten(e)
                                   : number_text(value, std::max(0, -e));
      if (digit == 1 || span < 6) list.push_back({value, text});
    }
  }
  return list;
}

}  // namespace

void fit(const Chart& chart, Scale& x, Scale& y) {
  Range xs;
  Range ys;
  const auto take = [&](Vec2d p) {
    if (!x.holds(p.x) || !y.holds(p.y)) return;
    xs.take(x.place(p.x));
    ys.take(y.place(p.y));
  };
  for (const ChartCurve& curve : chart.curves) {
    for (const ChartPoint& point : curve.points) take(point.at);
    for (const ChartPoint& failure : curve.failures) {
      if (x.holds(failure.at.x)) xs.take(x.place(failure.at.x));
    }
    if (curve.floor && y.holds(*curve.floor)) ys.take(y.place(*curve.floor));
  }
  xs.apply(x);
  ys.apply(y);
  fit(chart.x, x);
  fit(chart.y, y);
}

std::vector<Tick> ticks_of(const Scale& scale) { return scale.logarithmic ? power_ticks(scale) : linear_ticks(scale); }

std::string power_of_ten(int exponent) {
  constexpr std::array<const char*, 10> raised{"\u2070", "\u00B9", "\u00B2", "\u00B3", "\u2074",
                                               "\u2075", "\u2076", "\u2077", "\u2078", "\u2079"};
  if (exponent == 0) return "1";
  if (exponent == 1) return "10";
  std::string text = exponent < 0 ? "10\u207B" : "10";
  for (const char digit : std::to_string(std::abs(exponent))) text += raised[static_cast<std::size_t>(digit - '0')];
  return text;
}

}  // namespace proofreel
