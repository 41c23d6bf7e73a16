#pragma once

/// Hulls laid out for separating axes (collide.h): coordinate by coordinate, so that several corners or faces are
/// looked at with one instruction.

#include <bit>

#include "engine/clip.h"
#include "engine/lanes.h"

namespace proofreel {
inline namespace PROOFREEL_PRECISION {

/// One number per corner of a hull, in whole lanes.
struct Row {
  alignas(Lanes) real of[max_polygon_vertices];

  Lanes at(int i) const { return lanes_at(of + i); }
  void set(int i, Lanes values) { put_lanes(of + i, values); }
};

/// A hull in A's frame, coordinate by coordinate. Places behind the last corner repeat corner 0, as in Hull, which
/// changes no minimum and no maximum. So loops may run over `size` places, a round number known to the compiler, and
/// need no branch that depends on how many corners there are. Not initialised, because most of it is never used.
struct Corners {
  Row x, y;
  Row normal_x, normal_y;
  int count;
  real radius;

  Vec2 point(int i) const { return {x.of[i], y.of[i]}; }
  Vec2 normal(int i) const { return {normal_x.of[i], normal_y.of[i]}; }
  int next(int i) const { return i + 1 < count ? i + 1 : 0; }
  int before(int i) const { return i > 0 ? i - 1 : count - 1; }
  Face face(int i) const { return {point(i), point(next(i)), normal(i)}; }
};

/// Lanes of points, coordinate by coordinate.
struct Points {
  Lanes x, y;
};

inline Points points_at(const Vec2* from) {
  Points p;
  for (int lane = 0; lane < lanes; ++lane) {
    p.x[lane] = from[lane].x;
    p.y[lane] = from[lane].y;
  }
  return p;
}

inline Points rotated(Rot q, Points p) { return {q.c * p.x - q.s * p.y, q.s * p.x + q.c * p.y}; }

template <int size>
[[gnu::always_inline]] inline void load(const Hull& hull, Corners& out) {
  out.count = hull.count;
  out.radius = hull.radius;
  for (int i = 0; i < size; i += lanes) {
    const Points p = points_at(hull.points + i);
    const Points n = points_at(hull.normals + i);
    out.x.set(i, p.x);
    out.y.set(i, p.y);
    out.normal_x.set(i, n.x);
    out.normal_y.set(i, n.y);
  }
}

/// Without its normals, which a hull that is apart does not need.
template <int size>
[[gnu::always_inline]] inline void load(const Hull& hull, const Pose& pose, Corners& out) {
  out.count = hull.count;
  out.radius = hull.radius;
  for (int i = 0; i < size; i += lanes) {
    const Points p = rotated(pose.rotation, points_at(hull.points + i));
    out.x.set(i, pose.position.x + p.x);
    out.y.set(i, pose.position.y + p.y);
  }
}

template <int size>
void load_normals(const Hull& hull, Rot rotation, Corners& out) {
  for (int i = 0; i < size; i += lanes) {
    const Points n = rotated(rotation, points_at(hull.normals + i));
    out.normal_x.set(i, n.x);
    out.normal_y.set(i, n.y);
  }
}

/// The first place of the largest number, which is put into `all`. Guesses about which one that is would be wrong half
/// of the time, and cost more than looking at all of them.
template <int size>
[[gnu::always_inline]] inline int place_of_largest(const Row& row, real& all) {
  Lanes largest = row.at(0);
  for (int i = lanes; i < size; i += lanes) largest = row.at(i) > largest ? row.at(i) : largest;
  all = largest[0];
  for (int lane = 1; lane < lanes; ++lane) all = largest[lane] > all ? largest[lane] : all;
  Marks mark{};
  for (int lane = 0; lane < lanes; ++lane) mark[lane] = Mark{1} << lane;
  Marks found = (row.at(0) >= all) & mark;
  for (int i = lanes; i < size; i += lanes) found |= (row.at(i) >= all) & (mark << i);
  unsigned any = 1U << (size - 1);
  for (int lane = 0; lane < lanes; ++lane) any |= static_cast<unsigned>(found[lane]);
  return std::countr_zero(any);
}

}  // namespace PROOFREEL_PRECISION
}  // namespace proofreel
