#pragma once

/// Curves over axes, laid out for print.

#include <optional>
#include <string>
#include <vector>

#include "lab/drawing.h"

namespace proofreel {

/// An axis takes in all that is drawn, or the given range. What is not positive has no place on a logarithmic one.
struct ChartAxis {
  std::string label;
  bool logarithmic = false;
  std::optional<Vec2d> range = {};  ///< from x to y
};

struct ChartPoint {
  Vec2d at;           ///< in units of the axes
  std::string words;  ///< for who points at it
  bool grey = false;  ///< dominated: drawn pale
};

struct ChartCurve {
  std::string name;
  std::string note;  ///< a second, quieter line in the legend
  std::vector<ChartPoint> points;
  bool marked = true;                ///< with a symbol at each point
  std::vector<ChartPoint> failures;  ///< crosses at the upper edge, at their x; without one, at the right end
  std::optional<double> floor;       ///< a dashed line at this y
};

/// A right-angled triangle beside a line of this slope (of log y over log x), at the first of these points of it where
/// there is room.
struct SlopeTriangle {
  std::vector<Vec2d> places;
  double slope = 0;
  std::string label;
};

struct Chart {
  std::string title;
  std::vector<std::string> notes;  ///< sentences under the title
  ChartAxis x;
  ChartAxis y;
  std::vector<ChartCurve> curves;
  std::vector<Vec2d> front;  ///< drawn as a broad band under the curves; empty for none
  std::vector<SlopeTriangle> triangles;
};

/// How a curve looks, by its place in the list: a colour that colour-blind readers tell apart, and a symbol.
struct CurveLook {
  Color color;
  Symbol symbol = Symbol::disc;
};
CurveLook look_of_curve(std::size_t index);

/// `ruler` measures texts only.
Drawing laid_out(const Chart& chart, Canvas& ruler, int width_px, int height_px);

/// "10" with a small exponent: UTF-8.
std::string power_of_ten(int exponent);

}  // namespace proofreel
