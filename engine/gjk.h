#pragma once

/// How far two convex shapes are apart, by Gilbert, Johnson and Keerthi (1988; thesis chapter 4.4).
///
/// The Minkowski difference B - A holds the difference b - a of every point of B with every point of A. It is convex,
/// the shapes overlap when it holds the origin, and otherwise its distance to the origin is theirs. It is never
/// built: the support function finds its corner in a given direction from one scan of each shape. A simplex (one, two
/// or three of its corners) is kept nearest the origin: look from it towards the origin, take the corner farthest that
/// way, keep of the enlarged simplex what is nearest the origin, until there is no corner nearer.
///
/// Only the cores go through this: the radii of rounded shapes are subtracted at the end, so that the distance of
/// rounded shapes is exact, and so is the normal of roundings that overlap.

#include <algorithm>
#include <cstdint>
#include <limits>

#include "engine/observer.h"
#include "engine/shape.h"

namespace proofreel {
inline namespace PROOFREEL_PRECISION {

/// The simplex of the last run, as indices of points: a good start for the next run of the same two shapes. `count` 0
/// means that nothing is known yet. A simplex of three has the origin inside: the cores overlap.
struct SimplexCache {
  std::uint8_t count = 0;
  std::uint8_t a[3]{};
  std::uint8_t b[3]{};
};

/// Two hulls as the algorithms see them: everything is in the frame of A, so that nothing is lost far from the origin.
/// B's points are brought there at once, which takes less time than turning every direction and every point found.
struct HullPair {
  HullPair(const Hull& hull_a, const Hull& hull_b, const Pose& pose) : a(hull_a), b(hull_b), b_in_a(pose) {
    constexpr int block = max_polygon_vertices / 2;  // a fixed number of steps; most hulls fit into the first half
    for (int i = 0; i < block; ++i) b_points[i] = to_world(pose, b.points[i]);
    for (int i = block; i < b.count; ++i) b_points[i] = to_world(pose, b.points[i]);
  }

  const Hull& a;
  const Hull& b;
  Pose b_in_a;
  Vec2 b_points[max_polygon_vertices];
};

/// Which of the points is farthest along `direction`, which need not be a unit vector; of equals the first. A scan: for
/// up to 16 points it beats hill climbing, as what it decides need not be predicted.
inline int support_index(const Vec2* points, int count, Vec2 direction) {
  int best = 0;
  real farthest = dot(points[0], direction);
  for (int i = 1; i < count; ++i) {
    const real here = dot(points[i], direction);
    best = here > farthest ? i : best;
    farthest = here > farthest ? here : farthest;
  }
  return best;
}

/// How far the hull's core reaches along `direction`, in units of its length.
inline real support_extent(const Hull& hull, Vec2 direction) {
  real farthest = dot(hull.points[0], direction);
  for (int i = 1; i < hull.count; ++i) farthest = std::max(farthest, dot(hull.points[i], direction));
  return farthest;
}

/// A corner of B - A, and the points it is the difference of.
struct SimplexCorner {
  Vec2 difference;
  int a = 0;
  int b = 0;
};

inline bool same(const SimplexCorner& one, const SimplexCorner& other) { return one.a == other.a && one.b == other.b; }

/// The corner of B - A that belongs to these two points.
inline SimplexCorner simplex_corner(const HullPair& pair, int a, int b) {
  return {pair.b_points[b] - pair.a.points[a], a, b};
}

/// The corner of B - A farthest along `direction`.
inline SimplexCorner support(const HullPair& pair, Vec2 direction) {
  return simplex_corner(pair, support_index(pair.a.points, pair.a.count, -direction),
                        support_index(pair.b_points, pair.b.count, direction));
}

/// What differences of points of these hulls may be off by, in metres: the algorithms do not look closer.
inline real rounding_of(Vec2 on_a, Vec2 on_b) {
  const real scale = std::abs(on_a.x) + std::abs(on_a.y) + std::abs(on_b.x) + std::abs(on_b.y);
  return 4 * std::numeric_limits<real>::epsilon() * scale;
}

/// Where the cores are nearest, in A's frame.
struct CoreDistance {
  Vec2 on_a;  ///< on the cores; of no meaning when they overlap
  Vec2 on_b;
  Vec2 normal;          ///< unit, from A to B; zero when the cores overlap
  real distance = 0;    ///< 0 when the cores overlap
  bool overlap = true;  ///< the cores have a common point, or are nearer than rounding lets one tell
  int iterations = 0;   ///< how often the support function was asked
};

/// GJK itself, on the cores. Starts from `cache` and leaves the last simplex there. Ends always: after 64 iterations at
/// the latest (a dozen is the most that was ever seen), and then with points of the shapes that are at least near.
template <typename Observer = NoObserver>
CoreDistance core_distance(const HullPair& pair, SimplexCache& cache, Observer observer = {});

/// Where two rounded shapes are nearest. Points are relative to A's centre of mass, in world axes.
struct DistanceResult {
  Vec2 on_a;  ///< on the surfaces, on one line with the normal; of no meaning when the cores overlap
  Vec2 on_b;
  Vec2 normal;          ///< unit, from A to B; zero when the cores overlap, whose way out EPA finds (epa.h)
  real separation = 0;  ///< negative when the roundings overlap; when the cores do, minus both radii: at least so deep
  bool cores_overlap = false;  ///< touching cores count
  int iterations = 0;
};

template <typename Observer = NoObserver>
DistanceResult distance(const Hull& a, const Pose& pose_a, const Hull& b, const Pose& pose_b, SimplexCache& cache,
                        Observer observer = {});

/// The same from a cold start.
DistanceResult distance(const Hull& a, const Pose& pose_a, const Hull& b, const Pose& pose_b);

}  // namespace PROOFREEL_PRECISION
}  // namespace proofreel
