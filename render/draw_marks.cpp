#include "render/draw_marks.h"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <iterator>
#include <optional>

#include "render/draw_text.h"
#include "render/typeset.h"

namespace proofreel {
namespace {

/// How strokes and areas of a role look.
struct Look {
  Color color;
  Color fill;        ///< of regions
  double width = 3;  ///< of strokes, px of a picture 720 high
  bool dashed = false;
};

Color with_alpha(Color color, int alpha) {
  color.a = static_cast<std::uint8_t>(alpha);
  return color;
}

int brightness(Color color) { return 2 * color.r + 5 * color.g + color.b; }

/// Of a shape's two colours the one that stands out more from the background.
Color ink_of(const Palette& palette, const Tone& tone) {
  const auto contrast = [&](Color color) { return std::abs(brightness(color) - brightness(palette.background)); };
  return contrast(tone.fill) > contrast(tone.outline) ? tone.fill : tone.outline;
}

Look look_of(const Palette& palette, Role role) {
  const auto look = [](Color color, int alpha, double width, bool dashed = false) {
    return Look{color, with_alpha(color, alpha), width, dashed};
  };
  switch (role) {
    case Role::quiet:
      return look(with_alpha(palette.quiet_ink, 130), 30, 1.6);
    case Role::first:
      return look(ink_of(palette, palette.dynamic), 60, 2.5);
    case Role::second:
      return look(ink_of(palette, palette.fixed), 60, 2.5);
    case Role::candidate:
      return look(palette.gray ? palette.quiet_ink : palette.curves[1], 80, 3.5, true);
    case Role::chosen:
      return look(palette.curves[0], 55, 4);
    case Role::rejected:
      return look(palette.gray ? palette.grid_axis : palette.quiet_ink, 60, 2.5);
    case Role::result:
      return look(palette.curves[2], 60, 5);
    case Role::alert:
      return look(palette.contact, 75, 4);
  }
  return look(palette.ink, 60, 3);
}

Color faded(Color color, double presence) {
  color.a = static_cast<std::uint8_t>(color.a * presence + 0.5);
  return color;
}

bool is_area(MarkKind kind) { return kind == MarkKind::shape || kind == MarkKind::region || kind == MarkKind::bar; }
bool is_stroke(MarkKind kind) { return kind == MarkKind::path || kind == MarkKind::arrow; }
bool is_point(MarkKind kind) { return kind == MarkKind::dot || kind == MarkKind::crosswise; }

double dot_radius(const Stage& stage, Role role) {
  const double size = role == Role::rejected || role == Role::quiet ? 5 : role == Role::first ? 6.5 : 8;
  return std::max(2.5, size * stage.sizes.unit);
}

using Marks = std::vector<const StoryMark*>;

std::vector<Vec2d> in_px(const PanePlace& place, const StoryMark& mark) {
  std::vector<Vec2d> points;
  points.reserve(mark.points.size());
  for (const Vec2d p : mark.points) points.push_back(place.to_px(p));
  return points;
}

/// Finds room for labels: beside their points, clear of dots and of each other, and where it can be of strokes.
class Labels {
 public:
  Labels(const Stage& stage, const PanePlace& place, const Marks& marks) : stage_(stage), place_(place) {
    for (const StoryMark* mark : marks) {
      if (is_stroke(mark->kind) || mark->kind == MarkKind::shape) note_strokes(*mark);
      if (is_point(mark->kind)) note_dot(*mark);
    }
  }

  void draw(const StoryMark& mark) {
    if (mark.text.empty()) return;
    const bool beside = place_.diagram && mark.kind == MarkKind::text && !(mark.side == Vec2d{});
    const int size = beside ? stage_.sizes.small : stage_.sizes.text;
    const TypesetLine line = typeset_line(stage_.canvas, mark.text, size);
    const Aabbd card = card_of(mark, {line.width + 0.3 * size, cap_height * size + 0.3 * size + line.descent});
    taken_.push_back(card);
    const Color plate = faded(with_alpha(stage_.palette.background, 170), mark.presence);
    if (!beside) stage_.canvas.rectangle(card.lower, card.upper, 0.25 * size, {plate, plate, 0});
    const Color ink = mark.role == Role::quiet ? stage_.palette.quiet_ink : stage_.palette.ink;
    draw_line(stage_.canvas, line, {card.lower.x + 0.15 * size, card.upper.y - 0.15 * size - line.descent},
              faded(ink, mark.presence));
  }

