// The split screen: panes of one size in rows, a title over each, the film's captions on bands above and below that
// keep their places throughout.

#include <algorithm>
#include <cmath>

#include "render/draw_layers.h"
#include "render/draw_text.h"

namespace proofreel {
namespace {

constexpr int band_lines = 2;

struct Grid {
  int columns = 1;
  int rows = 1;
};

/// The rows and columns whose panes come nearest to 4 : 3, with few places left empty.
Grid grid_of(int panes, Vec2d room) {
  constexpr double wanted = 4.0 / 3, price_of_a_hole = 0.5;
  Grid best;
  double least = 1e300;
  for (int columns = 1; columns <= panes; ++columns) {
    const int rows = (panes + columns - 1) / columns;
    const double shape = room.x / columns / (room.y / rows);
    const double cost = std::max(shape / wanted, wanted / shape) + price_of_a_hole * (rows * columns - panes);
    if (cost < least) best = {columns, rows};
    least = std::min(least, cost);
  }
  return best;
}

/// A picture that is divided.
struct Sheet {
  Aabbd room;  ///< px, where the panes may lie: between the bands that captions keep
  Sizes sizes;
};

Sheet sheet_of(const Frame& frame, int width_px, int height_px) {
  const Sizes sizes = sizes_of(width_px, height_px);
  const Aabbd picture{{0, 0}, {static_cast<double>(width_px), static_cast<double>(height_px)}};
  Aabbd room = expanded(picture, -sizes.margin);
  if (frame.bands.above) room.lower.y += line_height * sizes.title + 1.6 * sizes.text;
  if (frame.bands.below) room.upper.y -= band_lines * line_height * sizes.text + 1.6 * sizes.text;
  return {room, sizes};
}

double title_height(const Sizes& sizes) { return std::ceil(1.6 * sizes.text); }

/// SplitPane `index`, its title included.
Aabbd cell_of(const Sheet& sheet, const Grid& grid, int index) {
  const double gap = sheet.sizes.text;
  const Aabbd& room = sheet.room;
  const Vec2d size = room.upper - room.lower;
  const double width = std::floor((size.x - gap * (grid.columns - 1)) / grid.columns);
  const double height = std::floor((size.y - gap * (grid.rows - 1)) / grid.rows);
  const Vec2d low{std::floor(room.lower.x + (index % grid.columns) * (width + gap)),
                  std::floor(room.lower.y + std::floor(index / grid.columns) * (height + gap))};
  return {low, low + Vec2d{width, height}};
}

PixelRect below_title(const Sizes& sizes, const Aabbd& cell) {
  const double top = cell.lower.y + title_height(sizes);
  return {static_cast<int>(cell.lower.x), static_cast<int>(top), static_cast<int>(cell.upper.x - cell.lower.x),
          std::max(1, static_cast<int>(cell.upper.y - top))};
}

/// The size of the first pane's scene in a picture of the film's own size.
Size designed_size(const Frame& frame) {
  const Size made_for = frame.view.made_for;
  if (made_for.width_px == 0) return {};
  const Sheet sheet = sheet_of(frame, made_for.width_px, made_for.height_px);
  const Grid grid = grid_of(1 + static_cast<int>(frame.other_panes.size()), sheet.room.upper - sheet.room.lower);
  const PixelRect area = below_title(sheet.sizes, cell_of(sheet, grid, 0));
  return {area.width_px, area.height_px};
}

/// Letters do not shrink as fast as the panes do.
Sizes sizes_in(const Stage& stage, const PixelRect& area) {
  const int height = std::max(area.height_px, static_cast<int>(0.6 * stage.canvas.height_px()));
  return sizes_of(2 * height, height);
}

/// A pane and where it lies.
struct SplitPane {
  const Frame& frame;
  Aabbd cell;      ///< its title included; px
  PixelRect area;  ///< of its scene
  std::uint32_t first_body = 0;
};

std::vector<SplitPane> panes_of(const Stage& stage) {
  const int count = 1 + static_cast<int>(stage.frame.other_panes.size());
  const Sheet sheet = sheet_of(stage.frame, stage.canvas.width_px(), stage.canvas.height_px());
  const Grid grid = grid_of(count, sheet.room.upper - sheet.room.lower);
  std::vector<SplitPane> panes;
  for (int i = 0; i < count; ++i) {
    const Aabbd cell = cell_of(sheet, grid, i);
    panes.push_back({i == 0 ? stage.frame : stage.frame.other_panes[static_cast<std::size_t>(i) - 1], cell,
                     below_title(sheet.sizes, cell), static_cast<std::uint32_t>(i) * pane_stride});
  }
  return panes;
}

/// What draws inside a pane. Its height shows the view, where it is not narrower than it was made for.
Stage stage_in(const Stage& whole, const SplitPane& pane) {
  View view = pane.frame.view;
  view.made_for = designed_size(whole.frame);
  return {whole.canvas,
          pane.frame,
          whole.palette,
          Camera(view, pane.area.width_px, pane.area.height_px),
          sizes_in(whole, pane.area),
          {},
          whole.marks,
          pane.first_body};
}

void draw_title(const Stage& stage, const SplitPane& pane) {
  const double baseline = pane.cell.lower.y + 0.5 * (title_height(stage.sizes) + cap_height * stage.sizes.text) - 1;
  const double width = pane.cell.upper.x - pane.cell.lower.x;
  const bool fits = stage.canvas.text_width(pane.frame.pane_title, stage.sizes.text) <= width;
  const int size = fits ? stage.sizes.text : stage.sizes.small;
  stage.canvas.text(shortened(stage.canvas, pane.frame.pane_title, size, width), {pane.cell.lower.x, baseline}, size,
                    Align::left, stage.palette.ink);
}

void draw_edge(const Stage& stage, const PixelRect& area) {
  const Vec2d low{area.x_px - 1.0, area.y_px - 1.0};
  stage.canvas.rectangle(low, low + Vec2d{area.width_px + 2.0, area.height_px + 2.0}, 0,
                         {Color{0, 0, 0, 0}, stage.palette.plate_edge, 1});
}

}  // namespace

void draw_split_scenes(const Stage& stage) {
  for (const SplitPane& pane : panes_of(stage)) {
    stage.canvas.enter(pane.area);
    draw_scene(stage_in(stage, pane));
    stage.canvas.leave();
    stage.own(OwnerKind::pane, pane.frame.pane_title);
    draw_edge(stage, pane.area);
    draw_title(stage, pane);
  }
}

void draw_split_notes(const Stage& stage) {
  for (const SplitPane& pane : panes_of(stage)) {
    stage.canvas.enter(pane.area);
    const Stage inside = stage_in(stage, pane);
    Cards cards(inside.safe_area());
    if (pane.frame.shows(Layer::clock)) draw_clock(inside, cards);
    draw_notes(inside, cards);
    stage.canvas.leave();
  }
  Cards cards(stage.safe_area());
  draw_captions(stage, cards);
}

}  // namespace proofreel
