#include "engine/polygon.h"

#include <algorithm>

namespace proofreel {
namespace {

bool all_finite(const std::vector<Vec2d>& points) {
  return std::all_of(points.begin(), points.end(), [](Vec2d p) { return is_finite(p); });
}

/// Twice the area, and what the centroid is made of, about the first corner.
struct Integrals {
  double twice_area = 0;
  Vec2d sixfold_first;  ///< of the position
};

template <typename Observer>
Integrals integrals_of(std::span<const Vec2d> corners, Observer observer) {
  Integrals sum;
  for (std::size_t i = 2; i < corners.size(); ++i) {
    const Vec2d a = corners[i - 1] - corners[0];
    const Vec2d b = corners[i] - corners[0];
    const double twice_area = cross(a, b);
    sum.twice_area += twice_area;
    sum.sixfold_first += twice_area * (a + b);
    if constexpr (Observer::watches)
      observer([&] {
        return TriangleAdded{corners[0], corners[i - 1], corners[i], twice_area / 2, corners[0] + (1.0 / 3) * (a + b)};
      });
  }
  return sum;
}

/// From the first corner.
Vec2d centroid_from(const Integrals& sum) { return sum.sixfold_first * (1 / (3 * sum.twice_area)); }

/// The next corner of the hull after `current`: nothing lies right of the way there; of several in line, the farthest.
template <typename Observer>
Vec2d wrapped_on(const std::vector<Vec2d>& points, Vec2d current, Observer observer) {
  Vec2d next = current;
  for (const Vec2d p : points) {
    if (p == current || p == next) continue;
    if (next == current) {
      next = p;
      continue;
    }
    const double side = orientation(current, next, p);
    const bool better = side < 0 || (side == 0 && is_between(next, current, p));
    if constexpr (Observer::watches) observer([&] { return HullCandidate{current, next, p, better}; });
    if (better) next = p;
  }
  return next;
}

/// The corners without those that equal the one before.
std::vector<Vec2d> without_repetitions(std::span<const Vec2d> corners) {
  std::vector<Vec2d> kept;
  for (const Vec2d p : corners) {
    if (kept.empty() || !(p == kept.back())) kept.push_back(p);
  }
  while (kept.size() > 1 && kept.back() == kept.front()) kept.pop_back();
  return kept;
}

/// How often the outline changes between going up and going down: twice for every time it goes round.
int turns_in_y(const std::vector<Vec2d>& corners) {
  const std::size_t n = corners.size();
  int turns = 0;
  double last_rise = 0;
  for (std::size_t i = 0; i < 2 * n; ++i) {
    const double rise = corners[(i + 1) % n].y - corners[i % n].y;
    if (i >= n && rise != 0 && (rise > 0) != (last_rise > 0)) ++turns;
    if (rise != 0) last_rise = rise;
  }
  return turns;
}

/// Whether `one` and `other` lie on different sides of the line through a and c, or on it.
template <typename Observer>
bool separates(Vec2d a, Vec2d c, Vec2d one, Vec2d other, bool& has_area, Observer observer) {
  const double side = orientation(a, c, one);
  const double other_side = orientation(a, c, other);
  const bool result = !(side > 0 && other_side > 0) && !(side < 0 && other_side < 0);
  has_area = has_area || side != 0 || other_side != 0;
  if constexpr (Observer::watches) observer([&] { return DiagonalTested{a, c, one, other, result}; });
  return result;
}

}  // namespace

template <typename Observer>
std::vector<Vec2d> convex_hull(const std::vector<Vec2d>& points, Observer observer) {
  if (points.empty() || !all_finite(points)) return points;
  const Vec2d start = *std::min_element(points.begin(), points.end(),
                                        [](Vec2d a, Vec2d b) { return a.x < b.x || (a.x == b.x && a.y < b.y); });
  std::vector<Vec2d> hull;
  Vec2d next = start;
  do {
    hull.push_back(next);
    if constexpr (Observer::watches) observer([&] { return HullCorner{next, hull.size() - 1}; });
    next = wrapped_on(points, next, observer);
  } while (!(next == start));
  return hull;
}

template <typename Observer>
bool is_convex(std::span<const Vec2d> corners, Observer observer) {
  const std::vector<Vec2d> outline = without_repetitions(corners);
  const std::size_t n = outline.size();
  bool has_area = false;
  for (std::size_t i = 0; i < n; ++i) {
    const Vec2d before = outline[(i + n - 1) % n];
    const Vec2d after = outline[(i + 1) % n];
    const double turn = orientation(before, outline[i], after);
    if constexpr (Observer::watches) observer([&] { return CornerTested{before, outline[i], after, turn, turn >= 0}; });
    if (turn < 0) return false;
    has_area = has_area || turn > 0;
  }
  return has_area && turns_in_y(outline) == 2;
}

template <typename Observer>
bool quadrilateral_is_convex(Vec2d a, Vec2d b, Vec2d c, Vec2d d, Observer observer) {
  bool has_area = false;
  return separates(a, c, b, d, has_area, observer) && separates(b, d, a, c, has_area, observer) && has_area;
}

template <typename Observer>
double area_of(std::span<const Vec2d> corners, Observer observer) {
  return integrals_of(corners, observer).twice_area / 2;
}

template <typename Observer>
Vec2d centroid_of(std::span<const Vec2d> corners, Observer observer) {
  return corners[0] + centroid_from(integrals_of(corners, observer));
}

std::vector<Vec2d> inset(const std::vector<Vec2d>& corners, double by) {
  std::vector<Vec2d> rest = corners;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Vec2d inward = perp(normalized(corners[(i + 1) % corners.size()] - corners[i]));
    const auto depth = [&](Vec2d p) { return dot(inward, p - corners[i]) - by; };
    std::vector<Vec2d> kept;
    for (std::size_t j = 0; j < rest.size(); ++j) {
      const Vec2d a = rest[j];
      const Vec2d b = rest[(j + 1) % rest.size()];
      if (depth(a) >= 0) kept.push_back(a);
      if ((depth(a) < 0) != (depth(b) < 0)) kept.push_back(lerp(a, b, depth(a) / (depth(a) - depth(b))));
    }
    rest = std::move(kept);
  }
  return rest;
}

template std::vector<Vec2d> convex_hull<NoObserver>(const std::vector<Vec2d>&, NoObserver);
template std::vector<Vec2d> convex_hull<Observer>(const std::vector<Vec2d>&, Observer);
template bool is_convex<NoObserver>(std::span<const Vec2d>, NoObserver);
template bool is_convex<Observer>(std::span<const Vec2d>, Observer);
template bool quadrilateral_is_convex<NoObserver>(Vec2d, Vec2d, Vec2d, Vec2d, NoObserver);
template bool quadrilateral_is_convex<Observer>(Vec2d, Vec2d, Vec2d, Vec2d, Observer);
template double area_of<NoObserver>(std::span<const Vec2d>, NoObserver);
template double area_of<Observer>(std::span<const Vec2d>, Observer);
template Vec2d centroid_of<NoObserver>(std::span<const Vec2d>, NoObserver);
template Vec2d centroid_of<Observer>(std::span<const Vec2d>, Observer);

}  // namespace proofreel
