#include "lab/score_map.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "lab/print_colors.h"
#include "lab/score_text.h"
#include "render/canvas.h"
#include "render/draw_text.h"

namespace proofreel {
namespace {

/// How a standing looks. Lightness falls from what stands to what fails, so that a grey print tells them apart.
struct Look {
  Color fill;
  Color edge;
  Color text;
};
constexpr std::array<Look, standing_count> looks{{{{0xCD, 0xE9, 0xE3}, {0x2F, 0x7F, 0x73}, ink},
                                                  {{0xF0, 0xBE, 0x52}, {0x8A, 0x64, 0x14}, ink},
                                                  {{0x9B, 0x33, 0x2B}, {0x5E, 0x17, 0x12}, paper},
                                                  {{0xE3, 0xE6, 0xEA}, {0x8A, 0x93, 0x9D}, ink},
                                                  {paper, edge, quiet}}};

constexpr std::array<const char*, standing_count> meanings{"stands", "degrades: only quality is missed", "fails",
                                                           "stopped: too slow", "not offered"};

// Sizes in pixels.
constexpr double margin = 70;
constexpr double narrowest_cell = 152;
constexpr double cell_height = 98;
constexpr double gap = 8;         ///< between cells
constexpr double group_gap = 26;  ///< between groups of columns, instead
constexpr int title_px = 56;
constexpr int number_px = 38;
constexpr int text_px = 32;
constexpr int small_px = 27;
constexpr double line_px = 40;

Vec2d pixel(double x, double y) { return {std::round(x), std::round(y)}; }

/// Columns side by side that share a heading.
struct Group {
  std::string name;
  double left = 0;
  double right = 0;
  std::vector<std::string> lines;
};

struct Layout {
  std::vector<double> column_left;
  std::vector<Group> groups;
  double cell_width = 0;
  double label_right = 0;
  double groups_top = 0;
  double names_top = 0;
  double cells_top = 0;
  double legend_top = 0;
  double width = 0;
  double height = 0;
  bool has_details = false;

