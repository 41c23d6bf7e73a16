#include "lab/chart.h"

#include <algorithm>
#include <array>

#include "engine/aabb.h"
#include "lab/chart_axes.h"
#include "lab/print_colors.h"
#include "render/draw_text.h"

namespace proofreel {
namespace {

constexpr Color grid{0xE4, 0xE7, 0xEA};
constexpr Color band{0xF3, 0xDF, 0xA8};
constexpr Color grey{0xC4, 0xC9, 0xCE};

// Sizes in pixels.
constexpr double margin = 64;
constexpr int title_px = 52;
constexpr int text_px = 34;
constexpr int small_px = 28;
constexpr double radius_px = 13;
constexpr double legend_gap = 44;
constexpr double sample_px = 64;  ///< of a curve, in the legend

class Layout {
 public:
  Layout(const Chart& chart, Canvas& ruler, int width_px, int height_px) : chart_(chart), ruler_(ruler) {
    drawing_.width_px = width_px;
    drawing_.height_px = height_px;
    drawing_.background = paper;
  }

  Drawing lay_out() {
    place_frame();
    add_grid();
    add_front();
    for (const SlopeTriangle& triangle : chart_.triangles) add_triangle(triangle);
    for (std::size_t i = 0; i < chart_.curves.size(); ++i) add_lines(i);
    for (std::size_t i = 0; i < chart_.curves.size(); ++i) add_symbols(i);
    add_legend();
    return std::move(drawing_);
  }

 private:
  void add(DrawnMark mark) { drawing_.marks.push_back(std::move(mark)); }
  void add_text(const std::string& text, Vec2d at, int size, Align align, Color color) {
    add(TextMark{text, at, size, align, color});
  }

  double legend_width() {
    double widest = ruler_.text_width("cheapest for its error", small_px);
    for (const ChartCurve& curve : chart_.curves) {
      widest = std::max({widest, ruler_.text_width(curve.name, text_px), ruler_.text_width(curve.note, small_px)});
    }
    return sample_px + 18 + widest;
  }

  /// The title, the notes, and where the axes are.
  void place_frame() {
    double y = chart_.title.empty() ? -1.5 * text_px : margin + title_px;
    add_text(chart_.title, {margin, y}, title_px, Align::left, ink);
    const double room = drawing_.width_px - 2 * margin;
    for (const std::string& note : chart_.notes) {
      for (const std::string& line : wrapped(ruler_, note, small_px, room)) {
        y += small_px * 1.45;
        add_text(line, {margin, y + 8}, small_px, Align::left, quiet);
      }
    }
    legend_left_ = drawing_.width_px - margin - legend_width();
    x_ = {chart_.x.logarithmic, 0, 1, 0, legend_left_ - legend_gap};
    y_ = {chart_.y.logarithmic, 0, 1, drawing_.height_px - margin - 2.6 * text_px, y + 3.0 * text_px};
    fit(chart_, x_, y_);
    x_.first_px = margin + widest_y_label() + 18;
    add_text(chart_.y.label, {margin, y_.last_px - 0.7 * text_px}, text_px, Align::left, ink);
    const double middle = (x_.first_px + x_.last_px) / 2;
    add_text(chart_.x.label, {middle, drawing_.height_px - margin}, text_px, Align::center, ink);
  }

  double widest_y_label() {
    double widest = 0;
    for (const Tick& tick : ticks_of(y_)) widest = std::max(widest, ruler_.text_width(tick.text, small_px));
    return widest;
  }

  void add_grid() {
    for (const Tick& tick : ticks_of(x_)) {
      const double x = x_.at(tick.value);
      add(LineMark{{{x, y_.first_px}, {x, y_.last_px}}, tick.text.empty() ? 1.0 : 2.5, grid, false});
      add_text(tick.text, {x, y_.first_px + 1.35 * small_px}, small_px, Align::center, ink);
    }
    for (const Tick& tick : ticks_of(y_)) {
      const double y = y_.at(tick.value);
      add(LineMark{{{x_.first_px, y}, {x_.last_px, y}}, tick.text.empty() ? 1.0 : 2.5, grid, false});
      add_text(tick.text, {x_.first_px - 14, y + 0.36 * small_px}, small_px, Align::right, ink);
    }
    add(LineMark{{{x_.first_px, y_.last_px}, {x_.first_px, y_.first_px}, {x_.last_px, y_.first_px}}, 3, edge, false});
  }

  bool holds(Vec2d p) const { return x_.holds(p.x) && y_.holds(p.y); }
  Vec2d pixel(Vec2d p) const { return {x_.at(p.x), y_.at(p.y)}; }

  void add_front() {
    std::vector<Vec2d> points;
    for (const Vec2d& p : chart_.front) {
      if (holds(p)) points.push_back(pixel(p));
    }
    if (points.size() > 1) add(LineMark{points, 30, band, false});
    if (points.size() == 1) add(SymbolMark{points[0], Symbol::disc, 22, band, band, ""});
  }

