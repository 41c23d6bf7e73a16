#include "engine/epa.h"

#include <catch2/catch.hpp>

#include "tests/engine/hulls.h"

using namespace proofreel;
using namespace proofreel::test;

namespace {

const double tolerance = pick(1e-12, 1e-5);

HullPair pair_of(const PlacedHull& a, const PlacedHull& b) { return {a.hull, b.hull, relative_pose(a.pose, b.pose)}; }

Penetration penetration_of(const PlacedHull& a, const PlacedHull& b) {
  SimplexCache simplex;
  const CoreDistance core = core_distance(pair_of(a, b), simplex);
  REQUIRE(core.overlap);
  return core_penetration(pair_of(a, b), simplex);
}

/// In the frame of A, as the result is.
struct InFrameOfA {
  Corners a, b;

  InFrameOfA(const PlacedHull& placed_a, const PlacedHull& placed_b)
      : a({placed_a.hull, {}}, {}), b({placed_b.hull, relative_pose(placed_a.pose, placed_b.pose)}, {}) {}
};

/// What is wrong with a penetration: the depth is the least there is, the normal leads out by it, and the points are
/// on the cores.
double error_of(const InFrameOfA& truth, const Penetration& p) {
  const auto depth = static_cast<double>(p.depth);
  const Vec2d normal(p.normal);
  return std::max({std::abs(depth + separation_by_force(truth.a, truth.b)), std::abs(length(normal) - 1),
                   std::abs(depth + separation_along(normal, truth.a, truth.b)),
                   std::sqrt(squared_distance_to_edges(Vec2d(p.on_a), truth.a)),
                   std::sqrt(squared_distance_to_edges(Vec2d(p.on_b), truth.b))});
}

/// How far the points are from lying the depth apart along the normal. Where two ways out are equally short, and
/// rounding takes the wrong one, they lie beside the edge by as much as does not show in its distance, which grows with
/// the square of that.
double error_of_points(const Penetration& p) {
  return length(Vec2d(p.on_a - p.on_b) - static_cast<double>(p.depth) * Vec2d(p.normal));
}
const double tolerance_of_points = pick(1e-7, 5e-4);

}  // namespace

TEST_CASE("The penetration is the shortest way out along any edge's normal", "[epa]") {
  HullPool pool(31);
  for (const KindPair kinds : {KindPair{Kind::disc, Kind::polygon}, KindPair{Kind::capsule, Kind::polygon},
                               KindPair{Kind::polygon, Kind::capsule}, KindPair{Kind::polygon, Kind::polygon},
                               KindPair{Kind::capsule, Kind::capsule}}) {
    Worst wrong;
    Worst beside;
    int seen = 0;
    int most_iterations = 0;
    for (int i = 0; i < pairs_per_kind; ++i) {
      const PlacedHull a = pool.draw(kinds.a, 0.7);
      const PlacedHull b = pool.draw(kinds.b, 0.7);
      const HullPair pair = pair_of(a, b);
      SimplexCache simplex;
      if (!core_distance(pair, simplex).overlap) continue;
      ++seen;
      const Penetration p = core_penetration(pair, simplex);
      wrong.see(error_of({a, b}, p), i);
      beside.see(error_of_points(p), i);
      most_iterations = std::max(most_iterations, p.iterations);
    }
    INFO("pair " << wrong.pair << " and " << beside.pair);
    CHECK(wrong.error < tolerance);
    CHECK(beside.error < tolerance_of_points);
    CHECK(seen > pairs_per_kind / 20);
    CHECK(most_iterations <= 2 * max_polygon_vertices);
  }
}

TEST_CASE("Any points of the difference will do as a start, be they one, on a line or inside", "[epa]") {
  HullPool pool(32);
  Worst wrong;
  for (int i = 0; i < 100000; ++i) {
    const PlacedHull a = pool.draw(Kind::polygon, 0.5);
    const PlacedHull b = pool.draw(Kind::polygon, 0.5);
    const HullPair pair = pair_of(a, b);
    SimplexCache simplex;
    if (!core_distance(pair, simplex).overlap) continue;
    simplex.count = static_cast<std::uint8_t>(1 + pool.random().below(3));
    for (int k = 0; k < 3; ++k) {
      simplex.a[k] = static_cast<std::uint8_t>(pool.random().below(static_cast<std::uint32_t>(a.hull.count)));
      simplex.b[k] = static_cast<std::uint8_t>(pool.random().below(static_cast<std::uint32_t>(b.hull.count)));
    }
    const InFrameOfA truth(a, b);
    wrong.see(
        std::abs(static_cast<double>(core_penetration(pair, simplex).depth) + separation_by_force(truth.a, truth.b)),
        i);
  }
  INFO("pair " << wrong.pair);
  CHECK(wrong.error < tolerance);
}

