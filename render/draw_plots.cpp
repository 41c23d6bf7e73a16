#include <algorithm>
#include <cmath>
#include <limits>

#include "render/draw_layers.h"
#include "render/draw_text.h"

namespace proofreel {
namespace {

struct Range {
  double low = 0;
  double high = 1;
};

/// The time axis: as wide as asked for, its end at the latest sample once there are enough.
Range time_range(const PlotView& plot) {
  const double now = plot.times.empty() ? 0 : plot.times.back();
  const double from = std::max(0.0, now - plot.seconds);
  return {from, from + plot.seconds};
}

/// The value axis holds all samples so far, so that it changes seldom, and ends at ticks.
Range value_range(const PlotView& plot, int most_ticks) {
  constexpr double none = std::numeric_limits<double>::max();
  Range range{none, -none};
  for (const std::vector<double>& values : plot.values) {
    for (const double value : values) {
      if (!std::isfinite(value)) continue;
      range.low = std::min(range.low, value);
      range.high = std::max(range.high, value);
    }
  }
  if (range.low > range.high) return {0, 1};
  const double size = std::max(std::abs(range.low), std::abs(range.high));
  if (range.low > 0 && range.low < 0.5 * range.high) range.low = 0;
  if (range.high < 0 && range.high > 0.5 * range.low) range.high = 0;
  // A curve that is flat so far, or only begins, gets room around it instead of an axis of its last digits.
  if (size == 0) return {0, 1};
  if (range.high - range.low <= 1e-6 * size) range = {range.low - 0.1 * size, range.high + 0.1 * size};
  const double step = ticks_in(range.low, range.high, most_ticks).step;
  return {std::floor(range.low / step + 1e-9) * step, std::ceil(range.high / step - 1e-9) * step};
}

/// A chart's card and what lies where on it, in pixels.
struct Chart {
  const PlotView* plot = nullptr;
  Aabbd card;
  Aabbd area;  ///< where the curves are
  Range times;
  Range values;
  Ticks time_ticks;
  Ticks value_ticks;
  int size = 0;  ///< of its text
  double x(double time) const {
    return area.lower.x + (time - times.low) / (times.high - times.low) * (area.upper.x - area.lower.x);
  }
  double y(double value) const {
    return area.upper.y - (value - values.low) / (values.high - values.low) * (area.upper.y - area.lower.y);
  }
};

struct LegendEntry {
  Vec2d at;  ///< left end of the baseline, from the legend's top left corner
  std::size_t curve = 0;
};

/// Names side by side, in as many rows as they need.
std::vector<LegendEntry> legend_of(const Stage& stage, const PlotView& plot, int size, double width, int& rows) {
  std::vector<LegendEntry> entries;
  double x = 0;
  rows = plot.curves.empty() ? 0 : 1;
  for (std::size_t i = 0; i < plot.curves.size(); ++i) {
    const double needed = 1.6 * size + stage.canvas.text_width(plot.curves[i], size);
    if (x > 0 && x + needed > width) {
      x = 0;
      ++rows;
    }
    entries.push_back({{x, (rows - 1) * line_height * size + cap_height * size}, i});
    x += needed + 1.1 * size;
  }
  return entries;
}

double widest_number(const Stage& stage, const Ticks& ticks, int size) {
  double widest = 0;
  for (int i = 0; i < ticks.count; ++i) {
    widest = std::max(widest, stage.canvas.text_width(number_text(ticks.at(i), ticks.decimals), size));
  }
  return widest;
}

Color curve_color(const Stage& stage, std::size_t curve) {
  return stage.palette.curves[curve % stage.palette.curves.size()];
}

Chart chart_of(const Stage& stage, Cards& cards, const PlotView& plot, std::vector<LegendEntry>& legend) {
  constexpr int most_value_ticks = 4;
  constexpr int most_time_ticks = 6;
  Chart chart;
  chart.plot = &plot;
  chart.size = stage.sizes.small;
  const double size = chart.size;
  const double padding = 0.7 * size;
  const double width = 21 * size;
  chart.times = time_range(plot);
  chart.values = value_range(plot, most_value_ticks);
  chart.time_ticks = ticks_in(chart.times.low, chart.times.high, most_time_ticks);
  chart.value_ticks = ticks_in(chart.values.low, chart.values.high, most_value_ticks + 1);
  int rows = 0;
  legend = legend_of(stage, plot, chart.size, width - 2 * padding, rows);
  const double title = plot.title.empty() ? 0 : line_height * size;
  const double head = padding + title + rows * line_height * size + 0.5 * size;
  const double foot = padding + 1.5 * size;
  chart.card = cards.place({width, head + 6 * size + foot}, plot.at);
  const double numbers = widest_number(stage, chart.value_ticks, chart.size);
  chart.area = {{std::ceil(chart.card.lower.x + padding + numbers + 0.5 * size), std::ceil(chart.card.lower.y + head)},
                {std::floor(chart.card.upper.x - padding - 1.2 * size), std::floor(chart.card.upper.y - foot)}};
  return chart;
}

void draw_head(const Stage& stage, const Chart& chart, const std::vector<LegendEntry>& legend) {
  const double padding = 0.7 * chart.size;
  Vec2d at{chart.card.lower.x + padding, chart.card.lower.y + padding};
  if (!chart.plot->title.empty()) {
    stage.canvas.text(chart.plot->title, {at.x, at.y + cap_height * chart.size}, chart.size, Align::left,
                      stage.palette.ink);
    at.y += line_height * chart.size;
  }
  for (const LegendEntry& entry : legend) {
    const Vec2d from = at + entry.at - Vec2d{0, 0.36 * chart.size};
    const Color color = curve_color(stage, entry.curve);
    stage.canvas.line(from, from + Vec2d{1.1 * chart.size, 0}, 0.2 * chart.size, color);
    stage.canvas.text(chart.plot->curves[entry.curve], at + entry.at + Vec2d{1.6 * chart.size, 0}, chart.size,
                      Align::left, stage.palette.ink);
  }
}

void draw_value_axis(const Stage& stage, const Chart& chart) {
  for (int i = 0; i < chart.value_ticks.count; ++i) {
    const double value = chart.value_ticks.at(i);
    const double y = std::floor(chart.y(value));
    const bool zero = std::abs(value) < 0.5 * chart.value_ticks.step;
    const Color color = zero ? stage.palette.quiet_ink : stage.palette.grid_axis;
    stage.canvas.rectangle({chart.area.lower.x, y}, {chart.area.upper.x, y + 1}, 0, {color, color, 0});
    stage.canvas.text(number_text(value, chart.value_ticks.decimals),
                      {chart.area.lower.x - 0.5 * chart.size, y + 0.5 * cap_height * chart.size}, chart.size,
                      Align::right, stage.palette.quiet_ink);
  }
}

/// Numbers that would touch their neighbour or leave the card are left out; the last one carries the unit.
void draw_time_axis(const Stage& stage, const Chart& chart) {
  const double baseline = chart.area.upper.y + 1.25 * chart.size;
  const std::string unit = " s";
  double end = chart.card.lower.x;
  for (int i = 0; i < chart.time_ticks.count; ++i) {
    const double x = std::floor(chart.x(chart.time_ticks.at(i)));
    stage.canvas.rectangle({x, chart.area.upper.y}, {x + 1, chart.area.upper.y + 0.3 * chart.size}, 0,
                           {stage.palette.quiet_ink, stage.palette.quiet_ink, 0});
    const std::string number = number_text(chart.time_ticks.at(i), chart.time_ticks.decimals);
    const bool last = i + 1 == chart.time_ticks.count;
    const double width = stage.canvas.text_width(last ? number + unit : number, chart.size);
    const double left =
        std::min(x - 0.5 * stage.canvas.text_width(number, chart.size), chart.card.upper.x - 0.4 * chart.size - width);
    if (left < end) continue;
    stage.canvas.text(last ? number + unit : number, {left, baseline}, chart.size, Align::left,
                      stage.palette.quiet_ink);
    end = left + width + 0.4 * chart.size;
  }
  const double bottom = chart.area.upper.y;
  stage.canvas.rectangle({chart.area.lower.x, bottom}, {chart.area.upper.x, bottom + 1}, 0,
                         {stage.palette.quiet_ink, stage.palette.quiet_ink, 0});
}

/// Collects the points of one unbroken piece of a curve. Of samples in the same column of pixels, the first, the
/// lowest, the highest and the last are kept: nothing that shows is lost.
class Piece {
 public:
  void add(Vec2d at) {
    if (!column_.empty() && std::floor(at.x) != std::floor(column_.front().x)) flush();
    column_.push_back(at);
  }
  void draw(const Stage& stage, double width, Color color) {
    flush();
    stage.canvas.stroke(points_, width, color, color);
    points_.clear();
  }

