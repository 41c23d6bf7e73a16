#include "engine/polygon.h"

#include <algorithm>
#include <optional>

#include "engine/double_double.h"
#include "engine/scene.h"

namespace proofreel {
namespace {

constexpr double largest_coordinate = 1e9;
constexpr double smallest_thickness = 1e-6;  ///< over the extent

/// A corner and the place the user gave it, counted from 1.
struct Corner {
  Vec2d point;
  std::size_t number = 0;
};

double precise_orientation(Vec2d a, Vec2d b, Vec2d c) {
  const DoubleDouble left = two_sum(b.x, -a.x) * two_sum(c.y, -a.y);
  const DoubleDouble right = two_sum(b.y, -a.y) * two_sum(c.x, -a.x);
  const double difference = (left - right).hi;
  return std::fabs(difference) > 0x1p-98 * std::fabs(left.hi) ? difference : 0;
}

double distance_to_segment(Vec2d p, Vec2d a, Vec2d b) {
  const Vec2d along = b - a;
  const double squared = length_squared(along);
  const double t = squared > 0 ? std::clamp(dot(p - a, along) / squared, 0.0, 1.0) : 0;
  return distance(p, lerp(a, b, t));
}

bool all_finite(const std::vector<Vec2d>& points) {
  return std::all_of(points.begin(), points.end(), [](Vec2d p) { return is_finite(p); });
}

std::string corner_named(std::size_t number) { return "corner " + std::to_string(number); }

std::string edge_named(const Corner& from, const Corner& to) {
  return "from corner " + std::to_string(from.number) + " to corner " + std::to_string(to.number);
}

/// The first corner whose coordinates cannot be used.
std::optional<std::string> problem_with_coordinates(const std::vector<Vec2d>& corners) {
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Vec2d p = corners[i];
    if (!is_finite(p)) return corner_named(i + 1) + " of the polygon is not finite: give two ordinary numbers";
    if (std::fabs(p.x) > largest_coordinate || std::fabs(p.y) > largest_coordinate) {
      return corner_named(i + 1) + " of the polygon has a coordinate above 1e9 m: make it smaller or move it nearer";
    }
  }
  return std::nullopt;
}

bool has_three_distinct(const std::vector<Vec2d>& corners) {
  if (corners.empty()) return false;
  const Vec2d first = corners.front();
  const auto second = std::find_if(corners.begin(), corners.end(), [&](Vec2d p) { return !(p == first); });
  return std::any_of(second, corners.end(), [&](Vec2d p) { return !(p == first) && !(p == *second); });
}

/// How near is on it: a billionth of the extent, and what the coordinates' own rounding amounts to.
double tolerance_of(const std::vector<Vec2d>& corners) {
  double extent = 0;
  double size = 0;
  for (const Vec2d p : corners) {
    extent = std::max(extent, distance(p, corners.front()));
    size = std::max({size, std::fabs(p.x), std::fabs(p.y)});
  }
  return 1e-9 * extent + 0x1p-50 * size;
}

/// The corners without those that lie on the straight way between their neighbours; duplicates are of that kind.
std::vector<Corner> without_needless(const std::vector<Vec2d>& corners) {
  const double tolerance = tolerance_of(corners);
  const auto needless = [&](const Corner& before, const Corner& corner, const Corner& after) {
    return distance_to_segment(corner.point, before.point, after.point) <= tolerance;
  };
  std::vector<Corner> kept;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Corner next{corners[i], i + 1};
    while (kept.size() >= 2 && needless(kept[kept.size() - 2], kept.back(), next)) kept.pop_back();
    kept.push_back(next);
  }
  while (kept.size() >= 3) {
    if (needless(kept[kept.size() - 2], kept.back(), kept.front())) {
      kept.pop_back();
    } else if (needless(kept.back(), kept[0], kept[1])) {
      kept.erase(kept.begin());
    } else {
      break;
    }
  }
  return kept;
}

std::vector<Vec2d> points_of(const std::vector<Corner>& corners) {
  std::vector<Vec2d> points;
  points.reserve(corners.size());
  for (const Corner& corner : corners) points.push_back(corner.point);
  return points;
}

