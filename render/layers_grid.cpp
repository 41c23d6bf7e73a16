#include <algorithm>
#include <cmath>
#include <string>

#include "render/draw_layers.h"
#include "render/draw_text.h"

namespace proofreel {
namespace {

/// How many lines fit along `length_px` without crowding.
int roomy_lines(const Stage& stage, double length_px) {
  return std::max(2, static_cast<int>(length_px / std::max(90 * stage.sizes.unit, 5.0 * stage.sizes.small)));
}

double crisp(double px) { return std::floor(px) + 0.5; }

void draw_lines(const Stage& stage, const Ticks& ticks, bool upright) {
  const double width = std::max(1.0, std::floor(stage.sizes.thin + 0.5));
  const Aabbd picture = stage.picture();
  for (int i = 0; i < ticks.count; ++i) {
    const bool axis = std::abs(ticks.at(i)) < 0.5 * ticks.step;
    const Color color = axis ? stage.palette.grid_axis : stage.palette.grid;
    const Vec2d at = stage.camera.to_px({ticks.at(i), ticks.at(i)});
    if (upright) {
      const double left = crisp(at.x) - 0.5 * width;
      stage.canvas.rectangle({left, 0}, {left + width, picture.upper.y}, 0, {color, color, 0});
    } else {
      const double top = crisp(at.y) - 0.5 * width;
      stage.canvas.rectangle({0, top}, {picture.upper.x, top + width}, 0, {color, color, 0});
    }
  }
}

/// The spacing of lines, in metres, for both directions: squares, not rectangles.
struct GridTicks {
  Ticks across;
  Ticks up;
};

GridTicks grid_ticks(const Stage& stage) {
  const Aabbd picture = stage.picture();
  const Vec2d low = stage.camera.to_world({picture.lower.x, picture.upper.y});
  const Vec2d high = stage.camera.to_world({picture.upper.x, picture.lower.y});
  const Ticks up = ticks_in(low.y, high.y, roomy_lines(stage, picture.upper.y));
  Ticks across = up;
  across.first = std::ceil(low.x / up.step) * up.step;
  across.count = std::max(0, static_cast<int>(std::floor((high.x - across.first) / up.step)) + 1);
  return {across, up};
}

/// A number just above and to the right of `corner`.
void draw_number(const Stage& stage, Cards& cards, const std::string& text, Vec2d corner) {
  const double size = stage.sizes.small;
  const double width = stage.canvas.text_width(text, stage.sizes.small);
  const Aabbd box{{corner.x, corner.y - cap_height * size}, {corner.x + width, corner.y}};
  if (!cards.free(box)) return;
  const Aabbd plate = expanded(box, 0.25 * size);
  Color color = stage.palette.background;
  color.a = 150;
  stage.canvas.rectangle(plate.lower, plate.upper, 0.25 * size, {color, color, 0});
  cards.take(plate);
  stage.canvas.text(text, corner, stage.sizes.small, Align::left, stage.palette.quiet_ink);
}

}  // namespace

void draw_grid(const Stage& stage) {
  const GridTicks ticks = grid_ticks(stage);
  stage.own(OwnerKind::grid);
  draw_lines(stage, ticks.across, true);
  draw_lines(stage, ticks.up, false);
}

void draw_grid_numbers(const Stage& stage, Cards& cards) {
  const GridTicks ticks = grid_ticks(stage);
  const Aabbd safe = stage.safe_area();
  const double gap = 0.3 * stage.sizes.small;
  stage.own(OwnerKind::grid);
  for (int i = 0; i < ticks.across.count; ++i) {
    const double x = stage.camera.to_px({ticks.across.at(i), 0}).x;
    draw_number(stage, cards, number_text(ticks.across.at(i), ticks.across.decimals) + " m", {x + gap, safe.upper.y});
  }
  for (int i = 0; i < ticks.up.count; ++i) {
    const double y = stage.camera.to_px({0, ticks.up.at(i)}).y;
    draw_number(stage, cards, number_text(ticks.up.at(i), ticks.up.decimals) + " m", {safe.lower.x, y - gap});
  }
}

void draw_clock(const Stage& stage, Cards& cards) {
  const std::string text = "t = " + number_text(stage.frame.snapshot.time, 2) + " s";
  const int size = stage.sizes.small;
  stage.own(OwnerKind::clock);
  const Aabbd card = cards.place({stage.canvas.text_width(text, size), cap_height * size}, Corner::top_left);
  stage.canvas.text(text, {card.lower.x, card.upper.y}, size, Align::left, stage.palette.quiet_ink);
}

}  // namespace proofreel