 private:
  void flush() {
    if (column_.size() > 4) {
      const auto by_height = [](Vec2d a, Vec2d b) { return a.y < b.y; };
      auto [lowest, highest] = std::minmax_element(column_.begin(), column_.end(), by_height);
      if (highest < lowest) std::swap(lowest, highest);
      column_ = {column_.front(), *lowest, *highest, column_.back()};
    }
    points_.insert(points_.end(), column_.begin(), column_.end());
    column_.clear();
  }

  std::vector<Vec2d> points_;
  std::vector<Vec2d> column_;
};

void draw_curve(const Stage& stage, const Chart& chart, std::size_t curve) {
  const std::vector<double>& values = chart.plot->values[curve];
  const double width = std::max(1.5, 2.75 * stage.sizes.unit);
  const Color color = curve_color(stage, curve);
  Piece piece;
  for (std::size_t i = 0; i < std::min(values.size(), chart.plot->times.size()); ++i) {
    const double time = chart.plot->times[i];
    if (time < chart.times.low) continue;
    if (std::isfinite(values[i])) {
      piece.add({chart.x(time), chart.y(values[i])});
    } else {
      piece.draw(stage, width, color);
    }
  }
  piece.draw(stage, width, color);
}

void draw_plot(const Stage& stage, Cards& cards, const PlotView& plot) {
  std::vector<LegendEntry> legend;
  const Chart chart = chart_of(stage, cards, plot, legend);
  stage.canvas.rectangle(chart.card.lower, chart.card.upper, 0.3 * chart.size,
                         {stage.palette.plate, stage.palette.plate_edge, 1});
  draw_head(stage, chart, legend);
  draw_value_axis(stage, chart);
  draw_time_axis(stage, chart);
  for (std::size_t i = 0; i < plot.values.size(); ++i) draw_curve(stage, chart, i);
}

}  // namespace

void draw_plots(const Stage& stage, Cards& cards) {
  for (const PlotView& plot : stage.frame.plots) {
    stage.own(OwnerKind::plot, plot.title);
    draw_plot(stage, cards, plot);
  }
}

}  // namespace proofreel
