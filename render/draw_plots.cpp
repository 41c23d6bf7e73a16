#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <span>

#include "render/draw_layers.h"
#include "render/draw_text.h"
#include "render/plot_axes.h"

namespace proofreel {
namespace {

/// Of a quantity: what it has reached so far. Of time: as wide as asked for, its end at the latest sample once there
/// are enough.
Range across_range(const PlotView& plot, int most_ticks) {
  if (plot.is_portrait()) return axis_range({plot.x_reach.low, plot.x_reach.high}, most_ticks);
  const double now = plot.times.empty() ? 0 : plot.times.back();
  const double from = std::max(0.0, now - plot.seconds);
  return {from, from + plot.seconds};
}

/// The value axis holds all samples there are, so that it changes seldom, and ends at ticks; that of a phase portrait
/// holds those that have faded away, too.
Range value_range(const PlotView& plot, int most_ticks) {
  if (plot.is_portrait()) return axis_range({plot.y_reach.low, plot.y_reach.high}, most_ticks);
  constexpr double none = std::numeric_limits<double>::max();
  Range range{none, -none};
  for (const std::vector<double>& values : plot.values) {
    for (const double value : values) {
      if (!std::isfinite(value)) continue;
      range.low = std::min(range.low, value);
      range.high = std::max(range.high, value);
    }
  }
  return axis_range(range, most_ticks);
}

/// A chart's card and what lies where on it, in pixels.
struct Chart {
  const PlotView* plot = nullptr;
  Aabbd card;
  Aabbd area;  ///< where the curves are
  Range across;
  Range values;
  Ticks across_ticks;
  Ticks value_ticks;
  int size = 0;  ///< of its text
  double x(double at) const {
    return area.lower.x + (at - across.low) / (across.high - across.low) * (area.upper.x - area.lower.x);
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
std::vector<LegendEntry> legend_of(Canvas& canvas, const PlotView& plot, int size, double width, int& rows) {
  std::vector<LegendEntry> entries;
  double x = 0;
  rows = plot.curves.empty() ? 0 : 1;
  for (std::size_t i = 0; i < plot.curves.size(); ++i) {
    const double needed = 1.6 * size + canvas.text_width(plot.curves[i], size);
    if (x > 0 && x + needed > width) {
      x = 0;
      ++rows;
    }
    entries.push_back({{x, (rows - 1) * line_height * size + cap_height * size}, i});
    x += needed + 1.1 * size;
  }
  return entries;
}

std::string value_text(const Chart& chart, int i) {
  return number_text(chart.value_ticks.at(i), chart.value_ticks.decimals);
}

/// "speed, m/s"; what is empty is left out.
std::string named_with_unit(const std::string& name, const std::string& unit) {
  return name.empty() || unit.empty() ? name + unit : name + ", " + unit;
}

double widest_number(const Stage& stage, const Chart& chart) {
  double widest = 0;
  for (int i = 0; i < chart.value_ticks.count; ++i)
    widest = std::max(widest, stage.canvas.text_width(value_text(chart, i), chart.size));
  return widest;
}

Color curve_color(const Stage& stage, std::size_t curve) {
  return stage.palette.curves[curve % stage.palette.curves.size()];
}

/// What of a card of that width lies above, in and below the area of its curves; px.
struct CardHeights {
  std::vector<LegendEntry> legend;
  double head = 0;
  double least_area = 0;
  double foot = 0;
};

double padding_of(double size) { return 0.7 * size; }

CardHeights heights_of(Canvas& canvas, const PlotView& plot, int size_px, double width) {
  const double size = size_px;
  const double padding = padding_of(size);
  int rows = 0;
  CardHeights heights;
  heights.legend = legend_of(canvas, plot, size_px, width - 2 * padding, rows);
  const double title = plot.title.empty() && plot.unit.empty() ? 0 : line_height * size;
  heights.head = padding + title + rows * line_height * size + 0.5 * size;
  heights.least_area = (plot.is_portrait() ? 9 : 6) * size;
  heights.foot = padding + (plot.is_portrait() ? 2.7 : 1.5) * size;
  return heights;
}

/// Of a card in a corner: it leaves room for the action beside it, in a small pane of a split screen, too.
double corner_width(const Stage& stage, double size) {
  constexpr double usual_em = 21, most_of_picture = 0.58;
  return std::min(usual_em * size, std::floor(most_of_picture * stage.picture().upper.x));
}

constexpr double lowest_area = 2, narrowest_card = 12;  // em; in less room curves cannot be read

/// How high the area of the curves is in a corner: lower than usual where its pane is low.
double corner_area(const Stage& stage, const CardHeights& heights, double size) {
  if (stage.frame.pane_title.empty()) return heights.least_area;
  const Aabbd safe = stage.safe_area();
  const double room = safe.upper.y - safe.lower.y - heights.head - heights.foot;
  return std::min(heights.least_area, std::max(lowest_area * size, room));
}

/// What lies behind a card cannot be seen: a pane of a split screen that is too small for both shows the action.
bool has_room(const Stage& stage, const PlotView& plot) {
  if (stage.frame.pane_title.empty()) return true;
  const double size = stage.sizes.small, width = corner_width(stage, size);
  const CardHeights heights = heights_of(stage.canvas, plot, stage.sizes.small, width);
  const Aabbd safe = stage.safe_area();
  return width >= narrowest_card * size &&
         heights.head + lowest_area * size + heights.foot <= safe.upper.y - safe.lower.y;
}

/// Its card, whose place is given or is found in its corner.
Chart chart_of(const Stage& stage, Cards& cards, std::size_t index, std::vector<LegendEntry>& legend) {
  constexpr int most_value_ticks = 4;
  constexpr int most_across_ticks = 6;
  const PlotView& plot = stage.frame.plots[index];
  const bool placed = index < stage.plot_places.size();
  Chart chart;
  chart.plot = &plot;
  chart.size = stage.sizes.small;
  const double size = chart.size;
  const double padding = padding_of(size);
  const double width =
      placed ? stage.plot_places[index].upper.x - stage.plot_places[index].lower.x : corner_width(stage, size);
  chart.across = across_range(plot, most_across_ticks - 1);
  chart.values = value_range(plot, most_value_ticks);
  chart.across_ticks = ticks_in(chart.across.low, chart.across.high, most_across_ticks);
  chart.value_ticks = ticks_in(chart.values.low, chart.values.high, most_value_ticks + 1);
  CardHeights heights = heights_of(stage.canvas, plot, chart.size, width);
  legend = std::move(heights.legend);
  chart.card = placed ? stage.plot_places[index]
                      : cards.place({width, heights.head + corner_area(stage, heights, size) + heights.foot}, plot.at);
  const double numbers = widest_number(stage, chart);
  chart.area = {
      {std::ceil(chart.card.lower.x + padding + numbers + 0.5 * size), std::ceil(chart.card.lower.y + heights.head)},
      {std::floor(chart.card.upper.x - padding - 1.2 * size), std::floor(chart.card.upper.y - heights.foot)}};
  return chart;
}

/// Dashes and gaps in turns, in em. Where there are no colours curves are told apart by these.
std::span<const double> dashes_of(const Stage& stage, std::size_t curve) {
  static constexpr std::array<double, 2> dashed{0.4, 0.36}, dotted{0.02, 0.3};
  static constexpr std::array<double, 4> mixed{0.4, 0.34, 0.02, 0.34};
  static constexpr std::array<std::span<const double>, 4> patterns{std::span<const double>{}, dashed, dotted, mixed};
  return stage.palette.gray ? patterns[curve % patterns.size()] : patterns[0];
}

void draw_pattern(const Stage& stage, const std::vector<Vec2d>& points, std::size_t curve, double width, int size) {
  const Color color = curve_color(stage, curve);
  const std::span<const double> dashes = dashes_of(stage, curve);
  if (dashes.empty() || points.size() < 2) return stage.canvas.stroke(points, width, color, color);
  std::size_t part = 0;
  double left = dashes[0] * size;  // of this dash or gap
  std::vector<Vec2d> dash{points[0]};
  for (std::size_t i = 1; i < points.size(); ++i) {
    Vec2d at = points[i - 1];
    for (double reach = distance(at, points[i]); reach >= left; reach = distance(at, points[i])) {
      at = at + left * normalized(points[i] - at);
      dash.push_back(at);
      if (part % 2 == 0) stage.canvas.stroke(dash, width, color, color);
      dash = {at};
      part = (part + 1) % dashes.size();
      left = dashes[part] * size;
    }
    left -= distance(at, points[i]);
    dash.push_back(points[i]);
  }
  if (part % 2 == 0) stage.canvas.stroke(dash, width, color, color);
}

void draw_head(const Stage& stage, const Chart& chart, const std::vector<LegendEntry>& legend) {
  const double padding = 0.7 * chart.size;
  Vec2d at{chart.card.lower.x + padding, chart.card.lower.y + padding};
  const double right = chart.card.upper.x - padding;
  const std::string title = named_with_unit(chart.plot->title, chart.plot->unit);
  if (!title.empty()) {
    stage.canvas.text(shortened(stage.canvas, title, chart.size, right - at.x), {at.x, at.y + cap_height * chart.size},
                      chart.size, Align::left, stage.palette.ink);
    at.y += line_height * chart.size;
  }
  for (const LegendEntry& entry : legend) {
    const Vec2d from = at + entry.at - Vec2d{0, 0.36 * chart.size};
    const Vec2d to = from + Vec2d{1.1 * chart.size, 0};
    const double width = 0.2 * chart.size;
    if (dashes_of(stage, entry.curve).empty()) {
      stage.canvas.line(from, to, width, curve_color(stage, entry.curve));
    } else {
      draw_pattern(stage, {from, to}, entry.curve, width, chart.size);
    }
    const Vec2d name = at + entry.at + Vec2d{1.6 * chart.size, 0};
    stage.canvas.text(shortened(stage.canvas, chart.plot->curves[entry.curve], chart.size, right - name.x), name,
                      chart.size, Align::left, stage.palette.ink);
  }
}

void draw_value_axis(const Stage& stage, const Chart& chart) {
  for (int i = 0; i < chart.value_ticks.count; ++i) {
    const double value = chart.value_ticks.at(i);
    const double y = std::floor(chart.y(value));
    const bool zero = std::abs(value) < 0.5 * chart.value_ticks.step;
    const Color color = zero ? stage.palette.quiet_ink : stage.palette.grid_axis;
    stage.canvas.rectangle({chart.area.lower.x, y}, {chart.area.upper.x, y + 1}, 0, {color, color, 0});
    stage.canvas.text(value_text(chart, i), {chart.area.lower.x - 0.5 * chart.size, y + 0.5 * cap_height * chart.size},
                      chart.size, Align::right, stage.palette.quiet_ink);
  }
}

/// Of time, or of the quantity that has the other place, under its name.
void draw_across_axis(const Stage& stage, const Chart& chart) {
  const PlotView& plot = *chart.plot;
  draw_lower_axis(
      stage, {chart.card, chart.area, chart.size, chart.across, chart.across_ticks, plot.is_portrait() ? "" : "s"});
  if (!plot.is_portrait()) return;
  const double middle = 0.5 * (chart.area.lower.x + chart.area.upper.x);
  const double room = 2 * (chart.card.upper.x - 0.5 * chart.size - middle);
  stage.canvas.text(shortened(stage.canvas, named_with_unit(plot.x_name, plot.x_unit), chart.size, room),
                    {middle, chart.area.upper.y + 2.5 * chart.size}, chart.size, Align::center, stage.palette.ink);
}

/// Collects the points of one unbroken piece of a curve. Of samples in the same column of pixels, the first, the
/// lowest, the highest and the last are kept: nothing that shows is lost.
class Piece {
 public:
  void add(Vec2d at) {
    if (!column_.empty() && std::floor(at.x) != std::floor(column_.front().x)) flush();
    column_.push_back(at);
  }
  void draw(const Stage& stage, std::size_t curve, double width, int size) {
    flush();
    draw_pattern(stage, points_, curve, width, size);
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
  Piece piece;
  for (std::size_t i = 0; i < std::min(values.size(), chart.plot->times.size()); ++i) {
    const double time = chart.plot->times[i];
    if (time < chart.across.low) continue;
    if (std::isfinite(values[i])) {
      piece.add({chart.x(time), chart.y(values[i])});
    } else {
      piece.draw(stage, curve, width, chart.size);
    }
  }
  piece.draw(stage, curve, width, chart.size);
}

/// One quantity against another: fading towards the past, a dot where it is now.
void draw_orbit(const Stage& stage, const Chart& chart, std::size_t curve) {
  constexpr double apart_px = 1;
  std::vector<Vec2d> points;
  for (std::size_t i = 0; i < chart.plot->xs.size(); ++i) {
    const Vec2d at{chart.x(chart.plot->xs[i]), chart.y(chart.plot->values[curve][i])};
    if (points.empty() || distance(points.back(), at) >= apart_px || i + 1 == chart.plot->xs.size())
      points.push_back(at);
  }
  if (points.empty()) return;
  const Color color = curve_color(stage, curve);
  const Color faint{color.r, color.g, color.b, 0};
  stage.canvas.stroke(points, std::max(1.5, 2.75 * stage.sizes.unit), faint, color);
  stage.canvas.disc(points.back(), std::max(3.0, 5 * stage.sizes.unit),
                    {color, stage.palette.plate, std::max(1.0, 1.25 * stage.sizes.unit)});
}

void draw_plot(const Stage& stage, Cards& cards, std::size_t index) {
  std::vector<LegendEntry> legend;
  const Chart chart = chart_of(stage, cards, index, legend);
  stage.canvas.rectangle(chart.card.lower, chart.card.upper, 0.3 * chart.size,
                         {stage.palette.plate, stage.palette.plate_edge, 1});
  draw_head(stage, chart, legend);
  draw_value_axis(stage, chart);
  draw_across_axis(stage, chart);
  for (std::size_t i = 0; i < chart.plot->values.size(); ++i) {
    if (chart.plot->is_portrait()) {
      draw_orbit(stage, chart, i);
    } else {
      draw_curve(stage, chart, i);
    }
  }
}

}  // namespace

double least_plot_height(Canvas& canvas, const Sizes& sizes, const PlotView& plot, double width) {
  const CardHeights heights = heights_of(canvas, plot, sizes.small, width);
  return heights.head + heights.least_area + heights.foot;
}

void draw_plots(const Stage& stage, Cards& cards) {
  for (std::size_t i = 0; i < stage.frame.plots.size(); ++i) {
    if (!has_room(stage, stage.frame.plots[i])) continue;
    stage.own(OwnerKind::plot, stage.frame.plots[i].title);
    draw_plot(stage, cards, i);
  }
}

}  // namespace proofreel
