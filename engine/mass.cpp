#include "engine/mass.h"

#include "engine/elementary.h"
#include "engine/rot.h"

namespace proofreel {
namespace {

constexpr double pi = 3.14159265358979323846;

/// Area, first and second moment about the origin of `reference`, which keeps the sums small far from the origin.
struct Moments {
  double area = 0;
  Vec2d first;
  double second = 0;

  void add(double part_area, Vec2d center, double own_second) {
    area += part_area;
    first += part_area * center;
    second += own_second + part_area * length_squared(center);
  }
};

/// The fan triangle (0, a, b).
void add_triangle(Moments& m, Vec2d a, Vec2d b) {
  const double area = 0.5 * cross(a, b);
  m.area += area;
  m.first += area / 3 * (a + b);
  m.second += area / 6 * (dot(a, a) + dot(a, b) + dot(b, b));
}

/// The rectangle that rounding puts on the outside of the edge a -> b.
void add_edge_strip(Moments& m, Vec2d a, Vec2d b, double radius) {
  const double edge = distance(a, b);
  const Vec2d outward = -perp(normalized(b - a));
  const double area = edge * radius;
  m.add(area, 0.5 * (a + b) + 0.5 * radius * outward, area * (edge * edge + radius * radius) / 12);
}

/// The sector that rounding puts on a corner between the edge directions `in` and `out` (unit vectors).
void add_corner(Moments& m, Vec2d corner, Vec2d in, Vec2d out, double radius) {
  double turn = elementary::atan2(cross(in, out), dot(in, out));
  if (turn <= 0) turn = pi;  // a capsule's end turns back on itself
  const double half = 0.5 * turn;
  const Vec2d bisector = rotate(Rotd(half), -perp(in));
  const double area = half * radius * radius;
  const double reach = 2.0 / 3.0 * radius * elementary::sin(half) / half;
  const double about_corner = 0.5 * area * radius * radius;
  m.add(area, corner + reach * bisector, about_corner - area * reach * reach);
}

void add_rounded_hull(Moments& m, std::span<const Vec2d> points, Vec2d origin, double radius) {
  const std::size_t n = points.size();
  for (std::size_t i = 0; i < n; ++i) {
    const Vec2d before = points[(i + n - 1) % n] - origin;
    const Vec2d here = points[i] - origin;
    const Vec2d after = points[(i + 1) % n] - origin;
    if (n > 2) add_triangle(m, here, after);
    if (radius <= 0) continue;
    add_edge_strip(m, here, after, radius);
    add_corner(m, here, normalized(here - before), normalized(after - here), radius);
  }
}

}  // namespace

MassProperties mass_of(const ShapeDef& shape) {
  const Vec2d origin = shape.points.front();
  const double r2 = shape.radius * shape.radius;
  if (shape.points.size() == 1) {
    const double mass = shape.density * pi * r2;
    return {mass, origin, 0.5 * mass * r2};
  }
  Moments m;
  add_rounded_hull(m, shape.points, origin, shape.radius);
  if (m.area <= 0) return {0, 0.5 * (shape.points.front() + shape.points.back()), 0};
  const Vec2d offset = (1 / m.area) * m.first;
  return {shape.density * m.area, origin + offset, shape.density * (m.second - m.area * length_squared(offset))};
}

MassProperties combined(std::span<const MassProperties> parts) {
  MassProperties sum;
  if (parts.empty()) return sum;
  const Vec2d origin = parts.front().center;
  Vec2d first;
  for (const MassProperties& p : parts) {
    sum.mass += p.mass;
    first += p.mass * (p.center - origin);
  }
  sum.center = sum.mass > 0 ? origin + (1 / sum.mass) * first : origin;
  for (const MassProperties& p : parts) sum.inertia += p.inertia + p.mass * length_squared(p.center - sum.center);
  return sum;
}

namespace {

/// Shapes without area (segments) weigh by their length, so that a given mass has somewhere to sit.
MassProperties mass_of_segment(const ShapeDef& shape) {
  const double l = distance(shape.points.front(), shape.points.back());
  return {l, 0.5 * (shape.points.front() + shape.points.back()), l * l * l / 12};
}

MassProperties mass_of_shapes(const BodyDef& body) {
  std::vector<MassProperties> parts;
  for (const ShapeDef& shape : body.shapes) parts.push_back(mass_of(shape));
  MassProperties sum = combined(parts);
  if (sum.mass > 0 || !body.mass) return sum;
  for (std::size_t i = 0; i < parts.size(); ++i) parts[i] = mass_of_segment(body.shapes[i]);
  return combined(parts);
}

}  // namespace

MassProperties mass_of(const BodyDef& body) {
  if (body.type != BodyType::dynamic) return {};
  MassProperties result = mass_of_shapes(body);
  if (body.mass) {
    if (result.mass > 0) result.inertia *= *body.mass / result.mass;
    result.mass = *body.mass;
  }
  if (body.inertia) result.inertia = *body.inertia;
  return result;
}

}  // namespace proofreel