/// The width of the narrowest strip that holds the hull (one of its sides lies on an edge), over the largest distance.
double relative_thickness(const std::vector<Vec2d>& hull) {
  double thickness = 4 * largest_coordinate;
  double extent = 0;
  for (std::size_t i = 0; i < hull.size(); ++i) {
    const Vec2d a = hull[i];
    const Vec2d b = hull[(i + 1) % hull.size()];
    double height = 0;
    for (const Vec2d p : hull) {
      height = std::max(height, orientation(a, b, p) / distance(a, b));
      extent = std::max(extent, distance(a, p));
    }
    thickness = std::min(thickness, height);
  }
  return thickness / extent;
}

/// Whether p, known to be on the line through a and b, lies between them.
bool is_between(Vec2d p, Vec2d a, Vec2d b) { return dot(a - p, b - p) <= 0; }

bool segments_meet(Vec2d a, Vec2d b, Vec2d c, Vec2d d) {
  const double c_side = orientation(a, b, c);
  const double d_side = orientation(a, b, d);
  const double a_side = orientation(c, d, a);
  const double b_side = orientation(c, d, b);
  const auto opposite = [](double s, double t) { return (s > 0 && t < 0) || (s < 0 && t > 0); };
  if (opposite(c_side, d_side) && opposite(a_side, b_side)) return true;
  return (c_side == 0 && is_between(c, a, b)) || (d_side == 0 && is_between(d, a, b)) ||
         (a_side == 0 && is_between(a, c, d)) || (b_side == 0 && is_between(b, c, d));
}

/// Whether the outline turns back on itself at `b`.
bool folds_back(Vec2d a, Vec2d b, Vec2d c, double tolerance) {
  return distance_to_segment(c, a, b) <= tolerance || distance_to_segment(a, b, c) <= tolerance;
}

std::optional<std::string> crossing_of(const std::vector<Corner>& corners) {
  const std::size_t n = corners.size();
  const double tolerance = tolerance_of(points_of(corners));
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = i + 1; j < n; ++j) {
      const Corner &a = corners[i], &b = corners[i + 1], &c = corners[j], &d = corners[(j + 1) % n];
      bool crosses = false;
      if (j == i + 1) {
        crosses = folds_back(a.point, b.point, d.point, tolerance);
      } else if ((j + 1) % n == i) {
        crosses = folds_back(c.point, a.point, b.point, tolerance);
      } else {
        crosses = segments_meet(a.point, b.point, c.point, d.point);
      }
      if (crosses) {
        return "the polygon crosses itself: its edge " + edge_named(a, b) + " meets the one " + edge_named(c, d) +
               "; list the corners in the order of the outline";
      }
    }
  }
  return std::nullopt;
}

std::optional<std::string> concavity_of(const std::vector<Corner>& corners) {
  const std::size_t n = corners.size();
  for (std::size_t i = 0; i < n; ++i) {
    if (orientation(corners[(i + n - 1) % n].point, corners[i].point, corners[(i + 1) % n].point) > 0) continue;
    return "the polygon is concave at " + corner_named(corners[i].number) +
           ", and concave polygons are not built yet: cut it into convex pieces and give them as shapes={...}";
  }
  return std::nullopt;
}

std::optional<std::string> problem_with_outline(const std::vector<Corner>& corners) {
  constexpr std::size_t most = max_polygon_vertices;
  if (corners.size() > most) {
    return "the polygon has " + std::to_string(corners.size()) + " corners, at most " + std::to_string(most) +
           " are possible: leave some out, or cut it into pieces and give them as shapes={...}";
  }
  const std::vector<Vec2d> hull = convex_hull(points_of(corners));
  if (corners.size() < 3 || hull.size() < 3) {
    return "all corners of the polygon lie on one line, it has zero area: move one off the line";
  }
  if (relative_thickness(hull) < smallest_thickness) {
    return "the polygon is thinner than a millionth of its extent: make it thicker, or use a segment or capsule";
  }
  return crossing_of(corners);
}