 private:
  void note_strokes(const StoryMark& mark) {
    const std::vector<Vec2d> points = in_px(place_, mark);
    for (std::size_t i = 1; i < points.size(); ++i) strokes_.push_back({points[i - 1], points[i]});
    if (mark.kind == MarkKind::shape) strokes_.push_back({points.back(), points.front()});
  }

  void note_dot(const StoryMark& mark) {
    const Vec2d at = place_.to_px(mark.points[0]);
    taken_.push_back(expanded(Aabbd{at, at}, 0.8 * dot_radius(stage_, mark.role)));
  }

  bool is_free(const Aabbd& card) const {
    return contains(place_.room, card) &&
           std::none_of(taken_.begin(), taken_.end(), [&](const Aabbd& other) { return overlaps(card, other); });
  }

  bool is_crossed(const Aabbd& card) const {
    return std::any_of(strokes_.begin(), strokes_.end(), [&](const std::array<Vec2d, 2>& stroke) {
      return BasicRay<double>(stroke[0], stroke[1] - stroke[0]).entry_into(card, 1) <= 1;
    });
  }

  /// On the side the mark asks for, or the next one round that is free.
  Aabbd card_of(const StoryMark& mark, Vec2d extent) const {
    const Vec2d at = place_.to_px(mark.points.back());
    if (mark.side == Vec2d{}) return {at - 0.5 * extent, at + 0.5 * extent};
    const bool dotted = is_point(mark.kind);
    const double gap = dotted ? dot_radius(stage_, mark.role) + 0.08 * extent.y : 0.2 * extent.y;
    const Vec2d side{mark.side.x, -mark.side.y};
    const Aabbd wanted = beside(at, gap, extent, side);
    if (place_.diagram && mark.kind == MarkKind::text) return kept_in_room(wanted);
    constexpr double half = 0.70710678118654752;
    constexpr std::array<Vec2d, 8> turns{Vec2d{1, 0}, {half, half},  {half, -half},  {0, 1},
                                         {0, -1},     {-half, half}, {-half, -half}, {-1, 0}};
    std::optional<Aabbd> second_best;
    for (const Vec2d turn : turns) {
      const Aabbd card =
          beside(at, gap, extent, {side.x * turn.x - side.y * turn.y, side.x * turn.y + side.y * turn.x});
      if (!is_free(card)) continue;
      if (!is_crossed(card)) return card;
      if (!second_best) second_best = card;
    }
    return second_best.value_or(wanted);
  }

  /// Moved to the left where it would leave the pane.
  Aabbd kept_in_room(const Aabbd& card) const {
    const Vec2d by{std::min(0.0, place_.room.upper.x - card.upper.x), 0};
    return {card.lower + by, card.upper + by};
  }

  /// A card of that size that begins `gap` from `at` towards `side`.
  static Aabbd beside(Vec2d at, double gap, Vec2d extent, Vec2d side) {
    const Vec2d way = normalized(side);
    const Vec2d middle = at + gap * way + Vec2d{0.5 * way.x * extent.x, 0.5 * way.y * extent.y};
    return {middle - 0.5 * extent, middle + 0.5 * extent};
  }

