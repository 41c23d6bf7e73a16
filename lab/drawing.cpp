#include "lab/drawing.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "lab/html.h"

namespace proofreel {
namespace {

constexpr double dash_px = 14;

/// The dashes of a polyline: pieces as long as the gaps between them.
std::vector<std::pair<Vec2d, Vec2d>> dashes_of(const std::vector<Vec2d>& points) {
  std::vector<std::pair<Vec2d, Vec2d>> dashes;
  double walked = 0;
  for (std::size_t i = 0; i + 1 < points.size(); ++i) {
    const Vec2d way = points[i + 1] - points[i];
    const double total = length(way);
    for (double from = 0; from < total;) {
      const double phase = std::fmod(walked, 2 * dash_px);
      const double piece = std::min((phase < dash_px ? dash_px : 2 * dash_px) - phase + 1e-9, total - from);
      if (phase < dash_px)
        dashes.emplace_back(points[i] + way * (from / total), points[i] + way * ((from + piece) / total));
      from += piece;
      walked += piece;
    }
  }
  return dashes;
}

/// The two strokes of a cross.
std::vector<std::pair<Vec2d, Vec2d>> strokes_of_cross(const SymbolMark& mark) {
  const double r = mark.radius_px * 0.8;
  return {{mark.center + Vec2d{-r, -r}, mark.center + Vec2d{r, r}},
          {mark.center + Vec2d{-r, r}, mark.center + Vec2d{r, -r}}};
}

constexpr double outline_px = 3;

class CanvasPen {
 public:
  explicit CanvasPen(Canvas& canvas) : canvas_(canvas) {}

  void operator()(const PanelMark& mark) const { canvas_.rectangle(mark.low, mark.high, 0, mark.paint); }
  void operator()(const LineMark& mark) const {
    if (!mark.dashed) return canvas_.stroke(mark.points, mark.width_px, mark.color, mark.color);
    for (const auto& [from, to] : dashes_of(mark.points)) canvas_.line(from, to, mark.width_px, mark.color);
  }
  void operator()(const SymbolMark& mark) const {
    const Paint paint{mark.fill, mark.outline, outline_px};
    if (mark.symbol == Symbol::disc) return canvas_.disc(mark.center, mark.radius_px, paint);
    if (mark.symbol == Symbol::cross) {
      for (const auto& [from, to] : strokes_of_cross(mark)) canvas_.line(from, to, 2 * outline_px, mark.outline);
      return;
    }
    std::vector<Vec2d> corners = outline_of(mark.symbol, mark.radius_px);
    for (Vec2d& corner : corners) corner = corner + mark.center;
    canvas_.polygon(corners, 0, paint);
  }
  void operator()(const TextMark& mark) const {
    canvas_.text(mark.text, {std::round(mark.baseline.x), std::round(mark.baseline.y)}, mark.size_px, mark.align,
                 mark.color);
  }

 private:
  Canvas& canvas_;
};

/// Hundredths of a pixel, without zeros at the end.
std::string px(double value) {
  const auto hundredths = static_cast<long long>(std::llround(value * 100));
  std::string text = std::to_string(std::abs(hundredths) / 100);
  const auto part = static_cast<int>(std::abs(hundredths) % 100);
  if (part > 0) {
    text += part < 10 ? ".0" : ".";
    text += std::to_string(part % 10 == 0 ? part / 10 : part);
  }
  return hundredths < 0 ? "-" + text : text;
}

std::string hex_color(Color color) {
  constexpr const char* digits = "0123456789abcdef";
  std::string text = "#";
  for (const std::uint8_t part : {color.r, color.g, color.b}) {
    text += digits[part / 16];
    text += digits[part % 16];
  }
  return text;
}

std::string named(const char* name, const std::string& value) {
  return std::string(" ").append(name).append("=\"").append(value).append("\"");
}

std::string painted(const char* name, Color color) {
  std::string text = named(name, hex_color(color));
  if (color.a < 255) text += named((std::string(name) + "-opacity").c_str(), px(color.a / 255.0));
  return text;
}

std::string point_list(const std::vector<Vec2d>& points) {
  std::string text;
  for (const Vec2d& p : points) text.append(text.empty() ? "" : " ").append(px(p.x)).append(",").append(px(p.y));
  return text;
}

class SvgPen {
 public:
  std::string operator()(const PanelMark& mark) const {
    const double inset = mark.paint.outline_px / 2;
    std::string text = "<rect" + named("x", px(mark.low.x + inset)) + named("y", px(mark.low.y + inset)) +
                       named("width", px(mark.high.x - mark.low.x - 2 * inset)) +
                       named("height", px(mark.high.y - mark.low.y - 2 * inset)) + painted("fill", mark.paint.fill);
    if (inset > 0) text += painted("stroke", mark.paint.outline) + named("stroke-width", px(2 * inset));
    return text + "/>";
  }
  std::string operator()(const LineMark& mark) const {
    return "<polyline" + named("points", point_list(mark.points)) + named("fill", "none") +
           painted("stroke", mark.color) + named("stroke-width", px(mark.width_px)) +
           named("stroke-linecap", mark.dashed ? "butt" : "round") + named("stroke-linejoin", "round") +
           (mark.dashed ? named("stroke-dasharray", px(dash_px)) : "") + "/>";
  }
  std::string operator()(const SymbolMark& mark) const {
    if (mark.words.empty()) return shape(mark);
    return "<g class=\"point\" tabindex=\"0\"" + named("data-words", html_escaped(mark.words)) +
           named("aria-label", html_escaped(mark.words)) + " role=\"img\">" + shape(mark) + "</g>";
  }
  std::string operator()(const TextMark& mark) const {
    const char* anchor = mark.align == Align::left ? "start" : mark.align == Align::center ? "middle" : "end";
    return "<text" + named("x", px(mark.baseline.x)) + named("y", px(mark.baseline.y)) +
           named("font-size", std::to_string(mark.size_px)) + named("text-anchor", anchor) +
           painted("fill", mark.color) + ">" + html_escaped(mark.text) + "</text>";
  }

