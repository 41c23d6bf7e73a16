#include "render/svg.h"

#include <algorithm>

#include "scenarios/formatted.h"

namespace proofreel {
namespace {

/// Hundredths of a pixel, without needless zeros.
std::string number(double value) {
  std::string text = formatted("%.2f", value);
  while (text.back() == '0') text.pop_back();
  if (text.back() == '.') text.pop_back();
  return text == "-0" ? "0" : text;
}

std::string pair(Vec2d p) { return number(p.x).append(" ").append(number(p.y)); }

std::string attribute(const char* name, const std::string& value) {
  return std::string(" ").append(name).append("=\"").append(value).append("\"");
}

std::string attribute(const char* name, double value) { return attribute(name, number(value)); }

std::string hex_of(Color color) {
  static constexpr const char* digits = "0123456789abcdef";
  std::string text("#");
  for (const int channel : {color.r, color.g, color.b}) text.append({digits[channel / 16], digits[channel % 16]});
  return text;
}

std::string paint_attribute(const char* name, Color color) {
  std::string text = attribute(name, hex_of(color));
  if (color.a != 255)
    text += attribute(std::string(name).append("-opacity").c_str(), formatted("%.3g", color.a / 255.0));
  return text;
}

std::string fill(Color color) { return color.a == 0 ? attribute("fill", "none") : paint_attribute("fill", color); }

std::string line(Color color, double width) {
  return paint_attribute("stroke", color).append(attribute("stroke-width", width));
}

bool outlined(const Paint& paint) { return paint.outline_px > 0 && paint.outline.a > 0; }

std::string element(const char* name, const std::string& attributes) {
  return std::string("<").append(name).append(attributes).append("/>\n");
}

std::string points_of(std::span<const Vec2d> points) {
  std::string text;
  for (const Vec2d p : points) text.append(text.empty() ? "" : " ").append(number(p.x)).append(",").append(number(p.y));
  return attribute("points", text);
}

/// Colours that change along a line change in so many steps at most.
constexpr std::size_t most_shades = 32;

}  // namespace

void SvgWriter::clear(Color background) {
  body_.clear();
  clips_ = 0;
  inside_area_ = false;
  if (background.a == 0) return;
  body_ +=
      element("rect", attribute("width", width_px_).append(attribute("height", height_px_)).append(fill(background)));
}

std::string SvgWriter::new_clip(const std::string& shape) {
  const std::string name = std::string("c").append(std::to_string(++clips_));
  body_.append("<clipPath").append(attribute("id", name)).append(">").append(shape).append("</clipPath>\n");
  return attribute("clip-path", std::string("url(#").append(name).append(")"));
}

void SvgWriter::disc(Vec2d center, double radius, const Paint& paint) {
  const std::string place = attribute("cx", center.x).append(attribute("cy", center.y));
  if (!outlined(paint) || paint.outline_px >= radius)
    body_ += element("circle", place + attribute("r", radius) + fill(outlined(paint) ? paint.outline : paint.fill));
  else
    body_ += element("circle", place + attribute("r", radius - 0.5 * paint.outline_px) + fill(paint.fill) +
                                   line(paint.outline, paint.outline_px));
}

/// The outline lies inside the edge: of a sharp polygon, the inner half of a stroke twice as wide; of a rounded one,
/// what a narrower one leaves of a wider one.
void SvgWriter::polygon(std::span<const Vec2d> corners, double radius, const Paint& paint) {
  const std::string shape = points_of(corners);
  if (radius > 0) {
    const std::string round = attribute("stroke-linejoin", "round");
    const Color outer = outlined(paint) ? paint.outline : paint.fill;
    if (outer.a > 0) body_ += element("polygon", shape + fill(outer) + line(outer, 2 * radius) + round);
    const double inner = std::max(0.0, radius - paint.outline_px);
    if (outlined(paint) && paint.fill.a > 0)
      body_ += element("polygon", shape + fill(paint.fill) + line(paint.fill, 2 * inner) + round);
    return;
  }
  if (!outlined(paint)) {
    body_ += element("polygon", shape + fill(paint.fill));
    return;
  }
  const std::string clip = new_clip(element("polygon", shape));
  body_ += element("polygon", shape + fill(paint.fill) + line(paint.outline, 2 * paint.outline_px) + clip);
}

void SvgWriter::capsule(Vec2d a, Vec2d b, double radius, const Paint& paint) {
  const std::string place = attribute("x1", a.x) + attribute("y1", a.y) + attribute("x2", b.x) + attribute("y2", b.y) +
                            attribute("stroke-linecap", "round");
  const Color outer = outlined(paint) ? paint.outline : paint.fill;
  if (outer.a > 0) body_ += element("line", place + line(outer, 2 * radius));
  if (outlined(paint) && paint.fill.a > 0)
    body_ += element("line", place + line(paint.fill, 2 * std::max(0.0, radius - paint.outline_px)));
}

void SvgWriter::stroke(std::span<const Vec2d> points, double width, Color from, Color to) {
  const std::size_t segments = points.size() - 1;
  const std::size_t shades = from == to ? 1 : std::min(most_shades, segments);
  for (std::size_t i = 0; i < shades; ++i) {
    const std::size_t first = segments * i / shades, last = segments * (i + 1) / shades;
    const Color color = mixed(from, to, (static_cast<double>(i) + 0.5) / static_cast<double>(shades));
    body_ += element("polyline", points_of(points.subspan(first, last - first + 1)) + attribute("fill", "none") +
                                     line(color, width) + attribute("stroke-linejoin", "round"));
  }
}

void SvgWriter::rectangle(Vec2d low, Vec2d high, double radius, const Paint& paint) {
  const double inset = outlined(paint) ? 0.5 * paint.outline_px : 0;
  const Vec2d size = high - low - Vec2d{2 * inset, 2 * inset};
  if (!(size.x > 0) || !(size.y > 0)) return;
  std::string text = attribute("x", low.x + inset) + attribute("y", low.y + inset) + attribute("width", size.x) +
                     attribute("height", size.y);
  if (radius > inset) text += attribute("rx", radius - inset);
  text += fill(paint.fill);
  if (outlined(paint)) text += line(paint.outline, paint.outline_px);
  body_ += element("rect", text);
}

void SvgWriter::text(const Font& font, std::string_view utf8, Vec2d left, int size_px, Color color) {
  std::string path;
  for (const PlacedGlyph& placed : font.layout(utf8, size_px).glyphs) {
    const Vec2d at = left + Vec2d{static_cast<double>(placed.x) / pen_per_pixel, 0};
    for (const OutlinePiece& piece : font.outline(placed.glyph)) {
      const auto to_px = [&](Vec2d em) { return at + Vec2d{em.x * size_px, -em.y * size_px}; };
      switch (piece.kind) {
        case OutlinePiece::Kind::move:
          path.append(path.empty() ? "M" : "ZM").append(pair(to_px(piece.to)));
          break;
        case OutlinePiece::Kind::line:
          path.append("L").append(pair(to_px(piece.to)));
          break;
        case OutlinePiece::Kind::curve:
          path.append("Q").append(pair(to_px(piece.control))).append(" ").append(pair(to_px(piece.to)));
          break;
      }
    }
  }
  if (!path.empty()) body_ += element("path", attribute("d", path.append("Z")) + fill(color));
}

void SvgWriter::enter(const PixelRect& area) {
  leave();
  const std::string size = attribute("width", area.width_px) + attribute("height", area.height_px);
  const std::string clip = new_clip(element("rect", size));
  const std::string shift = std::string("translate(")
                                .append(pair({static_cast<double>(area.x_px), static_cast<double>(area.y_px)}))
                                .append(")");
  body_.append("<g").append(attribute("transform", shift)).append("><g").append(clip).append(">\n");
  inside_area_ = true;
}

void SvgWriter::leave() {
  if (inside_area_) body_ += "</g></g>\n";
  inside_area_ = false;
}

std::string SvgWriter::document() const {
  std::string text = "<svg xmlns=\"http://www.w3.org/2000/svg\"";
  text += attribute("width", width_px_) + attribute("height", height_px_);
  text += attribute(
      "viewBox", std::string("0 0 ").append(std::to_string(width_px_)).append(" ").append(std::to_string(height_px_)));
  return text.append(">\n").append(body_).append("</svg>\n");
}

}  // namespace proofreel
