#include "engine/seam.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "engine/elementary.h"

namespace proofreel {
inline namespace PROOFREEL_PRECISION {
namespace {

/// Corners nearer than this part of the smallest detail of two shapes are one corner.
constexpr real joining_distance = real(1e-4);
/// Directions within this angle are one direction (rad).
constexpr double one_direction = 1e-3;
/// Normals within this of the admitted ones are admitted: what rounding and a resting contact's overlap turn them by.
constexpr real normal_tolerance = real(1e-3);

constexpr double full_turn = 2 * std::numbers::pi;

int before(const Hull& hull, int i) { return i > 0 ? i - 1 : hull.count - 1; }
int after(const Hull& hull, int i) { return i + 1 < hull.count ? i + 1 : 0; }

/// The angle counter-clockwise from `a` to `b`, 0 <= angle < a full turn.
double turn(Vec2 a, Vec2 b) {
  const Vec2d u(a);
  const Vec2d v(b);
  const double angle = elementary::atan2(cross(u, v), dot(u, v));
  return angle < 0 ? angle + full_turn : angle;
}

/// The directions around a corner that a shape fills: from `first` counter-clockwise to `last`. Equal for the end of a
/// segment.
struct Sector {
  Vec2 first;
  Vec2 last;
  double width() const { return first == last ? 0 : turn(first, last); }
};

/// The sectors of other shapes around one point.
struct Surroundings {
  std::vector<Sector> sectors;
  bool buried = false;  ///< inside another shape
};

/// The least of a shape's thickness and the lengths of its edges.
real smallest_detail(const Hull& hull) {
  real least = hull.detail;
  for (int i = 0; i < hull.count; ++i) least = std::min(least, distance(hull.points[i], hull.points[after(hull, i)]));
  return least;
}

/// How near is joined: far below the size of anything that could fit between, but not below what rounding leaves.
real joining_reach(const Hull& a, const Hull& b) {
  real farthest = 0;
  for (const Hull* hull : {&a, &b}) {
    for (int i = 0; i < hull->count; ++i) farthest = std::max(farthest, length(hull->points[i]));
  }
  const real rounding = 16 * std::numeric_limits<real>::epsilon() * farthest;
  return std::max(joining_distance * std::min(smallest_detail(a), smallest_detail(b)), rounding);
}

Sector sector_at(const Hull& hull, int corner) {
  const Vec2 here = hull.points[corner];
  return {normalized(hull.points[after(hull, corner)] - here), normalized(hull.points[before(hull, corner)] - here)};
}

bool near_edge(Vec2 p, Vec2 a, Vec2 b, real near) {
  const Vec2 along = normalized(b - a);
  const real at = dot(p - a, along);
  return at > 0 && at < length(b - a) && std::abs(cross(along, p - a)) <= near;
}

bool inside(const Hull& hull, Vec2 p) {
  if (hull.count < 3) return false;
  for (int i = 0; i < hull.count; ++i) {
    if (dot(hull.normals[i], p - hull.points[i]) > 0) return false;
  }
  return true;
}

void add_surroundings(const Hull& other, Vec2 p, real near, Surroundings& around) {
  for (int i = 0; i < other.count; ++i) {
    if (distance(p, other.points[i]) > near) continue;
    around.sectors.push_back(sector_at(other, i));
    return;
  }
  for (int i = 0; i < other.count; ++i) {
    const Vec2 a = other.points[i];
    const Vec2 b = other.points[after(other, i)];
    if (!near_edge(p, a, b, near)) continue;
    const Vec2 along = normalized(b - a);
    if (other.count > 2) {
      around.sectors.push_back({along, -along});
    } else {
      around.sectors.push_back({along, along});
      around.sectors.push_back({-along, -along});
    }
    return;
  }
  around.buried |= inside(other, p);
}

/// The free sector counter-clockwise of `edge`: how wide, and the direction that ends it; negative when another shape
/// lies right beside the edge. `own_end` bounds it when nobody else does.
struct FreeSector {
  double width = 0;
  Vec2 end;
};

FreeSector free_sector(Vec2 edge, Vec2 own_end, const std::vector<Sector>& others) {
  const double own = turn(edge, own_end);
  FreeSector free{own > 0 ? own : full_turn, own_end};
  for (const Sector& sector : others) {
    const double first = turn(edge, sector.first);
    const double beside = first > one_direction ? one_direction - first + full_turn : one_direction - first;
    const double width = sector.width();
    if (width > 0 && beside < width) return {-1, {}};
    if (first > one_direction && first < free.width) free = {first, sector.first};
  }
  return free;
}

Vec2 mirrored(Vec2 v) { return {v.x, -v.y}; }

/// The same clockwise: the plane is mirrored, and sectors run the other way.
FreeSector free_sector_clockwise(Vec2 edge, Vec2 own_end, std::vector<Sector> others) {
  for (Sector& sector : others) sector = {mirrored(sector.last), mirrored(sector.first)};
  FreeSector free = free_sector(mirrored(edge), mirrored(own_end), others);
  free.end = mirrored(free.end);
  return free;
}

CornerSeam corner_seam(const Hull& hull, int i, const Surroundings& around) {
  CornerSeam seam;
  seam.joined = around.buried || !around.sectors.empty();
  if (!seam.joined) return seam;
  const Vec2 normal_before = hull.normals[before(hull, i)];
  const Vec2 normal_after = hull.normals[i];
  const Sector own = sector_at(hull, i);
  const FreeSector ahead = free_sector(own.last, own.first, around.sectors);
  const FreeSector behind = free_sector_clockwise(own.first, own.last, around.sectors);
  const auto convex = [](const FreeSector& free) { return free.width > std::numbers::pi + one_direction; };
  seam.before_exposed = !around.buried && ahead.width > 0;
  seam.after_exposed = !around.buried && behind.width > 0;
  seam.before_convex = seam.before_exposed && convex(ahead);
  seam.after_convex = seam.after_exposed && convex(behind);
  const auto concave = [](const FreeSector& free) { return free.width < std::numbers::pi - one_direction; };
  seam.before_concave = seam.before_exposed && concave(ahead);
  seam.after_concave = seam.after_exposed && concave(behind);
  seam.before_free = ahead.end;
  seam.after_free = behind.end;
  seam.before_until = convex(ahead) ? -perp(ahead.end) : normal_before;
  seam.after_from = convex(behind) ? perp(behind.end) : normal_after;
  return seam;
}

/// The part of the segment a-b that lies in `hull` grown by `near`, as lengths from a; false when there is none.
bool part_within(const Hull& hull, Vec2 a, Vec2 b, real near, real& from, real& to) {
  const Vec2 along = normalized(b - a);
  from = 0;
  to = length(b - a);
  for (int i = 0; i < hull.count; ++i) {
    const real outside = dot(hull.normals[i], a - hull.points[i]) - near;
    const real slope = dot(hull.normals[i], along);
    if (std::abs(slope) < real(1e-6)) {
      if (outside > 0) return false;
    } else if (slope > 0) {
      to = std::min(to, -outside / slope);
    } else {
      from = std::max(from, -outside / slope);
    }
  }
  return from < to;
}

/// Where `other` lies against the outside of edge `i`.
void hide_edge(const Hull& hull, int i, const Hull& other, real near, Seam& seam) {
  if (other.count < 3) return;
  const Vec2 outward = real(2) * near * hull.normals[i];
  const Vec2 a = hull.points[i];
  const Vec2 b = hull.points[after(hull, i)];
  real from = 0;
  real to = 0;
  if (!part_within(other, a + outward, b + outward, near, from, to)) return;
  const real whole = length(b - a);
  const real slack = real(4) * near;
  if (from <= slack) seam.hidden_from_start[i] = std::max(seam.hidden_from_start[i], to + slack);
  if (to >= whole - slack) seam.hidden_to_end[i] = std::max(seam.hidden_to_end[i], whole - from + slack);
}

bool may_join(const Hull& a, const Hull& b) {
  if (a.count < 2 || b.count < 2 || a.radius != b.radius) return false;
  return a.radius <= 0 || (a.count == 2 && b.count == 2);
}

/// Whether `n` lies counter-clockwise between `first` and `last`, which are at most half a turn apart.
bool between(Vec2 first, Vec2 n, Vec2 last) {
  const bool within = cross(first, n) >= -normal_tolerance && cross(n, last) >= -normal_tolerance;
  return within && dot(first, n) > real(0.5) * dot(first, last) - real(0.51);
}

}  // namespace

bool Seam::admits(const Hull& hull, int i, Vec2 normal) const {
  const CornerSeam& corner = corners[i];
  if (!corner.joined) return true;
  if (corner.before_exposed && !corner.before_concave &&
      between(hull.normals[before(hull, i)], normal, corner.before_until))
    return true;
  return corner.after_exposed && !corner.after_concave && between(corner.after_from, normal, hull.normals[i]);
}

bool Seam::is_ridge(int i) const {
  const CornerSeam& corner = corners[i];
  return !corner.joined || corner.before_convex || corner.after_convex;
}

bool Seam::reaches_around(const Hull& hull, int i, real along, real reach, Vec2 middle) const {
  const int end = after(hull, i);
  const Vec2 way = hull.points[end] - hull.points[i];
  if (corners[i].after_concave && along < reach) {  // the free sector lies clockwise of the edge
    const Vec2 from_corner = middle - hull.points[i];
    return cross(from_corner, way) <= 0 || cross(corners[i].after_free, from_corner) <= 0;
  }
  if (corners[end].before_concave && along > length(way) - reach) {
    const Vec2 from_corner = middle - hull.points[end];
    return cross(-way, from_corner) <= 0 || cross(from_corner, corners[end].before_free) <= 0;
  }
  return false;
}

bool Seam::hides(const Hull& hull, int i, real along) const {
  const real whole = distance(hull.points[i], hull.points[after(hull, i)]);
  return (hidden_from_start[i] > 0 && along < hidden_from_start[i]) ||
         (hidden_to_end[i] > 0 && along > whole - hidden_to_end[i]);
}

bool Seam::hides_all(const Hull& hull, int i) const {
  return hidden_from_start[i] + hidden_to_end[i] >= distance(hull.points[i], hull.points[after(hull, i)]);
}

bool find_seam(const Hull& own, std::span<const Hull> others, Seam& seam) {
  std::vector<Surroundings> around(static_cast<std::size_t>(own.count));
  for (const Hull& other : others) {
    if (!may_join(own, other)) continue;
    const real near = joining_reach(own, other);
    for (int i = 0; i < own.count; ++i) {
      add_surroundings(other, own.points[i], near, around[static_cast<std::size_t>(i)]);
      if (own.radius <= 0) hide_edge(own, i, other, near, seam);
    }
  }
  bool any = false;
  for (int i = 0; i < own.count; ++i) {
    seam.corners[i] = corner_seam(own, i, around[static_cast<std::size_t>(i)]);
    any |= seam.corners[i].joined || seam.hidden_from_start[i] > 0 || seam.hidden_to_end[i] > 0;
  }
  return any;
}

Seam transformed(const Seam& seam, const Hull& hull, Rot rotation) {
  Seam out = seam;
  for (int i = 0; i < hull.count; ++i) {
    out.corners[i].before_until = rotate(rotation, seam.corners[i].before_until);
    out.corners[i].after_from = rotate(rotation, seam.corners[i].after_from);
    out.corners[i].before_free = rotate(rotation, seam.corners[i].before_free);
    out.corners[i].after_free = rotate(rotation, seam.corners[i].after_free);
  }
  return out;
}

}  // namespace PROOFREEL_PRECISION
}  // namespace proofreel