 private:
  static std::string shape(const SymbolMark& mark) {
    const std::string paint =
        painted("fill", mark.fill) + painted("stroke", mark.outline) + named("stroke-width", px(outline_px));
    const double inside = mark.radius_px - outline_px / 2;
    if (mark.symbol == Symbol::disc) {
      return "<circle" + named("cx", px(mark.center.x)) + named("cy", px(mark.center.y)) + named("r", px(inside)) +
             paint + "/>";
    }
    if (mark.symbol != Symbol::cross) {
      std::vector<Vec2d> corners = outline_of(mark.symbol, inside);
      for (Vec2d& corner : corners) corner = corner + mark.center;
      return "<polygon" + named("points", point_list(corners)) + paint + named("stroke-linejoin", "round") + "/>";
    }
    std::string text;
    for (const auto& [from, to] : strokes_of_cross(mark)) {
      text += "<line" + named("x1", px(from.x)) + named("y1", px(from.y)) + named("x2", px(to.x)) +
              named("y2", px(to.y)) + painted("stroke", mark.outline) + named("stroke-width", px(2 * outline_px)) +
              named("stroke-linecap", "round") + "/>";
    }
    return text;
  }
};

/// A regular polygon; `turn` in radians, 0 has a corner at the top.
std::vector<Vec2d> regular(int corners, double radius, double turn) {
  std::vector<Vec2d> points;
  for (int i = 0; i < corners; ++i) {
    const double angle = turn + 2 * std::numbers::pi * i / corners;
    points.push_back({radius * std::sin(angle), -radius * std::cos(angle)});
  }
  return points;
}

}  // namespace

std::vector<Vec2d> outline_of(Symbol symbol, double radius) {
  constexpr double pi = std::numbers::pi;
  switch (symbol) {
    case Symbol::square:
      return regular(4, radius * 1.2, pi / 4);
    case Symbol::diamond:
      return regular(4, radius * 1.25, 0);
    case Symbol::triangle:
      return regular(3, radius * 1.25, 0);
    case Symbol::wedge:
      return regular(3, radius * 1.25, pi);
    case Symbol::pentagon:
      return regular(5, radius * 1.1, 0);
    case Symbol::hexagon:
      return regular(6, radius * 1.1, 0);
    case Symbol::bar:
      return {{-radius * 1.2, -radius * 0.55},
              {radius * 1.2, -radius * 0.55},
              {radius * 1.2, radius * 0.55},
              {-radius * 1.2, radius * 0.55}};
    case Symbol::disc:
    case Symbol::cross:
      return regular(8, radius, 0);
  }
  return {};
}

Drawing placed(Drawing drawing, double factor, Vec2d by) {
  const auto rounded = [factor](int px) { return static_cast<int>(std::lround(px * factor)); };
  const auto place = [&](Vec2d& p) { p = p * factor + by; };
  for (DrawnMark& any : drawing.marks) {
    if (auto* panel = std::get_if<PanelMark>(&any)) {
      place(panel->low);
      place(panel->high);
    } else if (auto* line = std::get_if<LineMark>(&any)) {
      line->width_px *= factor;
      for (Vec2d& p : line->points) place(p);
    } else if (auto* symbol = std::get_if<SymbolMark>(&any)) {
      symbol->radius_px *= factor;
      place(symbol->center);
    } else if (auto* text = std::get_if<TextMark>(&any)) {
      text->size_px = rounded(text->size_px);
      place(text->baseline);
    }
  }
  drawing.width_px = rounded(drawing.width_px);
  drawing.height_px = rounded(drawing.height_px);
  return drawing;
}

void draw_marks(Canvas& canvas, const Drawing& drawing) {
  for (const DrawnMark& mark : drawing.marks) std::visit(CanvasPen(canvas), mark);
}

void draw(Canvas& canvas, const Drawing& drawing) {
  canvas.clear(drawing.background);
  draw_marks(canvas, drawing);
}

std::string svg_of(const Drawing& drawing, const std::string& title) {
  const std::string width = std::to_string(drawing.width_px);
  const std::string height = std::to_string(drawing.height_px);
  std::string svg = "<svg xmlns=\"http://www.w3.org/2000/svg\"" + named("viewBox", "0 0 " + width + " " + height) +
                    named("font-family", "DejaVu Sans, Verdana, sans-serif") + named("role", "group") +
                    named("aria-label", html_escaped(title)) + ">\n";
  svg += SvgPen()(PanelMark{{0, 0},
                            {static_cast<double>(drawing.width_px), static_cast<double>(drawing.height_px)},
                            {drawing.background, drawing.background, 0}}) +
         "\n";
  for (const DrawnMark& mark : drawing.marks) svg += std::visit(SvgPen(), mark) + "\n";
  return svg + "</svg>\n";
}

}  // namespace proofreel
