#pragma once

/// Random hulls by the million, and the truth about two of them by brute force in double precision: every corner
/// against every edge, without anything the engine's algorithms rest on.

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "engine/polygon.h"
#include "engine/shape.h"
#include "tests/engine/random.h"
#include "tests/engine/scenes.h"

namespace proofreel::test {

#ifdef NDEBUG
inline constexpr int pairs_per_kind = 1000000;
#else
inline constexpr int pairs_per_kind = 20000;  // without optimisation the rest would take minutes
#endif

enum class Kind { disc, capsule, polygon };

struct KindPair {
  Kind a, b;
};
inline constexpr std::array<KindPair, 6> kind_pairs{{{Kind::disc, Kind::disc},
                                                     {Kind::disc, Kind::capsule},
                                                     {Kind::disc, Kind::polygon},
                                                     {Kind::capsule, Kind::capsule},
                                                     {Kind::capsule, Kind::polygon},
                                                     {Kind::polygon, Kind::polygon}}};

/// Where a hull is.
struct PlacedHull {
  Hull hull;
  Pose pose;
};

inline PlacedHull place(const ShapeDef& shape, Vec2d position, double angle = 0) {
  return {make_hull(shape, {}), {Vec2(position), Rot(Rotd(angle))}};
}

inline ShapeDef polygon_shape(std::vector<Vec2d> corners, double radius = 0) {
  ShapeDef shape;
  shape.points = std::move(corners);
  shape.radius = radius;
  return shape;
}

inline std::vector<Vec2d> random_corners(Random& random) {
  std::vector<Vec2d> corners;
  while (corners.size() < 3) {
    corners.clear();
    const std::uint32_t tries = 3 + random.below(random.below(8) == 0 ? 60 : 8);
    const double flatness = random.below(4) == 0 ? 0.01 : 1;
    for (std::uint32_t i = 0; i < tries; ++i) {
      corners.push_back({random.between(-1, 1), flatness * random.between(-1, 1)});
    }
    corners = convex_hull(corners);
    if (corners.size() > max_polygon_vertices) corners.resize(max_polygon_vertices);
  }
  return corners;
}

inline ShapeDef random_shape(Random& random, Kind kind) {
  const double radius = random.below(2) == 0 ? random.between(0.01, 0.4) : 0;
  if (kind == Kind::disc) return polygon_shape({{random.between(-1, 1), random.between(-1, 1)}}, radius);
  if (kind == Kind::polygon) return polygon_shape(random_corners(random), radius);
  return polygon_shape({{random.between(-1, 0), random.between(-1, 1)}, {random.between(0, 1), random.between(-1, 1)}},
                       radius);
}

/// Hulls to draw from: making one takes longer than what is tested.
class HullPool {
 public:
  explicit HullPool(std::uint64_t seed) : random_(seed) {
    for (const Kind kind : {Kind::disc, Kind::capsule, Kind::polygon}) {
      std::vector<Hull>& pool = pools_[static_cast<std::size_t>(kind)];
      for (int i = 0; i < 200; ++i) pool.push_back(make_hull(random_shape(random_, kind), {}));
    }
  }
  /// In any direction, up to `spread` from the origin.
  PlacedHull draw(Kind kind, double spread) {
    const std::vector<Hull>& pool = pools_[static_cast<std::size_t>(kind)];
    // Not from an angle: sines and cosines would take longer than what is tested.
    const Rotd turned = normalized(Rotd{random_.between(-1, 1), random_.between(-1, 1)});
    const Vec2d position{random_.between(-spread, spread), random_.between(-spread, spread)};
    const Rotd rotation = random_.below(8) == 0 ? Rotd{} : turned;
    return {pool[random_.below(static_cast<std::uint32_t>(pool.size()))], {Vec2(position), Rot(rotation)}};
  }
  Random& random() { return random_; }

 private:
  Random random_;
  std::array<std::vector<Hull>, 3> pools_;
};

/// The corners of a core in double precision, seen from `origin` (what both are near: nothing is lost).
struct Corners {
  std::array<Vec2d, max_polygon_vertices> at;
  int count = 0;

