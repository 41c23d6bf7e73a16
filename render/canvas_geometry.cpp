#include "render/canvas_geometry.h"

#include <algorithm>
#include <cmath>

namespace proofreel {
namespace {

/// Narrows [first, last] of a segment to where `start + t * way <= limit`; false when nothing is left.
bool narrow(double start, double way, double limit, double& first, double& last) {
  if (way == 0) return start <= limit;
  const double t = (limit - start) / way;
  if (way > 0) {
    last = std::min(last, t);
  } else {
    first = std::max(first, t);
  }
  return first <= last;
}

}  // namespace

double doubled_area(std::span<const Vec2d> corners) {
  double sum = 0;
  for (std::size_t i = 1; i + 1 < corners.size(); ++i)
    sum += cross(corners[i] - corners[0], corners[i + 1] - corners[0]);
  return sum;
}

std::vector<Vec2d> oriented(std::span<const Vec2d> corners) {
  std::vector<Vec2d> result(corners.begin(), corners.end());
  if (doubled_area(corners) < 0) std::reverse(result.begin(), result.end());
  return result;
}

std::vector<Vec2d> cut(const std::vector<Vec2d>& corners, Vec2d normal, double offset) {
  std::vector<Vec2d> kept;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Vec2d a = corners[i];
    const Vec2d b = corners[(i + 1) % corners.size()];
    const double over_a = dot(normal, a) - offset;
    const double over_b = dot(normal, b) - offset;
    if (over_a <= 0) kept.push_back(a);
    if ((over_a < 0 && over_b > 0) || (over_a > 0 && over_b < 0))
      kept.push_back(lerp(a, b, over_a / (over_a - over_b)));
  }
  return kept;
}

std::vector<Vec2d> clipped(const std::vector<Vec2d>& corners, const Aabbd& box) {
  std::vector<Vec2d> rest = cut(corners, {1, 0}, box.upper.x);
  rest = cut(rest, {-1, 0}, -box.lower.x);
  rest = cut(rest, {0, 1}, box.upper.y);
  rest = cut(rest, {0, -1}, -box.lower.y);
  return rest.size() < 3 ? std::vector<Vec2d>{} : rest;
}

bool clip_segment(Vec2d& a, Vec2d& b, const Aabbd& box) {
  const Vec2d way = b - a;
  double first = 0;
  double last = 1;
  if (!narrow(a.x, way.x, box.upper.x, first, last) || !narrow(-a.x, -way.x, -box.lower.x, first, last)) return false;
  if (!narrow(a.y, way.y, box.upper.y, first, last) || !narrow(-a.y, -way.y, -box.lower.y, first, last)) return false;
  const Vec2d start = a;
  if (first > 0) a = start + first * way;
  if (last < 1) b = start + last * way;
  return true;
}

double area(const Quad& quad) { return 4 * quad.half_x * quad.half_y; }

Quad quad_of(const Aabbd& box) {
  const Vec2d half = 0.5 * (box.upper - box.lower);
  return {center(box), {1, 0}, half.x, half.y};
}

Aabbd bounds_of(const Quad& quad) {
  const Vec2d reach{std::abs(quad.axis.x) * quad.half_x + std::abs(quad.axis.y) * quad.half_y,
                    std::abs(quad.axis.y) * quad.half_x + std::abs(quad.axis.x) * quad.half_y};
  return {quad.center - reach, quad.center + reach};
}

bool may_touch(const Quad& quad, const Aabbd& box) {
  const Vec2d half = 0.5 * (box.upper - box.lower);
  const Vec2d way = 0.5 * (box.upper + box.lower) - quad.center;
  const double along = std::abs(quad.axis.x) * half.x + std::abs(quad.axis.y) * half.y;
  const double across = std::abs(quad.axis.y) * half.x + std::abs(quad.axis.x) * half.y;
  return std::abs(dot(way, quad.axis)) <= quad.half_x + along &&
         std::abs(dot(way, perp(quad.axis))) <= quad.half_y + across;
}

Quad smallest_quad(const std::vector<Vec2d>& corners) {
  Quad best;
  double best_area = std::numeric_limits<double>::max();
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Vec2d axis = normalized(corners[(i + 1) % corners.size()] - corners[i]);
    if (axis == Vec2d{}) continue;
    Aabbd turned;
    for (const Vec2d p : corners) turned = merged(turned, Vec2d{dot(p, axis), cross(axis, p)});
    Quad quad = quad_of(turned);
    if (area(quad) >= best_area) continue;
    best_area = area(quad);
    quad.center = quad.center.x * axis + quad.center.y * perp(axis);
    quad.axis = axis;
    best = quad;
  }
  return best;
}

bool is_rectangle(std::span<const Vec2d> corners, Quad& rectangle) {
  constexpr double tolerance_px = 1e-3;
  if (corners.size() != 4) return false;
  const Vec2d side = corners[1] - corners[0];
  const Vec2d other = corners[3] - corners[0];
  const double along = length(side);
  if (along == 0 || distance(corners[2], corners[1] + other) > tolerance_px) return false;
  if (std::abs(dot(side, other)) > tolerance_px * along) return false;
  rectangle = {0.5 * (corners[0] + corners[2]), normalized(side), 0.5 * along, 0.5 * length(other)};
  return true;
}

std::vector<Vec2d> disc_near(Vec2d center, double radius, const Aabbd& box) {
  constexpr int chords = 12;
  const Vec2d middle = 0.5 * (box.lower + box.upper);
  const Vec2d up = middle == center ? Vec2d{0, 1} : normalized(middle - center);
  const Vec2d side = perp(up);
  const double reach = std::min(distance(box.lower, box.upper), 0.5 * radius);
  const Vec2d far_end = center - radius * up;  // out of the box: it is smaller than the disc
  std::vector<Vec2d> corners{far_end - reach * side, far_end + reach * side};
  for (int i = 0; i <= chords; ++i) {
    const double along = reach * (1 - 2.0 * i / chords);
    corners.push_back(center + along * side + std::sqrt(radius * radius - along * along) * up);
  }
  return oriented(corners);
}

}  // namespace proofreel
