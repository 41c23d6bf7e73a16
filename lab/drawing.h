#pragma once

/// A figure as a list of marks, which becomes a picture for the screen or a file for print: both show the same. Pixels
/// from the top left corner, y down.

#include <string>
#include <variant>
#include <vector>

#include "engine/vec2.h"
#include "render/canvas.h"

namespace proofreel {

/// A polyline with round ends.
struct LineMark {
  std::vector<Vec2d> points;
  double width_px = 1;
  Color color;
  bool dashed = false;
};

struct TextMark {
  std::string text;  ///< UTF-8
  Vec2d baseline;
  int size_px = 0;
  Align align = Align::left;
  Color color;
};

struct PanelMark {
  Vec2d low;
  Vec2d high;
  Paint paint;
};

/// Shapes that are told apart without colours.
enum class Symbol : std::uint8_t { disc, square, diamond, triangle, wedge, pentagon, hexagon, bar, cross };
inline constexpr int symbol_count = 8;  ///< without the cross, which means failure

struct SymbolMark {
  Vec2d center;
  Symbol symbol = Symbol::disc;
  double radius_px = 0;
  Color fill;
  Color outline;
  std::string words;  ///< for who points at it; empty for none
};

using DrawnMark = std::variant<PanelMark, LineMark, SymbolMark, TextMark>;

struct Drawing {
  int width_px = 0;
  int height_px = 0;
  Color background;
  std::vector<DrawnMark> marks;  ///< what comes later lies on top
};

/// The same, larger or smaller (text by whole pixels), and then elsewhere.
Drawing placed(Drawing drawing, double factor, Vec2d by);

/// Asks the canvas for all of it, on top of what is there.
void draw_marks(Canvas& canvas, const Drawing& drawing);
/// The same on the drawing's own background.
void draw(Canvas& canvas, const Drawing& drawing);

/// As a whole SVG file, or as a part of a page. Symbols with words can be pointed at and reached by keyboard.
std::string svg_of(const Drawing& drawing, const std::string& title);

/// The outline of a symbol, but of disc and cross, as a convex polygon of this radius around the origin.
std::vector<Vec2d> outline_of(Symbol symbol, double radius);

}  // namespace proofreel
