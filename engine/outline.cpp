#include "engine/outline.h"

#include <algorithm>
#include <optional>

#include "engine/polygon.h"

namespace proofreel {
namespace {

constexpr double smallest_thickness = 1e-6;  ///< over the extent

/// A corner and the place the user gave it, counted from 1.
struct Corner {
  Vec2d point;
  std::size_t number = 0;
};

double distance_to_segment(Vec2d p, Vec2d a, Vec2d b) {
  const Vec2d along = b - a;
  const double squared = length_squared(along);
  const double t = squared > 0 ? std::clamp(dot(p - a, along) / squared, 0.0, 1.0) : 0;
  return distance(p, lerp(a, b, t));
}

std::string corner_named(std::size_t number) { return "corner " + std::to_string(number); }

std::string edge_named(const Corner& from, const Corner& to) {
  return "from corner " + std::to_string(from.number) + " to corner " + std::to_string(to.number);
}

/// The first corner whose coordinates cannot be used.
std::optional<std::string> problem_with_coordinates(const std::vector<Vec2d>& corners, const std::string& name) {
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Vec2d p = corners[i];
    if (!is_finite(p)) return corner_named(i + 1) + " of " + name + " is not finite: give two ordinary numbers";
    if (std::fabs(p.x) > max_coordinate || std::fabs(p.y) > max_coordinate) {
      return corner_named(i + 1) + " of " + name + " has a coordinate above 1e9 m: make it smaller or move it nearer";
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
  double thickness = 4 * max_coordinate;
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

/// Whether the outline turns back on itself at `b`.
bool folds_back(Vec2d a, Vec2d b, Vec2d c, double tolerance) {
  return distance_to_segment(c, a, b) <= tolerance || distance_to_segment(a, b, c) <= tolerance;
}

/// Whether two edges have a common point, or come so near each other that nothing fits between them.
bool edges_meet(Vec2d a, Vec2d b, Vec2d c, Vec2d d, double tolerance) {
  const double nearest = std::min({distance_to_segment(a, c, d), distance_to_segment(b, c, d),
                                   distance_to_segment(c, a, b), distance_to_segment(d, a, b)});
  return nearest <= tolerance || segments_meet(a, b, c, d);
}

std::string meeting_sentence(const std::string& name, const std::string& edges, bool crosses) {
  if (crosses) return name + " crosses itself: " + edges + "; list the corners in the order of the outline";
  return name + " touches itself: " + edges +
         "; leave a gap, and build what goes round a hole of several polygons, shapes={...}";
}

/// The first two edges that have more in common than the end of one that is the start of the other.
std::optional<std::string> meeting_of(const std::vector<Corner>& corners, const std::string& name) {
  const std::size_t n = corners.size();
  const double tolerance = tolerance_of(points_of(corners));
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = i + 1; j < n; ++j) {
      const Corner &a = corners[i], &b = corners[(i + 1) % n], &c = corners[j], &d = corners[(j + 1) % n];
      bool meets = false;
      if (j == i + 1) {
        meets = folds_back(a.point, b.point, d.point, tolerance);
      } else if ((j + 1) % n == i) {
        meets = folds_back(c.point, a.point, b.point, tolerance);
      } else {
        meets = edges_meet(a.point, b.point, c.point, d.point, tolerance);
      }
      if (!meets) continue;
      const std::string edges = "its edge " + edge_named(a, b) + " meets the one " + edge_named(c, d);
      return meeting_sentence(name, edges, segments_cross(a.point, b.point, c.point, d.point));
    }
  }
  return std::nullopt;
}

std::optional<std::string> problem_with_outline(const std::vector<Corner>& corners, const std::string& name) {
  constexpr std::size_t most = max_outline_corners;
  if (corners.size() > most) {
    return name + " has " + std::to_string(corners.size()) + " corners, at most " + std::to_string(most) +
           " are possible: leave some out, or cut it into pieces and give them as shapes={...}";
  }
  const std::vector<Vec2d> hull = convex_hull(points_of(corners));
  if (corners.size() < 3 || hull.size() < 3) {
    return "all corners of " + name + " lie on one line, it has zero area: move one off the line";
  }
  if (relative_thickness(hull) < smallest_thickness) {
    return name + " is thinner than a millionth of its extent: make it thicker, or use a segment or capsule";
  }
  return meeting_of(corners, name);
}

/// Whether a simple outline goes round clockwise: it does so at its leftmost corner, which cannot be concave. The sign
/// of the area would say the same, but may drown in rounding.
bool is_clockwise(const std::vector<Corner>& corners) {
  const auto before = [](const Corner& a, const Corner& b) {
    return a.point.x < b.point.x || (a.point.x == b.point.x && a.point.y < b.point.y);
  };
  const std::size_t n = corners.size();
  const auto i = static_cast<std::size_t>(std::min_element(corners.begin(), corners.end(), before) - corners.begin());
  return orientation(corners[(i + n - 1) % n].point, corners[i].point, corners[(i + 1) % n].point) < 0;
}

}  // namespace

std::variant<std::vector<Vec2d>, std::string> clean_polygon(const std::vector<Vec2d>& corners,
                                                            const std::string& name) {
  if (const auto problem = problem_with_coordinates(corners, name)) return *problem;
  if (!has_three_distinct(corners)) {
    return name + " has fewer than three distinct points: give at least three corners";
  }
  std::vector<Corner> outline = without_needless(corners);
  if (const auto problem = problem_with_outline(outline, name)) return *problem;
  if (is_clockwise(outline)) std::reverse(outline.begin() + 1, outline.end());
  return points_of(outline);
}

}  // namespace proofreel
