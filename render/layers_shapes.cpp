#include <algorithm>

#include "render/canvas_geometry.h"
#include "render/draw_layers.h"

namespace proofreel {
namespace {

/// A wall without thickness is drawn as thick as its outline would be on both sides.
void paint_segment(Canvas& canvas, const ShapePx& shape, const Paint& paint) {
  canvas.line(shape.points[0], shape.points[1], 2 * std::max(paint.outline_px, 1.0), paint.outline);
}

/// How an edge from `a` to `b` lies on the edges of another shape, which run the other way round.
enum class Sharing { none, part_of_longer, whole };

bool lies_between(Vec2d p, Vec2d a, Vec2d b, double near_px) {
  const double along = length(b - a);
  const Vec2d direction = normalized(b - a);
  const double at = dot(p - a, direction);
  return std::abs(cross(direction, p - a)) < near_px && at > -near_px && at < along + near_px;
}

Sharing sharing_with(const ShapePx& other, Vec2d a, Vec2d b) {
  constexpr double near_px = 0.25;
  const std::vector<Vec2d> corners = oriented(other.points);
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Vec2d from = corners[i];
    const Vec2d to = corners[(i + 1) % corners.size()];
    if (distance(from, b) < near_px && distance(to, a) < near_px) return Sharing::whole;
    const bool opposite = dot(to - from, b - a) < 0;
    if (opposite && lies_between(a, from, to, near_px) && lies_between(b, from, to, near_px)) {
      return Sharing::part_of_longer;
    }
  }
  return Sharing::none;
}

Sharing sharing_of(const std::vector<ShapePx>& shapes, std::size_t own, Vec2d a, Vec2d b) {
  for (std::size_t i = 0; i < shapes.size(); ++i) {
    if (i == own || shapes[i].radius > 0 || shapes[i].points.size() < 3) continue;
    const Sharing sharing = sharing_with(shapes[i], a, b);
    if (sharing != Sharing::none) return sharing;
  }
  return Sharing::none;
}

/// Whether the point lies inside another shape.
bool is_covered(const std::vector<ShapePx>& shapes, std::size_t own, Vec2d p) {
  for (std::size_t i = 0; i < shapes.size(); ++i) {
    if (i == own || shapes[i].points.size() < 3) continue;
    const std::vector<Vec2d> corners = oriented(shapes[i].points);
    bool inside = true;
    for (std::size_t j = 0; j < corners.size(); ++j) {
      const Vec2d along = normalized(corners[(j + 1) % corners.size()] - corners[j]);
      inside = inside && cross(along, p - corners[j]) > 0.25;
    }
    if (inside) return true;
  }
  return false;
}

/// How far the fill goes beyond an edge: short of the outline, or a little over an edge shared with another piece, so
/// that no seam shows; over the outline that a longer edge of the neighbour has there.
double reach_over(Sharing sharing, double outline_px) {
  constexpr double over_px = 0.75;
  if (sharing == Sharing::none) return -outline_px;
  return sharing == Sharing::whole ? over_px : outline_px + over_px;
}

/// A sharp polygon without its outline.
std::vector<Vec2d> inside_of(const std::vector<ShapePx>& shapes, std::size_t own, double outline_px) {
  const std::vector<Vec2d> corners = oriented(shapes[own].points);
  Aabbd bounds;
  for (const Vec2d p : corners) bounds = merged(bounds, p);
  bounds = expanded(bounds, 2 * outline_px + 1);
  std::vector<Vec2d> inside{
      bounds.lower, {bounds.upper.x, bounds.lower.y}, bounds.upper, {bounds.lower.x, bounds.upper.y}};
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Vec2d a = corners[i];
    const Vec2d b = corners[(i + 1) % corners.size()];
    const Vec2d outward = -perp(normalized(b - a));
    inside = cut(inside, outward, dot(outward, a) + reach_over(sharing_of(shapes, own, a, b), outline_px));
  }
  return inside;
}

/// The part of a shape inside its outline.
ShapePx inside_of_outline(const std::vector<ShapePx>& shapes, std::size_t own, double outline_px) {
  const ShapePx& shape = shapes[own];
  if (shape.points.size() < 3 || shape.radius >= outline_px) return {shape.points, shape.radius - outline_px};
  return {inside_of(shapes, own, outline_px - shape.radius), 0};
}

}  // namespace

void paint_shape(Canvas& canvas, const ShapePx& shape, const Paint& paint) {
  if (shape.points.size() == 1) {
    canvas.disc(shape.points[0], shape.radius, paint);
  } else if (shape.points.size() == 2 && shape.radius == 0) {
    paint_segment(canvas, shape, paint);
  } else if (shape.points.size() == 2) {
    canvas.capsule(shape.points[0], shape.points[1], shape.radius, paint);
  } else {
    canvas.polygon(shape.points, shape.radius, paint);
  }
}

void paint_compound(Canvas& canvas, const std::vector<ShapePx>& shapes, const Paint& paint) {
  for (const ShapePx& shape : shapes) paint_shape(canvas, shape, {paint.outline, paint.outline, 0});
  for (std::size_t i = 0; i < shapes.size(); ++i) {
    if (shapes[i].points.size() == 2 && shapes[i].radius == 0) continue;
    const ShapePx inside = inside_of_outline(shapes, i, paint.outline_px);
    if (inside.points.size() == 2 && inside.radius <= 0) continue;
    paint_shape(canvas, inside, {paint.fill, paint.fill, 0});
  }
}

void paint_seams(Canvas& canvas, const std::vector<ShapePx>& shapes, double width_px, Color color) {
  for (std::size_t own = 0; own < shapes.size(); ++own) {
    if (shapes[own].points.size() < 3) continue;
    const std::vector<Vec2d> corners = oriented(shapes[own].points);
    for (std::size_t i = 0; i < corners.size(); ++i) {
      const Vec2d a = corners[i];
      const Vec2d b = corners[(i + 1) % corners.size()];
      const bool inner = sharing_of(shapes, own, a, b) != Sharing::none || is_covered(shapes, own, 0.5 * (a + b));
      if (inner) canvas.line(a, b, width_px, color);
    }
  }
}

}  // namespace proofreel
