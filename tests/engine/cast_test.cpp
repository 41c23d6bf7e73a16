#include "engine/cast.h"

#include <catch2/catch.hpp>

#include "tests/engine/hulls.h"

using namespace proofreel;
using namespace proofreel::test;

namespace {

const double tolerance = pick(1e-12, 1e-5);

PlacedHull moved(PlacedHull a, Vec2 by) {
  a.pose.position += by;
  return a;
}

double separation_of(const PlacedHull& a, const PlacedHull& b) {
  return static_cast<double>(distance(a.hull, a.pose, b.hull, b.pose).separation);
}

std::optional<CastHit> cast(const PlacedHull& a, Vec2d way, const PlacedHull& b) {
  return shape_cast(a.hull, a.pose, Vec2(way), b.hull, b.pose);
}

std::optional<CastHit> ray(const PlacedHull& hull, Vec2d from, Vec2d to) {
  return ray_cast(hull.hull, hull.pose, Vec2(from), Vec2(to));
}

/// Where the line first is within `radius` of the core, by trying every edge moved out and every corner's circle;
/// 2 when nowhere.
double ray_by_force(const Corners& c, double radius, Vec2d from, Vec2d way) {
  double first = 2;
  const auto see = [&](double t) { first = t >= 0 && t < first ? t : first; };
  for (int i = 0; i < c.count; ++i) {
    const Vec2d m = from - c[i];
    const double b = dot(m, way);
    const double root = b * b - dot(way, way) * (dot(m, m) - radius * radius);
    if (root >= 0) see((-b - std::sqrt(root)) / dot(way, way));
    if (c.count == 1) break;
    const Vec2d edge = c[i + 1] - c[i];
    for (const double side : {1.0, -1.0}) {
      const Vec2d n = -side * perp(normalized(edge));
      const double t = dot(n, c[i] + radius * n - from) / dot(n, way);
      const double along = dot(from + t * way - c[i], edge) / dot(edge, edge);
      if (dot(n, way) < 0 && along >= 0 && along <= 1) see(t);
    }
  }
  return first <= 1 ? first : 2;
}

}  // namespace

TEST_CASE("A ray meets a hull where it first meets one of its edges or rounded corners", "[cast]") {
  HullPool pool(51);
  Worst fraction;
  Worst surface;
  int disagree = 0;
  int hits = 0;
  for (int i = 0; i < pairs_per_kind; ++i) {
    const PlacedHull target = pool.draw(i % 3 == 0 ? Kind::disc : i % 3 == 1 ? Kind::capsule : Kind::polygon, 1);
    Random& random = pool.random();
    const Vec2 from(Vec2d{random.between(-4, 4), random.between(-4, 4)});
    const Vec2 to(Vec2d{random.between(-4, 4), random.between(-4, 4)});
    const Corners corners(target, target.pose.position);
    const Vec2d start = Vec2d(from) - Vec2d(target.pose.position);
    const Vec2d way = Vec2d(to - from);
    const auto radius = static_cast<double>(target.hull.radius);
    const std::optional<CastHit> hit = ray_cast(target.hull, target.pose, from, to);
    if (hit && hit->at_start) {
      disagree += inside(start, corners) || squared_distance_to_edges(start, corners) < radius * radius ? 0 : 1;
      continue;
    }
    const double truth = ray_by_force(corners, radius, start, way);
    const double graze = pick(1e-9, 1e-3);
    if (hit.has_value() != (truth <= 1)) {
      // A ray that only grazes, or ends on the surface.
      const double other = ray_by_force(corners, radius + (hit ? graze : -graze), start, (1 + graze) * way);
      disagree += (other <= 1) == hit.has_value() || radius < graze || truth > 1 - graze ? 0 : 1;
      continue;
    }
    if (!hit) continue;
    ++hits;
    const Vec2d point = Vec2d(hit->point - target.pose.position);
    const double to_surface = std::abs(std::sqrt(squared_distance_to_edges(point, corners)) - radius);
    surface.see(std::max(to_surface, length(point - start - static_cast<double>(hit->fraction) * way)), i);
    // How exactly the fraction is known depends on how flat the ray comes in.
    const double approach = -dot(Vec2d(hit->normal), way);
    fraction.see(std::abs(static_cast<double>(hit->fraction) - truth) * approach, i);
  }
  INFO("pair " << fraction.pair << " and " << surface.pair);
  CHECK(disagree <= pick(0, 5));  // of a million rays, a few touch in single precision what they pass in double
  CHECK(fraction.error < 20 * tolerance);
  CHECK(surface.error < pick(1e-7, 3e-3));  // grazing a rounding the point moves by the root of the rounding error
  CHECK(hits > pairs_per_kind / 20);
}