  double row_top(std::size_t row) const { return cells_top + static_cast<double>(row) * (cell_height + gap); }
};

void lay_columns(Layout& layout, const Grid& grid) {
  double x = layout.label_right + group_gap;
  for (const Heading& column : grid.columns) {
    const bool begins = layout.groups.empty() || layout.groups.back().name != column.group;
    if (begins && !layout.groups.empty()) x += group_gap - gap;
    if (begins) layout.groups.push_back({column.group, x, x, {}});
    layout.column_left.push_back(x);
    layout.groups.back().right = x + layout.cell_width;
    x += layout.cell_width + gap;
  }
}

/// "sequential_impulses" may break at its underscore.
std::vector<std::string> heading_lines(Canvas& canvas, const Group& group) {
  const double room = group.right - group.left;
  std::string text = group.name;
  if (canvas.text_width(text, text_px) > room) std::replace(text.begin(), text.end(), '_', ' ');
  return wrapped(canvas, text, text_px, room);
}

double widest(Canvas& canvas, const std::vector<std::string>& texts, int size) {
  double most = 0;
  for (const std::string& text : texts) most = std::max(most, canvas.text_width(text, size));
  return most;
}

/// Wide enough for what stands above each column.
double cell_width(Canvas& canvas, const Grid& grid) {
  double width = narrowest_cell;
  for (const Heading& column : grid.columns) {
    width = std::max({width, canvas.text_width(column.name, text_px), canvas.text_width(column.detail, small_px)});
  }
  return std::ceil(width);
}

constexpr double legend_item_gap = 48;
constexpr double legend_cell = 64;

double legend_width(Canvas& canvas) {
  double width = 0;
  for (const char* meaning : meanings)
    width += legend_cell + 16 + canvas.text_width(meaning, small_px) + legend_item_gap;
  return width;
}

std::string note_of(const Grid& grid) {
  return std::string("Numbers: CPU milliseconds per simulated second. Framed: the cheapest that stands") +
         (grid.one_scenario ? "." : ", in each row.");
}

Layout lay_out(Canvas& canvas, const Grid& grid) {
  Layout layout;
  std::vector<std::string> labels{grid.one_scenario ? std::string() : grid.column_axis};
  for (std::size_t row = 0; row < grid.rows.size(); ++row) labels.push_back(label_of(grid, grid.rows[row]));
  layout.label_right = margin + widest(canvas, labels, text_px);
  layout.cell_width = cell_width(canvas, grid);
  lay_columns(layout, grid);
  std::size_t lines = 1;
  for (Group& group : layout.groups) {
    group.lines = heading_lines(canvas, group);
    lines = std::max(lines, group.lines.size());
  }
  layout.has_details =
      std::any_of(grid.columns.begin(), grid.columns.end(), [](const Heading& h) { return !h.detail.empty(); });
  layout.groups_top = margin + 1.5 * title_px + 1.6 * line_px;
  layout.names_top = layout.groups_top + static_cast<double>(lines) * line_px + 14;
  layout.cells_top = layout.names_top + (layout.has_details ? 2 : 1) * line_px + 16;
  layout.legend_top = layout.row_top(grid.rows.size()) + 28;
  const double right = layout.groups.empty() ? layout.label_right : layout.groups.back().right;
  const double words = std::max({canvas.text_width(grid.title, title_px), canvas.text_width(note_of(grid), small_px),
                                 legend_width(canvas) - legend_item_gap});
  layout.width = std::max(right, margin + words) + margin;
  layout.height = layout.legend_top + legend_cell + line_px + margin;
  return layout;
}

void draw_cell(Canvas& canvas, Vec2d low, Vec2d high, const Look& look, bool framed) {
  if (framed) {
    constexpr double frame = 7;
    canvas.rectangle({low.x - frame, low.y - frame}, {high.x + frame, high.y + frame}, 14, {ink, ink, 0});
    canvas.rectangle({low.x - 2, low.y - 2}, {high.x + 2, high.y + 2}, 9, {paper, paper, 0});
  }
  canvas.rectangle(low, high, 8, {look.fill, look.edge, 2});
}

void draw_run(Canvas& canvas, const Layout& layout, std::size_t row, std::size_t column, const RunResult& result,
              bool framed) {
  const Look& look = looks[static_cast<std::size_t>(result.standing)];
  const Vec2d low{layout.column_left[column], layout.row_top(row)};
  draw_cell(canvas, low, {low.x + layout.cell_width, low.y + cell_height}, look, framed);
  const double middle = low.x + layout.cell_width / 2;
  const std::string cost = cost_text(result.cost_ms());
  const double sign_line = cost.empty() ? low.y + 63 : low.y + 42;
  canvas.text(sign_of(result.standing), pixel(middle, sign_line), 36, Align::center, look.text);
  canvas.text(cost, pixel(middle, low.y + 86), number_px, Align::center, look.text);
}

void draw_headings(Canvas& canvas, const Layout& layout, const Grid& grid) {
  for (const Group& group : layout.groups) {
    const double first = layout.names_top - 14 - static_cast<double>(group.lines.size()) * line_px;
    for (std::size_t i = 0; i < group.lines.size(); ++i) {
      const double y = first + static_cast<double>(i) * line_px + text_px;
      canvas.text(group.lines[i], pixel((group.left + group.right) / 2, y), text_px, Align::center, ink);
    }
    canvas.line({group.left, layout.names_top - 4}, {group.right, layout.names_top - 4}, 3, edge);
  }
  for (std::size_t c = 0; c < grid.columns.size(); ++c) {
    const double x = layout.column_left[c] + layout.cell_width / 2;
    canvas.text(grid.columns[c].name, pixel(x, layout.names_top + line_px), text_px, Align::center, ink);
    canvas.text(grid.columns[c].detail, pixel(x, layout.names_top + 2 * line_px - 2), small_px, Align::center, quiet);
  }
  if (grid.one_scenario) return;
  canvas.text(grid.column_axis, pixel(layout.label_right, layout.names_top + line_px), text_px, Align::right, quiet);
}

void draw_legend(Canvas& canvas, const Layout& layout) {
  double x = margin;
  for (std::size_t i = 0; i < looks.size(); ++i) {
    const Vec2d low{x, layout.legend_top};
    draw_cell(canvas, low, {x + legend_cell, low.y + legend_cell}, looks[i], false);
    canvas.text(sign_of(static_cast<Standing>(i)), pixel(x + legend_cell / 2, low.y + 45), 36, Align::center,
                looks[i].text);
    x += legend_cell + 16;
    canvas.text(meanings[i], pixel(x, low.y + 42), small_px, Align::left, ink);
    x += canvas.text_width(meanings[i], small_px) + legend_item_gap;
  }
}

}  // namespace

Image draw_map(const Grid& grid, const std::vector<RunResult>& results, std::optional<GlBackend> gl) {
  const std::unique_ptr<GlContext> context = make_context(gl);
  Layout layout;
  {
    Canvas ruler(*context, 8, 8);
    layout = lay_out(ruler, grid);
  }
  Canvas canvas(*context, static_cast<int>(std::ceil(layout.width)), static_cast<int>(std::ceil(layout.height)));
  canvas.clear(paper);
  canvas.text(grid.title, pixel(margin, margin + title_px), title_px, Align::left, ink);
  canvas.text(note_of(grid), pixel(margin, margin + 1.6 * title_px + 20), small_px, Align::left, quiet);
  draw_headings(canvas, layout, grid);
  const std::vector<bool> framed = cheapest(grid, results);
  for (std::size_t row = 0; row < grid.rows.size(); ++row) {
    const double y = layout.row_top(row) + cell_height / 2 + 11;
    canvas.text(label_of(grid, grid.rows[row]), pixel(layout.label_right, y), text_px, Align::right, ink);
    for (std::size_t column = 0; column < grid.columns.size(); ++column) {
      const std::size_t i = grid.index(row, column);
      draw_run(canvas, layout, row, column, results[i], framed[i]);
    }
  }
  draw_legend(canvas, layout);
  Image image;
  canvas.finish(image);
  return image;
}

}  // namespace proofreel