  /// A triangle in pixels.
  struct PlacedTriangle {
    Vec2d upper;
    Vec2d lower;
    Vec2d corner;

    Aabbd box() const {
      constexpr double room = 34;  // for symbols and for its own numbers
      return {{upper.x - room, upper.y - room}, {lower.x + room, lower.y + room}};
    }
    /// Whether a point of a curve lies on it, or where its numbers are.
    bool is_covered(Vec2d p) const {
      constexpr double room = 18;
      const Vec2d side = lower - upper;
      const double towards_corner = cross(side, corner - upper) > 0 ? 1 : -1;
      const bool beside = towards_corner * cross(side, p - upper) > -room * length(side);
      const Aabbd b = box();
      return beside && p.x > b.lower.x && p.x < b.upper.x && p.y > b.lower.y && p.y < b.upper.y;
    }
  };

  /// Left of and below the line, or right of and above it.
  PlacedTriangle placed(Vec2d at, double slope, bool below) const {
    constexpr double run_px = 90;
    const double per_decade_x = (x_.last_px - x_.first_px) / (x_.high - x_.low);
    const double per_decade_y = (y_.first_px - y_.last_px) / (y_.high - y_.low);
    const double fall = -slope * per_decade_y * (run_px / per_decade_x);
    const double side = below ? -1 : 1;
    const Vec2d upper{at.x - run_px / 2 + side * 44, at.y - fall / 2 - side * 30};
    const Vec2d lower{upper.x + run_px, upper.y + fall};
    return {upper, lower, below ? Vec2d{upper.x, lower.y} : Vec2d{lower.x, upper.y}};
  }

  /// Whether it covers nothing and lies within the axes.
  bool is_free(const PlacedTriangle& triangle) const {
    const Aabbd box = triangle.box();
    if (box.lower.x < x_.first_px || box.upper.x > x_.last_px) return false;
    if (box.lower.y < y_.last_px || box.upper.y > y_.first_px) return false;
    for (const ChartCurve& curve : chart_.curves) {
      for (std::size_t i = 0; i < curve.points.size(); ++i) {
        if (is_met(triangle, curve, i)) return false;
      }
    }
    return true;
  }

  /// Whether it meets a curve from its point i to the next one, looked at closely enough.
  bool is_met(const PlacedTriangle& triangle, const ChartCurve& curve, std::size_t i) const {
    constexpr int looks = 12;
    const Vec2d from = curve.points[i].at;
    const Vec2d to = curve.points[std::min(i + 1, curve.points.size() - 1)].at;
    if (!holds(from) || !holds(to)) return false;
    for (int k = 0; k <= looks; ++k) {
      const Vec2d p = pixel(from) + (pixel(to) - pixel(from)) * (static_cast<double>(k) / looks);
      if (triangle.is_covered(p)) return true;
    }
    return false;
  }

  /// At the first of its places where it covers nothing; else it is left out.
  void add_triangle(const SlopeTriangle& triangle) {
    for (const Vec2d at : triangle.places) {
      for (const bool below : {true, false}) {
        if (!holds(at)) continue;
        const PlacedTriangle t = placed(pixel(at), triangle.slope, below);
        if (is_free(t)) return add_triangle(t, triangle.label, below);
      }
    }
  }

  void add_triangle(const PlacedTriangle& t, const std::string& label, bool below) {
    add(LineMark{{t.upper, t.lower, t.corner, t.upper}, 3, quiet, false});
    const double middle = (t.upper.y + t.lower.y) / 2 + 0.36 * small_px;
    add_text(label, {t.corner.x + (below ? -10 : 10), middle}, small_px, below ? Align::right : Align::left, quiet);
    const double beside = below ? t.lower.y + small_px : t.upper.y - 8;
    add_text("1", {(t.upper.x + t.lower.x) / 2, beside}, small_px, Align::center, quiet);
  }

  void add_lines(std::size_t index) {
    const ChartCurve& curve = chart_.curves[index];
    const Color color = look_of_curve(index).color;
    std::vector<Vec2d> piece;
    const auto finish = [&] {
      if (piece.size() > 1)
        add(LineMark{piece, curve.marked ? 4.0 : 5.0, curve.marked ? mixed(color, paper, 0.35) : color, false});
      piece.clear();
    };
    for (const ChartPoint& point : curve.points) {
      if (holds(point.at)) {
        piece.push_back(pixel(point.at));
      } else {
        finish();
      }
    }
    finish();
    if (curve.floor && y_.holds(*curve.floor)) {
      const double y = y_.at(*curve.floor);
      add(LineMark{{{x_.first_px, y}, {x_.last_px, y}}, 3, mixed(color, paper, 0.3), true});
    }
  }