TEST_CASE("A cast shape touches at the fraction found and nowhere before", "[cast]") {
  HullPool pool(52);
  Worst touching;
  Worst before;
  Worst missed;
  int hits = 0;
  for (int i = 0; i < pairs_per_kind / 10; ++i) {
    const KindPair kinds = kind_pairs[static_cast<std::size_t>(i) % kind_pairs.size()];
    const PlacedHull a = pool.draw(kinds.a, 4);
    const PlacedHull b = pool.draw(kinds.b, 1);
    if (separation_of(a, b) < 0.001) continue;
    const Vec2 way(Vec2d{pool.random().between(-8, 8), pool.random().between(-8, 8)});
    const std::optional<CastHit> hit = shape_cast(a.hull, a.pose, way, b.hull, b.pose);
    const real end = hit ? hit->fraction : 1;
    for (int k = 0; k < 16; ++k) {
      const real t = end * static_cast<real>(k) / 16;
      (hit ? before : missed).see(-separation_of(moved(a, t * way), b), i);
    }
    if (!hit) continue;
    ++hits;
    const PlacedHull there = moved(a, end * way);
    touching.see(std::abs(separation_of(there, b)), i);
    // The normal parts them there, and the point is on the surface hit.
    const double radii = static_cast<double>(a.hull.radius) + static_cast<double>(b.hull.radius);
    const Corners corners_b(b, b.pose.position);
    const double along = separation_along(Vec2d(hit->normal), corners_b, Corners(there, b.pose.position));
    touching.see(std::abs(along - radii), i);
    const Vec2d point = Vec2d(hit->point - b.pose.position);
    touching.see(std::abs(std::sqrt(squared_distance_to_edges(point, corners_b)) - static_cast<double>(b.hull.radius)),
                 i);
  }
  INFO("pair " << touching.pair << " and " << before.pair << " and " << missed.pair);
  CHECK(touching.error < 10 * tolerance);
  CHECK(before.error < tolerance);
  CHECK(missed.error < tolerance);
  CHECK(hits > pairs_per_kind / 200);
}

TEST_CASE("A sliver 0.2 mm thick is hit by a shape that is cast over metres", "[cast]") {
  const PlacedHull sliver = place(box_shape(0.0002, 2), {0, 0});
  for (const double start : {-1.0, -10.0, -1000.0}) {
    const auto hit = cast(place(box_shape(1, 1), {start, 0.3}, 0), {2000, 0}, sliver);
    REQUIRE(hit);
    CHECK(hit->fraction * 2000 == Approx(-start - 0.5 - 0.0001).margin(pick(1e-9, 1e-4)));
    CHECK(hit->normal.x == Approx(-1));
  }
  const auto disc = cast(place(disc_shape(0.25), {-3, 0.3}), {6, 0}, sliver);
  REQUIRE(disc);
  CHECK(disc->fraction * 6 == Approx(2.7499).margin(1e-5));
  // And the other way round: the sliver is what moves.
  const auto cut = cast(sliver, {3, 0}, place(box_shape(1, 1), {2, 0}));
  REQUIRE(cut);
  CHECK(cut->fraction * 3 == Approx(1.4999).margin(1e-5));
}

TEST_CASE("A ray from inside hits at its start, whose normal is the shortest way out", "[cast]") {
  const PlacedHull box = place(box_shape(4, 2), {1, 1});
  const auto hit = ray(box, {2.5, 1}, {-10, 1});
  REQUIRE(hit);
  CHECK(hit->at_start);
  CHECK(hit->fraction == 0);
  CHECK(hit->normal.x == Approx(1));
  const auto disc = ray(place(disc_shape(1), {0, 0}), {0.25, 0}, {9, 9});
  REQUIRE(disc);
  CHECK(disc->at_start);
  CHECK(disc->normal.x == Approx(1));
}

