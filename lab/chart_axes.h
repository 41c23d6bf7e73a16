#pragma once

/// Where a chart's values lie on the paper.

#include <cmath>
#include <string>
#include <vector>

#include "lab/chart.h"

namespace proofreel {

/// One axis: what lies where.
struct Scale {
  bool logarithmic = false;
  double low = 0;  ///< of the value, or of its logarithm
  double high = 1;
  double first_px = 0;
  double last_px = 0;

  double place(double value) const { return logarithmic ? std::log10(value) : value; }
  bool holds(double value) const { return std::isfinite(value) && (!logarithmic || value > 0); }
  double at(double value) const { return first_px + (place(value) - low) / (high - low) * (last_px - first_px); }
};

/// The ranges that take in all of the chart, or those its axes are given.
void fit(const Chart& chart, Scale& x, Scale& y);

struct Tick {
  double value = 0;
  std::string text;  ///< empty for a small one
};

std::vector<Tick> ticks_of(const Scale& scale);

}  // namespace proofreel
