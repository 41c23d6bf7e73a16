#include <algorithm>
#include <array>
#include <cmath>

#include "render/draw_layers.h"
#include "render/draw_text.h"
#include "render/plot_axes.h"

namespace proofreel {
namespace {

struct Bar {
  const char* name;
  double joules;
};

std::array<Bar, 3> bars_of(const Energy& energy) {
  return {Bar{"kinetic", energy.kinetic}, {"potential", energy.potential}, {"total", energy.total()}};
}

double widest_name(const Stage& stage, const std::array<Bar, 3>& bars) {
  double widest = 0;
  for (const Bar& bar : bars) widest = std::max(widest, stage.canvas.text_width(bar.name, stage.sizes.small));
  return widest;
}

/// The card, and on it the area of the bars above their axis.
LowerAxis axis_of(const Stage& stage, Cards& cards, const std::array<Bar, 3>& bars) {
  constexpr int most_ticks = 4;
  const EnergyExtent& extent = stage.frame.energy;
  LowerAxis axis;
  axis.size = stage.sizes.small;
  axis.unit = "J";
  const double size = axis.size;
  const double padding = 0.7 * size;
  axis.range = axis_range({std::min(0.0, extent.lowest), std::max(0.0, extent.highest)}, most_ticks);
  axis.ticks = ticks_in(axis.range.low, axis.range.high, most_ticks + 1);
  const double head = padding + line_height * size + 0.3 * size;
  const double rows = static_cast<double>(bars.size()) * 1.5 * size;
  axis.card = cards.place({21 * size, head + rows + padding + 1.5 * size}, Corner::top_left);
  axis.area = {{std::ceil(axis.card.lower.x + padding + widest_name(stage, bars) + 0.7 * size),
                std::ceil(axis.card.lower.y + head)},
               {std::floor(axis.card.upper.x - padding - 1.2 * size), std::floor(axis.card.lower.y + head + rows)}};
  return axis;
}

void draw_bar(const Stage& stage, const LowerAxis& axis, const Bar& bar, std::size_t row) {
  const double size = axis.size;
  const double middle = std::floor(axis.area.lower.y + (static_cast<double>(row) + 0.5) * 1.5 * size);
  const double from = axis.x(0);
  const double to = axis.x(bar.joules);
  const Color color = stage.palette.curves[row];
  stage.canvas.text(bar.name, {axis.area.lower.x - 0.7 * size, middle + 0.5 * cap_height * size}, axis.size,
                    Align::right, stage.palette.ink);
  stage.canvas.rectangle({std::min(from, to), middle - 0.45 * size}, {std::max(from, to), middle + 0.45 * size}, 0,
                         {color, color, 0});
}

/// What the total was at the start, across its bar.
void draw_start(const Stage& stage, const LowerAxis& axis, std::size_t row) {
  const double size = axis.size;
  const double top = std::floor(axis.area.lower.y + static_cast<double>(row) * 1.5 * size);
  const double x = axis.x(stage.frame.energy.initial_total);
  const double half = std::max(0.75, stage.sizes.thin);
  stage.canvas.rectangle({x - half, top}, {x + half, top + 1.5 * size}, 0, {stage.palette.ink, stage.palette.ink, 0});
}

}  // namespace

void draw_energy(const Stage& stage, Cards& cards) {
  const std::array<Bar, 3> bars = bars_of(stage.frame.snapshot.energy);
  stage.own(OwnerKind::energy);
  const LowerAxis axis = axis_of(stage, cards, bars);
  const double size = axis.size;
  stage.canvas.rectangle(axis.card.lower, axis.card.upper, 0.3 * size,
                         {stage.palette.plate, stage.palette.plate_edge, 1});
  stage.canvas.text("Energy (the line: the total at the start)",
                    axis.card.lower + Vec2d{0.7 * size, (0.7 + cap_height) * size}, axis.size, Align::left,
                    stage.palette.ink);
  const double zero = std::floor(axis.x(0));
  stage.canvas.rectangle({zero, axis.area.lower.y}, {zero + 1, axis.area.upper.y}, 0,
                         {stage.palette.quiet_ink, stage.palette.quiet_ink, 0});
  for (std::size_t i = 0; i < bars.size(); ++i) draw_bar(stage, axis, bars[i], i);
  draw_start(stage, axis, bars.size() - 1);
  draw_lower_axis(stage, axis);
}

}  // namespace proofreel