  void add_symbols(std::size_t index) {
    const ChartCurve& curve = chart_.curves[index];
    const CurveLook look = look_of_curve(index);
    for (const ChartPoint& point : curve.points) {
      if (!curve.marked || !holds(point.at)) continue;
      const Color fill = point.grey ? mixed(look.color, grey, 0.82) : look.color;
      const Color outline = point.grey ? mixed(look.color, grey, 0.5) : mixed(look.color, ink, 0.6);
      add(SymbolMark{pixel(point.at), look.symbol, radius_px, fill, outline, point.words});
    }
    for (const ChartPoint& failure : curve.failures) {
      const double x = x_.holds(failure.at.x) ? x_.at(failure.at.x) : x_.last_px - radius_px;
      add(SymbolMark{{x, y_.last_px + radius_px}, Symbol::cross, radius_px, look.color, look.color, failure.words});
    }
  }

  void add_legend() {
    double y = y_.last_px + text_px;
    const double middle = legend_left_ + sample_px / 2;
    const double words = legend_left_ + sample_px + 18;
    constexpr double key_px = 5 * 1.6 * small_px;
    const double room = drawing_.height_px - margin - y_.last_px - key_px;
    const double roomy = 1.75 * text_px + 1.3 * small_px;
    const double tight = 1.2 * text_px;
    const auto count = chart_.curves.size();
    const bool has_notes = static_cast<double>(count) * roomy <= room;
    const std::size_t shown = std::min(count, static_cast<std::size_t>(std::max(1.0, room / tight)));
    for (std::size_t i = 0; i < shown; ++i) {
      const CurveLook look = look_of_curve(i);
      const double line = y - 0.36 * text_px;
      add(LineMark{{{legend_left_ + 4, line}, {legend_left_ + sample_px - 4, line}},
                   5,
                   chart_.curves[i].marked ? mixed(look.color, paper, 0.35) : look.color,
                   false});
      if (chart_.curves[i].marked)
        add(SymbolMark{{middle, line}, look.symbol, radius_px, look.color, mixed(look.color, ink, 0.6), ""});
      add_text(chart_.curves[i].name, {words, y}, text_px, Align::left, ink);
      if (!has_notes) {
        y += tight;
        continue;
      }
      if (!chart_.curves[i].note.empty()) {
        y += 1.3 * small_px;
        add_text(chart_.curves[i].note, {words, y}, small_px, Align::left, quiet);
      }
      y += 1.75 * text_px;
    }
    if (shown < count)
      add_text("and " + std::to_string(count - shown) + " more", {words, y}, small_px, Align::left, quiet);
    add_key(y + (shown < count ? tight : 0));
  }

  /// What bands, pale symbols, crosses and dashes mean, where there are any.
  void add_key(double y) {
    const double middle = legend_left_ + sample_px / 2;
    const double words = legend_left_ + sample_px + 18;
    const auto next = [&](const std::string& text) {
      add_text(text, {words, y}, small_px, Align::left, quiet);
      y += 1.6 * small_px;
    };
    const auto any = [&](auto has) { return std::any_of(chart_.curves.begin(), chart_.curves.end(), has); };
    y += 0.4 * text_px;
    if (!chart_.front.empty()) {
      add(LineMark{{{legend_left_ + 16, y - 10}, {legend_left_ + sample_px - 16, y - 10}}, 30, band, false});
      next("cheapest for its error");
    }
    const auto is_grey = [](const ChartPoint& p) { return p.grey; };
    if (any([&](const ChartCurve& c) { return std::any_of(c.points.begin(), c.points.end(), is_grey); })) {
      add(SymbolMark{{middle, y - 10}, Symbol::disc, radius_px, grey, mixed(grey, ink, 0.3), ""});
      next("dominated");
    }
    if (any([](const ChartCurve& c) { return !c.failures.empty(); })) {
      add(SymbolMark{{middle, y - 10}, Symbol::cross, radius_px, quiet, quiet, ""});
      next("failed or stopped");
    }
    if (any([](const ChartCurve& c) { return c.floor.has_value(); })) {
      add(LineMark{{{legend_left_ + 4, y - 10}, {legend_left_ + sample_px - 4, y - 10}}, 3, quiet, true});
      next("gets no better");
    }
  }

  const Chart& chart_;
  Canvas& ruler_;
  Drawing drawing_;
  Scale x_;
  Scale y_;
  double legend_left_ = 0;
};

}  // namespace

CurveLook look_of_curve(std::size_t index) {
  constexpr std::array<Color, 8> colors{{{0x00, 0x72, 0xB2},
                                         {0xD5, 0x5E, 0x00},
                                         {0x00, 0x9E, 0x73},
                                         {0x8E, 0x3B, 0x8A},
                                         {0xE0, 0x9F, 0x00},
                                         {0x3F, 0x9F, 0xDB},
                                         {0x4A, 0x52, 0x5C},
                                         {0xB0, 0x30, 0x50}}};
  // From one round of colours to the next the symbols shift, so that the pairs stay distinct.
  const std::size_t round = index / colors.size();
  return {colors[index % colors.size()], static_cast<Symbol>((index + round) % symbol_count)};
}

Drawing laid_out(const Chart& chart, Canvas& ruler, int width_px, int height_px) {
  return Layout(chart, ruler, width_px, height_px).lay_out();
}

}  // namespace proofreel