TEST_CASE("What touches at the start is hit when it is approached, and not when it is left or passed along", "[cast]") {
  const PlacedHull floor = place(box_shape(10, 1), {0, -0.5});
  const PlacedHull box = place(box_shape(1, 1), {0, 0.5});
  const auto down = cast(box, {0.5, -1}, floor);
  REQUIRE(down);
  CHECK(down->at_start);
  CHECK(down->normal.y == Approx(1));
  CHECK_FALSE(cast(box, {0, 1}, floor));
  CHECK_FALSE(cast(box, {3, 0}, floor));
  CHECK_FALSE(ray(floor, {-1, 0}, {20, 0}));
  CHECK(ray(floor, {-1, 0}, {20, -0.5}));
  const auto corner = ray(floor, {-20, 0}, {20, 0});
  REQUIRE(corner);
  CHECK(corner->point.x == Approx(-5));
}

TEST_CASE("An overlap at the start is a hit whatever the direction", "[cast]") {
  const PlacedHull floor = place(box_shape(10, 1), {0, -0.5});
  const PlacedHull box = place(box_shape(1, 1), {0, 0.4});
  for (const Vec2d way : {Vec2d{0, 1}, Vec2d{0, -1}, Vec2d{1, 0}, Vec2d{0, 0}}) {
    const auto hit = cast(box, way, floor);
    REQUIRE(hit);
    CHECK(hit->at_start);
    CHECK(hit->normal.y == Approx(1));
  }
}

TEST_CASE("A cast that stops short or flies past does not hit", "[cast]") {
  const PlacedHull box = place(box_shape(1, 1), {5, 0});
  CHECK_FALSE(ray(box, {0, 0}, {4.49, 0}));
  CHECK(ray(box, {0, 0}, {4.51, 0}));
  CHECK_FALSE(ray(box, {0, 0}, {10, 2}));
  CHECK_FALSE(ray(box, {0, 0}, {-10, 0}));
  CHECK_FALSE(ray(box, {0, 0}, {0, 0}));
  CHECK_FALSE(cast(place(disc_shape(0.5), {0, 1.01}), {10, 0}, box));
  CHECK(cast(place(disc_shape(0.5), {0, 0.99}), {10, 0}, box));
}

TEST_CASE("A ray meets a bare segment from either side and through its end", "[cast]") {
  const PlacedHull segment = place(polygon_shape({{0, -1}, {0, 1}}), {0, 0});
  for (const double side : {-1.0, 1.0}) {
    const auto hit = ray(segment, {side, 0.5}, {-side, 0.5});
    REQUIRE(hit);
    CHECK(hit->fraction == Approx(0.5));
    CHECK(hit->normal.x == Approx(side));
  }
  const auto end = ray(segment, {0, 3}, {0, 0});
  REQUIRE(end);
  CHECK(end->fraction == Approx(2.0 / 3));
}

TEST_CASE("Overlap counts touching and follows the roundings", "[cast]") {
  const PlacedHull disc = place(disc_shape(1), {0, 0});
  const auto overlaps_at = [&](double x) {
    const PlacedHull other = place(disc_shape(0.5), {x, 0});
    return overlap(disc.hull, disc.pose, other.hull, other.pose);
  };
  CHECK(overlaps_at(0));
  CHECK(overlaps_at(1.49));
  CHECK(overlaps_at(1.5));
  CHECK_FALSE(overlaps_at(1.51));
}

TEST_CASE("Who watches a cast sees it approach in jumps", "[cast]") {
  double last = -1;
  int jumps = 0;
  const Observer observer([&](const Event& event) {
    if (const auto* step = std::get_if<Advanced>(&event)) {
      CHECK(step->time > last);
      last = step->time;
      ++jumps;
    }
  });
  const PlacedHull target = place(disc_shape(1), {5, 0.5});
  const auto hit = ray_cast(target.hull, target.pose, Vec2{0, 0}, Vec2{10, 0}, observer);
  REQUIRE(hit);
  CHECK(jumps > 2);
  CHECK(hit->fraction == ray(target, {0, 0}, {10, 0})->fraction);
}
