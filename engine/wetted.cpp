#include "engine/wetted.h"

#include <algorithm>
#include <limits>

#include "engine/elementary.h"

namespace proofreel {
inline namespace PROOFREEL_PRECISION {
namespace {

constexpr double pi = 3.14159265358979323846;

/// Sums up the rim of a region, walked counter-clockwise; y is measured from the water line, x from the centre of mass.
class Rim {
 public:
  /// A straight piece; what is above the line is left out.
  void add_edge(Vec2d a, Vec2d b);
  /// A piece of a circle, from the angle `from` to `to`; angles are measured from straight down, counter-clockwise:
  /// the point at angle u is center + radius (sin u, -cos u). What is above the line is left out.
  void add_arc(Vec2d center, double radius, double from, double to);
  /// The moments about the centre of mass, which lies `line` below the water line.
  Wetted about_center(double line) const;

 private:
  void add_wet_arc(Vec2d center, double radius, double from, double to);

  double area_ = 0;
  Vec2d first_;
  double xx_ = 0;  ///< integral of x^2
  double yy_ = 0;
};

/// The point between `a` and `b` at height 0.
Vec2d crossing(Vec2d a, Vec2d b) { return {a.x + (b.x - a.x) * (a.y / (a.y - b.y)), 0}; }

void Rim::add_edge(Vec2d a, Vec2d b) {
  if (a.y >= 0 && b.y >= 0) return;
  if (a.y > 0) a = crossing(a, b);
  if (b.y > 0) b = crossing(b, a);
  const double w = b.x - a.x;
  area_ -= w * (a.y + b.y) / 2;
  first_.x -= w * (2 * (a.x * a.y + b.x * b.y) + a.x * b.y + b.x * a.y) / 6;
  first_.y -= w * (a.y * a.y + a.y * b.y + b.y * b.y) / 6;
  xx_ -= w * (a.x * a.x * (3 * a.y + b.y) + 2 * a.x * b.x * (a.y + b.y) + b.x * b.x * (a.y + 3 * b.y)) / 12;
  yy_ -= w * (a.y + b.y) * (a.y * a.y + b.y * b.y) / 12;
}

/// The circle is under water where |u| <= reach, with cos(reach) = height of its centre / radius; and again a full turn
/// further on.
void Rim::add_arc(Vec2d center, double radius, double from, double to) {
  if (center.y >= radius) return;
  const double reach = center.y <= -radius ? pi : elementary::acos(center.y / radius);
  for (const double turn : {0.0, 2 * pi}) {
    const double begin = std::max(from - turn, -reach);
    const double end = std::min(to - turn, reach);
    if (begin < end) add_wet_arc(center, radius, begin, end);
  }
}

/// With x = cx + r sin u, y = cy - r cos u, dx = r cos u du; every integral is one of products of sines and cosines.
void Rim::add_wet_arc(Vec2d center, double r, double from, double to) {
  const double s0 = elementary::sin(from);
  const double s1 = elementary::sin(to);
  const double c0 = elementary::cos(from);
  const double c1 = elementary::cos(to);
  const double turn = to - from;
  const double double_angle = s1 * c1 - s0 * c0;                                       // half of sin(2u)
  const double quadruple = s1 * c1 * (1 - 2 * s1 * s1) - s0 * c0 * (1 - 2 * s0 * s0);  // a quarter of sin(4u)
  const double c = s1 - s0;                                                            // of cos u, and so on
  const double cc = (turn + double_angle) / 2;
  const double ccc = (s1 - s1 * s1 * s1 / 3) - (s0 - s0 * s0 * s0 / 3);
  const double cccc = (3 * turn + 4 * double_angle + quadruple) / 8;
  const double sc = (c0 * c0 - c1 * c1) / 2;
  const double scc = (c0 * c0 * c0 - c1 * c1 * c1) / 3;
  const double ssc = (s1 * s1 * s1 - s0 * s0 * s0) / 3;
  const double sscc = (turn - quadruple) / 8;
  const auto [x, y] = center;
  const double area = r * (r * cc - y * c);
  area_ += area;
  first_.x += x * area + r * r * (r * scc - y * sc);
  first_.y -= r / 2 * (y * y * c - 2 * y * r * cc + r * r * ccc);
  xx_ += x * x * area + 2 * x * r * r * (r * scc - y * sc) + r * r * r * (r * sscc - y * ssc);
  yy_ -= r / 3 * (y * y * y * c - 3 * y * y * r * cc + 3 * y * r * r * ccc - r * r * r * cccc);
}

Wetted Rim::about_center(double line) const {
  const double second = xx_ + yy_ + line * (2 * first_.y + line * area_);
  return {area_, {first_.x, first_.y + line * area_}, second};
}

/// The arc round a corner between the outward normals of its two edges.
void add_corner(Rim& rim, const Hull& hull, Vec2d corner, Vec2d normal_before, Vec2d normal_after) {
  const auto radius = static_cast<double>(hull.radius);
  if (hull.count == 1) return rim.add_arc(corner, radius, -pi, pi);
  const double from = elementary::atan2(normal_before.x, -normal_before.y);
  double turn = elementary::atan2(cross(normal_before, normal_after), dot(normal_before, normal_after));
  if (turn <= 0) turn = hull.count == 2 ? pi : 0;  // at a capsule's end the rim turns right back
  rim.add_arc(corner, radius, from, from + turn);
}

}  // namespace

Wetted& Wetted::operator+=(const Wetted& other) {
  area += other.area;
  first += other.first;
  second += other.second;
  return *this;
}

Wetted wetted_part(const Hull& hull, Rot rotation, double level) {
  const Rotd turned(rotation);
  const auto radius = static_cast<double>(hull.radius);
  Vec2d points[max_polygon_vertices];
  double top = std::numeric_limits<double>::lowest();
  double bottom = std::numeric_limits<double>::max();
  for (int i = 0; i < hull.count; ++i) {
    points[i] = rotate(turned, Vec2d(hull.points[i]));
    top = std::max(top, points[i].y + radius);
    bottom = std::min(bottom, points[i].y - radius);
  }
  if (bottom >= level) return {};
  const double line = std::min(level, top);
  Rim rim;
  for (int i = 0; i < hull.count; ++i) {
    const int before = (i + hull.count - 1) % hull.count;
    const int after = (i + 1) % hull.count;
    const Vec2d normal = rotate(turned, Vec2d(hull.normals[i]));
    const Vec2d from{points[i].x, points[i].y - line};
    const Vec2d to{points[after].x, points[after].y - line};
    if (radius > 0) add_corner(rim, hull, from, rotate(turned, Vec2d(hull.normals[before])), normal);
    if (hull.count > 1) rim.add_edge(from + radius * normal, to + radius * normal);
  }
  return rim.about_center(line);
}

}  // namespace PROOFREEL_PRECISION
}  // namespace proofreel
