#pragma once

/// Axes of charts on cards: plots, phase portraits, bars.

#include <string>

#include "render/draw_layers.h"
#include "render/draw_text.h"

namespace proofreel {

struct Range {
  double low = 0;
  double high = 1;
};

/// An axis that holds these values: it ends at ticks, holds zero where that is not far, and gives a curve that is flat
/// so far, or only begins, room around it. A range whose low is above its high holds nothing: 0 to 1.
Range axis_range(Range values, int most_ticks);

/// An axis along the lower edge of `area`: its line, its ticks and their numbers, in pixels.
struct LowerAxis {
  Aabbd card;  ///< what is written stays within it
  Aabbd area;
  int size = 0;  ///< of the numbers, px
  Range range;
  Ticks ticks;
  std::string unit;  ///< behind the last number
  double x(double value) const {
    return area.lower.x + (value - range.low) / (range.high - range.low) * (area.upper.x - area.lower.x);
  }
};

/// Numbers that would touch their neighbour or leave the card are left out; the last one carries the unit.
void draw_lower_axis(const Stage& stage, const LowerAxis& axis);

}  // namespace proofreel