TEST_CASE("Boxes whose faces only touch have no depth and the faces' normal", "[epa]") {
  const PlacedHull a = place(box_shape(2, 2), {0, 0});
  for (const double x : {-0.5, 0.0, 0.25, 1.0}) {
    const Penetration p = penetration_of(a, place(box_shape(2, 2), {x, 2}));
    CHECK(p.depth == Approx(0).margin(tolerance));
    CHECK(p.normal.y == Approx(1));
  }
}

TEST_CASE("Shapes that touch at a corner part along a direction that parts them", "[epa]") {
  const PlacedHull a = place(box_shape(2, 2), {0, 0});
  const Penetration corners = penetration_of(a, place(box_shape(2, 2), {2, 2}));
  CHECK(corners.depth == Approx(0).margin(tolerance));
  CHECK(std::min(corners.normal.x, corners.normal.y) > -tolerance);
  const Penetration point = penetration_of(a, place(polygon_shape({{0, 0}}), {1, 0.5}));
  CHECK(point.depth == Approx(0).margin(tolerance));
  CHECK(point.normal.x == Approx(1));
}

TEST_CASE("Collinear segments, and a point on a segment, part across it without depth", "[epa]") {
  const PlacedHull segment = place(polygon_shape({{-1, 0}, {1, 0}}), {0, 0});
  for (const PlacedHull& other : {place(polygon_shape({{-1, 0}, {1, 0}}), {0.5, 0}), segment,
                                  place(polygon_shape({{0, 0}}), {0.25, 0}), place(polygon_shape({{0, 0}}), {1, 0})}) {
    const Penetration p = penetration_of(segment, other);
    CHECK(p.depth == 0);
    CHECK(std::abs(p.normal.y) == Approx(1));
    CHECK(length(Vec2d(p.on_a - p.on_b)) < tolerance);
  }
}

TEST_CASE("Coincident points part upwards", "[epa]") {
  const PlacedHull disc = place(disc_shape(0.5), {3, 4});
  const Penetration p = penetration_of(disc, disc);
  CHECK(p.depth == 0);
  CHECK(p.normal == Vec2{0, 1});
}

TEST_CASE("Coincident shapes part across their thinnest side", "[epa]") {
  const PlacedHull plank = place(box_shape(4, 0.1), {0, 0});
  const Penetration p = penetration_of(plank, plank);
  CHECK(p.depth == Approx(0.1));
  CHECK(std::abs(p.normal.y) == Approx(1));
  const PlacedHull needle = place(polygon_shape({{0, -1e-5}, {10, 0}, {0, 1e-5}}), {0, 0});
  CHECK(penetration_of(needle, needle).depth == Approx(2e-5).margin(tolerance));
}

TEST_CASE("A shape within another comes out through the nearest face, whole", "[epa]") {
  const Penetration p = penetration_of(place(box_shape(4, 4), {0, 0}), place(box_shape(0.2, 0.2), {1.5, 0.3}));
  CHECK(p.normal.x == Approx(1));
  CHECK(p.depth == Approx(0.6));
}

TEST_CASE("Who watches the polytope grow sees its nearest edge move outwards to the depth", "[epa]") {
  Random random(5);
  const PlacedHull a = place(polygon_shape(random_corners(random)), {0, 0});
  const PlacedHull b = place(box_shape(1, 1), {0.2, 0.1}, 0.4);
  SimplexCache simplex;
  REQUIRE(core_distance(pair_of(a, b), simplex).overlap);
  double depth = -1;
  int grown = 0;
  const Observer observer([&](const Event& event) {
    grown += std::holds_alternative<PolytopeExpanded>(event) ? 1 : 0;
    if (const auto* edge = std::get_if<ClosestEdge>(&event)) {
      CHECK(edge->distance >= depth - tolerance);
      depth = edge->distance;
    }
  });
  const Penetration watched = core_penetration(pair_of(a, b), simplex, observer);
  CHECK(static_cast<double>(watched.depth) == Approx(depth));
  CHECK(grown == watched.iterations - 1);
}