  Corners(const PlacedHull& placed, Vec2 origin) : count(placed.hull.count) {
    const Posed pose{Vec2d(placed.pose.position) - Vec2d(origin), Rotd(placed.pose.rotation)};
    for (int i = 0; i < count; ++i) {
      at[static_cast<std::size_t>(i)] = to_world(pose, Vec2d(placed.hull.points[i]));
    }
  }
  Vec2d operator[](int i) const { return at[static_cast<std::size_t>(i < count ? i : i - count)]; }
};

inline double squared_distance_to_segment(Vec2d p, Vec2d a, Vec2d b) {
  const double l2 = length_squared(b - a);
  const double t = l2 > 0 ? std::clamp(dot(p - a, b - a) / l2, 0.0, 1.0) : 0.0;
  return length_squared(p - lerp(a, b, t));
}

inline double squared_distance_to_edges(Vec2d p, const Corners& c) {
  double nearest = 1e300;
  for (int i = 0; i < c.count; ++i) nearest = std::min(nearest, squared_distance_to_segment(p, c[i], c[i + 1]));
  return nearest;
}

inline bool inside(Vec2d p, const Corners& c) {
  if (c.count < 3) return false;
  for (int i = 0; i < c.count; ++i) {
    if (cross(c[i + 1] - c[i], p - c[i]) < 0) return false;
  }
  return true;
}

inline bool edges_cross(const Corners& a, const Corners& b) {
  for (int i = 0; i < a.count && a.count > 1; ++i) {
    for (int j = 0; j < b.count && b.count > 1; ++j) {
      const Vec2d u = a[i + 1] - a[i];
      const Vec2d v = b[j + 1] - b[j];
      if (cross(u, b[j] - a[i]) * cross(u, b[j + 1] - a[i]) < 0 &&
          cross(v, a[i] - b[j]) * cross(v, a[i + 1] - b[j]) < 0) {
        return true;
      }
    }
  }
  return false;
}

/// The distance of two cores; 0 when they overlap.
inline double distance_by_force(const Corners& a, const Corners& b) {
  if (inside(a[0], b) || inside(b[0], a) || edges_cross(a, b)) return 0;
  double nearest = 1e300;
  for (int i = 0; i < a.count; ++i) nearest = std::min(nearest, squared_distance_to_edges(a[i], b));
  for (int i = 0; i < b.count; ++i) nearest = std::min(nearest, squared_distance_to_edges(b[i], a));
  return std::sqrt(nearest);
}

/// How far the cores are apart along a unit direction: never more than their distance.
inline double separation_along(Vec2d direction, const Corners& a, const Corners& b) {
  double front_of_a = -1e300;
  double back_of_b = 1e300;
  for (int i = 0; i < a.count; ++i) front_of_a = std::max(front_of_a, dot(direction, a[i]));
  for (int i = 0; i < b.count; ++i) back_of_b = std::min(back_of_b, dot(direction, b[i]));
  return back_of_b - front_of_a;
}

/// Minus the depth of two overlapping cores of which at least one has an area: the largest separation along the normal
/// of any edge.
inline double separation_by_force(const Corners& a, const Corners& b) {
  double largest = -1e300;
  for (int i = 0; i < a.count && a.count > 1; ++i) {
    largest = std::max(largest, separation_along(-perp(normalized(a[i + 1] - a[i])), a, b));
  }
  for (int i = 0; i < b.count && b.count > 1; ++i) {
    largest = std::max(largest, separation_along(perp(normalized(b[i + 1] - b[i])), a, b));
  }
  return largest;
}

/// The largest of all errors seen, and of which pair it was.
struct Worst {
  double error = 0;
  int pair = -1;

  void see(double e, int i) {
    if (e <= error) return;  // not a number passes, and is then the worst of all
    error = e;
    pair = i;
  }
};

}  // namespace proofreel::test
