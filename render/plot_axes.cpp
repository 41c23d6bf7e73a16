#include "render/plot_axes.h"

#include <algorithm>
#include <cmath>

namespace proofreel {

Range axis_range(Range values, int most_ticks) {
  Range range = values;
  if (range.low > range.high) return {0, 1};
  const double size = std::max(std::abs(range.low), std::abs(range.high));
  if (range.low > 0 && range.low < 0.5 * range.high) range.low = 0;
  if (range.high < 0 && range.high > 0.5 * range.low) range.high = 0;
  if (size == 0) return {0, 1};
  if (range.high - range.low <= 1e-6 * size) range = {range.low - 0.1 * size, range.high + 0.1 * size};
  const double step = ticks_in(range.low, range.high, most_ticks).step;
  return {std::floor(range.low / step + 1e-9) * step, std::ceil(range.high / step - 1e-9) * step};
}

void draw_lower_axis(const Stage& stage, const LowerAxis& axis) {
  const Color color = stage.palette.quiet_ink;
  const double bottom = axis.area.upper.y;
  const double baseline = bottom + 1.25 * axis.size;
  const std::string unit = axis.unit.empty() ? "" : " " + axis.unit;
  double end = axis.card.lower.x;
  for (int i = 0; i < axis.ticks.count; ++i) {
    const double x = std::floor(axis.x(axis.ticks.at(i)));
    stage.canvas.rectangle({x, bottom}, {x + 1, bottom + 0.3 * axis.size}, 0, {color, color, 0});
    const std::string number = number_text(axis.ticks.at(i), axis.ticks.decimals);
    const std::string text = i + 1 == axis.ticks.count ? number + unit : number;
    const double width = stage.canvas.text_width(text, axis.size);
    const double left =
        std::min(x - 0.5 * stage.canvas.text_width(number, axis.size), axis.card.upper.x - 0.4 * axis.size - width);
    if (left < end) continue;
    stage.canvas.text(text, {left, baseline}, axis.size, Align::left, color);
    end = left + width + 0.4 * axis.size;
  }
  stage.canvas.rectangle({axis.area.lower.x, bottom}, {axis.area.upper.x, bottom + 1}, 0, {color, color, 0});
}

}  // namespace proofreel
