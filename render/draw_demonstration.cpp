// The page of a lecture film: heading and counters above, panes in the middle, the caption on a band below. The band
// and the panes keep their places throughout, so that nothing jumps.

#include <algorithm>

#include "render/draw_marks.h"
#include "render/draw_text.h"
#include "render/typeset.h"

namespace proofreel {
namespace {

/// Upright pictures break captions sooner and have the room for it, and for counters below the heading.
bool is_upright(const Stage& stage) { return stage.canvas.width_px() < stage.canvas.height_px(); }
int caption_lines(const Stage& stage) { return is_upright(stage) ? 3 : 2; }
double counter_line(const Stage& stage) { return is_upright(stage) ? line_height * stage.sizes.text : 0; }

/// How the picture is divided, from the top down; px.
struct Page {
  Aabbd head;
  Aabbd panes;
  Aabbd caption;
};

Page page_of(const Stage& stage) {
  const Aabbd safe = stage.safe_area();
  const double head = 1.3 * stage.sizes.title + counter_line(stage);
  const double band = (caption_lines(stage) * line_height + 0.8) * stage.sizes.text;
  const double gap = 0.5 * stage.sizes.text;
  Page page{safe, safe, safe};
  page.head.upper.y = safe.lower.y + head;
  page.caption.lower.y = safe.upper.y - band;
  page.panes.lower.y = page.head.upper.y + gap;
  page.panes.upper.y = page.caption.lower.y - gap;
  return page;
}

/// Counters end at the right edge, the heading begins at the left; where they would meet, the heading is smaller. In
/// upright pictures counters have a line of their own.
void draw_head(const Stage& stage, const DemonstrationView& view, const Aabbd& head) {
  const int size = stage.sizes.small;
  const double baseline = head.lower.y + cap_height * stage.sizes.title;
  const double line = baseline + counter_line(stage);
  double x = head.upper.x;
  for (auto counter = view.counters.rbegin(); counter != view.counters.rend(); ++counter) {
    const double value = stage.canvas.text_width(counter->value, stage.sizes.text);
    stage.canvas.text(counter->value, {x, line}, stage.sizes.text, Align::right, stage.palette.ink);
    x -= value + 0.4 * size;
    stage.canvas.text(counter->name, {x, line}, size, Align::right, stage.palette.quiet_ink);
    x -= stage.canvas.text_width(counter->name, size) + 1.4 * size;
  }
  const double end = line > baseline ? head.upper.x : x;
  const TypesetLine large = typeset_line(stage.canvas, view.heading, stage.sizes.title);
  const bool fits = head.lower.x + large.width <= end;
  const TypesetLine heading = fits ? large : typeset_line(stage.canvas, view.heading, stage.sizes.text);
  draw_line(stage.canvas, heading, {head.lower.x, baseline}, stage.palette.ink);
}

void draw_caption_band(const Stage& stage, const std::string& caption, const Aabbd& band) {
  stage.canvas.rectangle(band.lower, band.upper, 0.3 * stage.sizes.text,
                         {stage.palette.plate, stage.palette.plate_edge, 1});
  int size = stage.sizes.text;
  const double padding = 0.4 * size;
  const Vec2d room = band.upper - band.lower - Vec2d{4 * padding, padding};
  std::vector<TypesetLine> lines = balanced(stage.canvas, caption, size, room.x);
  if (height_of(lines, size) > room.y) {
    size = stage.sizes.small;
    lines = balanced(stage.canvas, caption, size, room.x);
  }
  const Vec2d middle = center(band);
  draw_lines(stage.canvas, lines, size, {middle.x, middle.y - 0.5 * height_of(lines, size)}, Align::center,
             stage.palette.ink);
}

/// The room for labels around the marks of a pane, and for its title above them; px.
struct Surrounding {
  Vec2d sides;
  double title = 0;
};

Surrounding surrounding_of(const Stage& stage, const Pane& pane) {
  const double size = stage.sizes.small;
  const Vec2d sides = pane.diagram ? Vec2d{1.6 * size, 1.2 * size} : Vec2d{2.2 * size, 1.8 * stage.sizes.text};
  return {sides, pane.title.empty() ? 0 : 1.6 * size};
}

/// Where marks may lie: inside the title and room for labels.
Aabbd inner_area(const Stage& stage, const Pane& pane, const Aabbd& area) {
  const Surrounding around = surrounding_of(stage, pane);
  return {area.lower + Vec2d{0, around.title} + around.sides, area.upper - around.sides};
}

/// The height in which a pane in metres fills this width: more would be empty. Diagrams take any.
double useful_height(const Stage& stage, const Pane& pane, double width) {
  const Surrounding around = surrounding_of(stage, pane);
  const Vec2d size = pane.bounds.upper - pane.bounds.lower;
  return (width - 2 * around.sides.x) * size.y / size.x + 2 * around.sides.y + around.title;
}

/// The panes' heights below each other: by their shares, but what one in metres cannot use is left to the diagrams.
std::vector<double> heights_of(const Stage& stage, const std::vector<Pane>& panes, Vec2d room, double shares) {
  double diagrams = 0;
  for (const Pane& pane : panes) diagrams += pane.diagram ? pane.share : 0;
  std::vector<double> heights;
  double spare = 0;
  for (const Pane& pane : panes) {
    const double height = room.y * pane.share / shares;
    const bool capped = diagrams > 0 && !pane.diagram;
    heights.push_back(capped ? std::min(height, useful_height(stage, pane, room.x)) : height);
    spare += height - heights.back();
  }
  for (std::size_t i = 0; i < panes.size(); ++i) {
    if (panes[i].diagram) heights[i] += spare * panes[i].share / diagrams;
  }
  return heights;
}

double shares_of(const std::vector<Pane>& panes) {
  double shares = 0;
  for (const Pane& pane : panes) shares += pane.share;
  return shares;
}

std::vector<Aabbd> columns_of(const Stage& stage, const std::vector<Pane>& panes, const Aabbd& whole) {
  const double gap = stage.sizes.text;
  const double room = whole.upper.x - whole.lower.x - gap * static_cast<double>(panes.size() - 1);
  const double shares = shares_of(panes);
  std::vector<Aabbd> areas;
  double x = whole.lower.x;
  for (const Pane& pane : panes) {
    const double width = room * pane.share / shares;
    areas.push_back({{x, whole.lower.y}, {x + width, whole.upper.y}});
    x += width + gap;
  }
  return areas;
}

/// Panes that lie beside each other in an upright picture: diagrams that follow each other, so that none gets too low
/// for the names in it.
std::vector<std::vector<Pane>> rows_of(const std::vector<Pane>& panes) {
  std::vector<std::vector<Pane>> rows;
  for (const Pane& pane : panes) {
    if (rows.empty() || !pane.diagram || !rows.back().back().diagram) rows.emplace_back();
    rows.back().push_back(pane);
  }
  return rows;
}

/// Side by side, or below each other where the picture is upright.
std::vector<Aabbd> areas_of(const Stage& stage, const std::vector<Pane>& panes, const Aabbd& whole) {
  const Vec2d size = whole.upper - whole.lower;
  if (size.x >= size.y) return columns_of(stage, panes, whole);
  const double gap = stage.sizes.text;
  const std::vector<std::vector<Pane>> rows = rows_of(panes);
  std::vector<Pane> firsts;
  for (const std::vector<Pane>& row : rows) {
    firsts.push_back(row.front());
    firsts.back().share = shares_of(row);
  }
  const double room = size.y - gap * static_cast<double>(rows.size() - 1);
  const std::vector<double> heights = heights_of(stage, firsts, {size.x, room}, shares_of(firsts));
  std::vector<Aabbd> areas;
  double y = whole.lower.y;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const Aabbd row{{whole.lower.x, y}, {whole.upper.x, y + heights[i]}};
    for (const Aabbd& area : columns_of(stage, rows[i], row)) areas.push_back(area);
    y += heights[i] + gap;
  }
  return areas;
}

Vec2d scale_of(const Pane& pane, const Aabbd& inner) {
  const Vec2d size = pane.bounds.upper - pane.bounds.lower;
  const Vec2d room = inner.upper - inner.lower;
  const Vec2d scale{room.x / size.x, room.y / size.y};
  if (pane.diagram) return scale;
  const double both = std::min(scale.x, scale.y);
  return {both, both};
}

/// Panes in metres share one scale: what is long in one is long in the other.
std::vector<PanePlace> places_of(const Stage& stage, const std::vector<Pane>& panes, const std::vector<Aabbd>& areas) {
  std::vector<PanePlace> places;
  double common = 1e300;
  for (std::size_t i = 0; i < panes.size(); ++i) {
    const Aabbd inner = inner_area(stage, panes[i], areas[i]);
    places.push_back({panes[i].diagram, areas[i], inner, scale_of(panes[i], inner), center(panes[i].bounds)});
    if (!panes[i].diagram) common = std::min(common, places.back().scale.x);
  }
  for (std::size_t i = 0; i < panes.size(); ++i) {
    if (!panes[i].diagram) places[i].scale = {common, common};
  }
  return places;
}

void draw_pane_title(const Stage& stage, const Pane& pane, const Aabbd& area) {
  if (pane.title.empty()) return;
  const int size = stage.sizes.small;
  const TypesetLine line = typeset_line(stage.canvas, pane.title, size);
  draw_line(stage.canvas, line, {area.lower.x + 0.3 * size, area.lower.y + cap_height * size}, stage.palette.quiet_ink);
}

/// Between panes that lie side by side or below each other.
void draw_divider(const Stage& stage, const Aabbd& before, const Aabbd& after) {
  const Color color = stage.palette.plate_edge;
  if (after.lower.x > before.upper.x) {
    const double x = std::floor(0.5 * (before.upper.x + after.lower.x));
    stage.canvas.rectangle({x, before.lower.y}, {x + 1, before.upper.y}, 0, {color, color, 0});
  } else {
    const double y = std::floor(0.5 * (before.upper.y + after.lower.y));
    stage.canvas.rectangle({before.lower.x, y}, {before.upper.x, y + 1}, 0, {color, color, 0});
  }
}

}  // namespace

void draw_demonstration(const Stage& stage) {
  const DemonstrationView& view = *stage.frame.demonstration;
  const Page page = page_of(stage);
  stage.own(OwnerKind::caption, view.heading);
  draw_head(stage, view, page.head);
  const std::vector<Aabbd> areas = areas_of(stage, view.panes, page.panes);
  const std::vector<PanePlace> places = places_of(stage, view.panes, areas);
  for (std::size_t i = 0; i < view.panes.size(); ++i) {
    stage.own(OwnerKind::pane, view.panes[i].title);
    if (i > 0) draw_divider(stage, areas[i - 1], areas[i]);
    draw_pane_title(stage, view.panes[i], areas[i]);
    std::vector<const StoryMark*> marks;
    for (const StoryMark& mark : view.marks) {
      if (mark.pane == static_cast<int>(i)) marks.push_back(&mark);
    }
    draw_marks(stage, places[i], marks);
  }
  stage.own(OwnerKind::caption, view.caption);
  draw_caption_band(stage, view.caption, page.caption);
}

}  // namespace proofreel