/// Twice the area, and integrals about the first corner.
struct Integrals {
  double twice_area = 0;
  Vec2d sixfold_first;           ///< of the position
  double twelvefold_second = 0;  ///< of the distance squared
};

Integrals integrals_of(std::span<const Vec2d> corners) {
  Integrals sum;
  for (std::size_t i = 2; i < corners.size(); ++i) {
    const Vec2d a = corners[i - 1] - corners[0];
    const Vec2d b = corners[i] - corners[0];
    const double twice_area = cross(a, b);
    sum.twice_area += twice_area;
    sum.sixfold_first += twice_area * (a + b);
    sum.twelvefold_second += twice_area * (dot(a, a) + dot(a, b) + dot(b, b));
  }
  return sum;
}

/// From the first corner.
Vec2d centroid_from(const Integrals& sum) { return sum.sixfold_first * (1 / (3 * sum.twice_area)); }

/// The next corner of the hull after `current`: nothing lies right of the way there; of several in line, the farthest.
Vec2d wrapped_on(const std::vector<Vec2d>& points, Vec2d current) {
  Vec2d next = current;
  for (const Vec2d p : points) {
    if (p == current) continue;
    const double side = next == current ? -1 : orientation(current, next, p);
    const bool farther = length_squared(p - current) > length_squared(next - current);
    if (side < 0 || (side == 0 && farther)) next = p;
  }
  return next;
}

}  // namespace

double orientation(Vec2d a, Vec2d b, Vec2d c) {
  const double left = (b.x - a.x) * (c.y - a.y);
  const double right = (b.y - a.y) * (c.x - a.x);
  const double difference = left - right;
  const double error_bound = 0x1p-51 * (std::fabs(left) + std::fabs(right));
  return std::fabs(difference) > error_bound ? difference : precise_orientation(a, b, c);
}

std::variant<std::vector<Vec2d>, std::string> clean_polygon(const std::vector<Vec2d>& corners) {
  if (const auto problem = problem_with_coordinates(corners)) return *problem;
  if (!has_three_distinct(corners)) {
    return "the polygon has fewer than three distinct points: give at least three corners";
  }
  std::vector<Corner> outline = without_needless(corners);
  if (const auto problem = problem_with_outline(outline)) return *problem;
  if (area_of(points_of(outline)) < 0) std::reverse(outline.begin() + 1, outline.end());
  if (const auto problem = concavity_of(outline)) return *problem;
  return points_of(outline);
}

std::vector<Vec2d> convex_hull(const std::vector<Vec2d>& points) {
  if (points.empty() || !all_finite(points)) return points;
  const Vec2d start = *std::min_element(points.begin(), points.end(),
                                        [](Vec2d a, Vec2d b) { return a.x < b.x || (a.x == b.x && a.y < b.y); });
  std::vector<Vec2d> hull{start};
  Vec2d next = wrapped_on(points, start);
  while (!(next == start) && hull.size() < points.size()) {  // never more, even where huge coordinates overflow
    hull.push_back(next);
    next = wrapped_on(points, next);
  }
  return hull;
}

bool is_convex(std::span<const Vec2d> corners) {
  const std::size_t n = corners.size();
  int turns_in_y = 0;
  double last_rise = 0;
  for (std::size_t i = 0; i < 2 * n; ++i) {
    const Vec2d a = corners[i % n];
    const Vec2d b = corners[(i + 1) % n];
    if (orientation(a, b, corners[(i + 2) % n]) < 0) return false;
    const double rise = b.y - a.y;
    if (i >= n && rise != 0 && (rise > 0) != (last_rise > 0)) ++turns_in_y;
    if (rise != 0) last_rise = rise;
  }
  return n >= 3 && turns_in_y == 2;
}

double area_of(std::span<const Vec2d> corners) { return integrals_of(corners).twice_area / 2; }

Vec2d centroid_of(std::span<const Vec2d> corners) { return corners[0] + centroid_from(integrals_of(corners)); }

double second_moment_of(std::span<const Vec2d> corners) {
  const Integrals sum = integrals_of(corners);
  return sum.twelvefold_second / 12 - sum.twice_area / 2 * length_squared(centroid_from(sum));
}

}  // namespace proofreel