  const Stage& stage_;
  const PanePlace& place_;
  std::vector<std::array<Vec2d, 2>> strokes_;
  std::vector<Aabbd> taken_;
};

Paint paint_of_shape(const Stage& stage, const StoryMark& mark, int alpha) {
  const Tone& tone = mark.role == Role::second ? stage.palette.fixed : stage.palette.dynamic;
  return {faded(with_alpha(tone.fill, alpha), mark.presence), faded(tone.outline, mark.presence),
          std::max(2.0, 2.5 * stage.sizes.unit)};
}

/// Overlapping shapes show through each other; the parts of one outline have to be opaque.
void paint_shapes(const Stage& stage, const PanePlace& place, const Marks& marks) {
  for (std::size_t i = 0; i < marks.size();) {
    const StoryMark& mark = *marks[i];
    if (mark.group == 0) {
      paint_shape(stage.canvas, {in_px(place, mark), mark.radius * place.scale.x}, paint_of_shape(stage, mark, 120));
      ++i;
      continue;
    }
    std::vector<ShapePx> parts;
    for (; i < marks.size() && marks[i]->group == mark.group; ++i)
      parts.push_back({in_px(place, *marks[i]), mark.radius * place.scale.x});
    paint_compound(stage.canvas, parts, paint_of_shape(stage, mark, 255));
  }
}

/// Bars that stand for a shape look like it.
Paint paint_of_bar(const Stage& stage, const StoryMark& mark) {
  if (mark.role == Role::first || mark.role == Role::second) return paint_of_shape(stage, mark, 255);
  const int solid = mark.role == Role::rejected ? 110 : 215;
  const Color fill = faded(with_alpha(look_of(stage.palette, mark.role).color, solid), mark.presence);
  return {fill, fill, 0};
}

void paint_area(const Stage& stage, const PanePlace& place, const StoryMark& mark) {
  const Color fill = faded(look_of(stage.palette, mark.role).fill, mark.presence);
  const Paint paint = mark.kind == MarkKind::bar ? paint_of_bar(stage, mark) : Paint{fill, fill, 0};
  if (mark.points.size() <= max_polygon_vertices) stage.canvas.polygon(in_px(place, mark), 0, paint);
}

void paint_dashes(Canvas& canvas, Vec2d from, Vec2d to, double width, Color color) {
  const double whole = distance(from, to);
  const int count = std::max(1, static_cast<int>(whole / (5.5 * width)));
  for (int i = 0; i < count; ++i)
    canvas.line(lerp(from, to, (i + 0.2) / count), lerp(from, to, (i + 0.8) / count), width, color);
}

/// What an arrow points at stays seen: it ends at the rim of the dot.
Vec2d rim_of_dot(const Stage& stage, const PanePlace& place, const Marks& marks, Vec2d from, Vec2d to) {
  for (const StoryMark* mark : marks) {
    if (mark->kind != MarkKind::dot || distance(place.to_px(mark->points[0]), to) > 0.5) continue;
    return to - std::min(dot_radius(stage, mark->role), 0.5 * distance(from, to)) * normalized(to - from);
  }
  return to;
}

void paint_stroke(const Stage& stage, const PanePlace& place, const StoryMark& mark, const Marks& marks) {
  const Look look = look_of(stage.palette, mark.role);
  const std::vector<Vec2d> points = in_px(place, mark);
  const double width = std::max(1.25, look.width * stage.sizes.unit);
  const Color color = faded(look.color, mark.presence);
  if (mark.kind == MarkKind::arrow) {
    stage.canvas.arrow(points[0], rim_of_dot(stage, place, marks, points[0], points[1]), width, color);
  } else if (look.dashed) {
    for (std::size_t i = 1; i < points.size(); ++i) paint_dashes(stage.canvas, points[i - 1], points[i], width, color);
  } else {
    stage.canvas.stroke(points, width, color, color);
  }
}

void paint_cross(const Stage& stage, Vec2d at) {
  const double arm = 11 * stage.sizes.unit;
  const double width = std::max(1.5, 2 * stage.sizes.unit);
  stage.canvas.line(at - Vec2d{arm, 0}, at + Vec2d{arm, 0}, width, stage.palette.ink);
  stage.canvas.line(at - Vec2d{0, arm}, at + Vec2d{0, arm}, width, stage.palette.ink);
}

void paint_point(const Stage& stage, const PanePlace& place, const StoryMark& mark) {
  const Vec2d at = place.to_px(mark.points[0]);
  if (mark.kind == MarkKind::crosswise) return paint_cross(stage, at);
  const double radius = dot_radius(stage, mark.role);
  const Color color = faded(look_of(stage.palette, mark.role).color, mark.presence);
  stage.canvas.disc(at, radius, {color, faded(stage.palette.background, mark.presence), 0.22 * radius});
}

Marks only(const Marks& marks, bool (*wanted)(MarkKind)) {
  Marks kept;
  std::copy_if(marks.begin(), marks.end(), std::back_inserter(kept),
               [&](const StoryMark* mark) { return wanted(mark->kind); });
  return kept;
}

}  // namespace

void draw_marks(const Stage& stage, const PanePlace& place, const std::vector<const StoryMark*>& marks) {
  paint_shapes(stage, place, only(marks, [](MarkKind kind) { return kind == MarkKind::shape; }));
  for (const StoryMark* mark : only(marks, [](MarkKind kind) { return is_area(kind) && kind != MarkKind::shape; }))
    paint_area(stage, place, *mark);
  for (const StoryMark* mark : only(marks, is_stroke)) paint_stroke(stage, place, *mark, marks);
  for (const StoryMark* mark : only(marks, is_point)) paint_point(stage, place, *mark);
  Labels labels(stage, place, marks);
  for (const StoryMark* mark : marks) labels.draw(*mark);
}

}  // namespace proofreel
