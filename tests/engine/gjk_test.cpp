#include "engine/gjk.h"

#include <catch2/catch.hpp>

#include "tests/engine/hulls.h"

using namespace proofreel;
using namespace proofreel::test;

namespace {

/// What may be lost: all sizes here are a few metres.
const double tolerance = pick(1e-12, 1e-5);

DistanceResult distance_of(const PlacedHull& a, const PlacedHull& b) {
  return distance(a.hull, a.pose, b.hull, b.pose);
}

/// The errors of one result that has no truth to compare with: the nearest points prove that the shapes are no farther
/// apart, the normal that they are no nearer.
double error_of_proof(const PlacedHull& a, const PlacedHull& b, const DistanceResult& r) {
  const Corners ca(a, a.pose.position);
  const Corners cb(b, a.pose.position);
  const double radii = static_cast<double>(a.hull.radius) + static_cast<double>(b.hull.radius);
  const double core = static_cast<double>(r.separation) + radii;
  const Vec2d on_a(r.on_a);
  const Vec2d on_b(r.on_b);
  const Vec2d normal(r.normal);
  const Vec2d core_a = on_a - static_cast<double>(a.hull.radius) * normal;
  const Vec2d core_b = on_b + static_cast<double>(b.hull.radius) * normal;
  return std::max({std::abs(length(normal) - 1), core - separation_along(normal, ca, cb),
                   std::sqrt(squared_distance_to_edges(core_a, ca)), std::sqrt(squared_distance_to_edges(core_b, cb)),
                   length(on_b - on_a - static_cast<double>(r.separation) * normal)});
}

ShapeDef segment_shape(Vec2d a, Vec2d b) { return polygon_shape({a, b}); }

}  // namespace

TEST_CASE("The distance is that of every corner to every edge, and its points and normal prove it", "[gjk]") {
  HullPool pool(21);
  for (const KindPair kinds : kind_pairs) {
    Worst wrong;
    Worst unproven;
    int most_iterations = 0;
    int apart = 0;
    for (int i = 0; i < pairs_per_kind; ++i) {
      const PlacedHull a = pool.draw(kinds.a, 1.5);
      const PlacedHull b = pool.draw(kinds.b, 1.5);
      const double truth = distance_by_force(Corners(a, a.pose.position), Corners(b, a.pose.position));
      const double radii = static_cast<double>(a.hull.radius) + static_cast<double>(b.hull.radius);
      const DistanceResult r = distance_of(a, b);
      wrong.see(std::abs(static_cast<double>(r.separation) + radii - truth), i);
      most_iterations = std::max(most_iterations, r.iterations);
      if (r.cores_overlap) continue;
      ++apart;
      unproven.see(error_of_proof(a, b, r), i);
    }
    INFO("pair " << wrong.pair << " and " << unproven.pair);
    CHECK(wrong.error < tolerance);
    CHECK(unproven.error < tolerance);
    CHECK(most_iterations < 20);
    CHECK(apart > pairs_per_kind / 4);
  }
}

TEST_CASE("Swapping the shapes mirrors the distance", "[gjk]") {
  HullPool pool(22);
  Worst difference;
  for (int i = 0; i < pairs_per_kind / 5; ++i) {
    const KindPair kinds = kind_pairs[static_cast<std::size_t>(i) % kind_pairs.size()];
    const PlacedHull a = pool.draw(kinds.a, 1.5);
    const PlacedHull b = pool.draw(kinds.b, 1.5);
    const DistanceResult ab = distance_of(a, b);
    const DistanceResult ba = distance_of(b, a);
    difference.see(std::abs(static_cast<double>(ab.separation - ba.separation)), i);
    // Near touching the direction itself is worth no more than its length has digits.
    if (ab.cores_overlap || ba.cores_overlap || ab.separation + a.hull.radius + b.hull.radius < real(0.01)) continue;
    difference.see(0.01 * length(Vec2d(ab.normal + ba.normal)), i);
  }
  INFO("pair " << difference.pair);
  CHECK(difference.error < tolerance);
}

TEST_CASE("A distance is the same a thousand kilometres away, to four units in the last place of the way", "[gjk]") {
  HullPool pool(23);
  const double four_ulp = 4 * 1e6 * static_cast<double>(std::numeric_limits<real>::epsilon());
  Worst difference;
  for (int i = 0; i < pairs_per_kind / 10; ++i) {
    PlacedHull a = pool.draw(Kind::polygon, 1.5);
    PlacedHull b = pool.draw(Kind::polygon, 1.5);
    const double here = static_cast<double>(distance_of(a, b).separation);
    a.pose.position += Vec2(real(1e6), real(-1e6));
    b.pose.position += Vec2(real(1e6), real(-1e6));
    difference.see(std::abs(static_cast<double>(distance_of(a, b).separation) - here), i);
  }
  INFO("pair " << difference.pair);
  CHECK(difference.error < four_ulp);
}

TEST_CASE("Shapes a thousand times smaller or larger have the same distance in their own measure", "[gjk]") {
  Random random(24);
  for (const double scale : {1e-3, 1e3}) {
    Worst difference;
    for (int i = 0; i < 5000; ++i) {
      ShapeDef a = random_shape(random, Kind::polygon);
      ShapeDef b = random_shape(random, Kind::polygon);
      const Vec2d offset{random.between(-2, 2), random.between(-2, 2)};
      const double angle = random.between(-3, 3);
      const double here = static_cast<double>(distance_of(place(a, {}), place(b, offset, angle)).separation);
      for (ShapeDef* shape : {&a, &b}) {
        for (Vec2d& corner : shape->points) corner *= scale;
        shape->radius *= scale;
      }
      const DistanceResult there = distance_of(place(a, {}), place(b, scale * offset, angle));
      difference.see(std::abs(static_cast<double>(there.separation) / scale - here), i);
    }
    INFO("scale " << scale << ", pair " << difference.pair);
    CHECK(difference.error < tolerance);
  }
}

TEST_CASE("A warm start changes the work, not the answer", "[gjk]") {
  HullPool pool(25);
  Worst difference;
  int cold_work = 0;
  int warm_work = 0;
  for (int i = 0; i < 20000; ++i) {
    const KindPair kinds = kind_pairs[static_cast<std::size_t>(i) % kind_pairs.size()];
    const PlacedHull a = pool.draw(kinds.a, 2);
    PlacedHull b = pool.draw(kinds.b, 2);
    SimplexCache cache;
    for (int step = 0; step < 4; ++step) {
      const DistanceResult cold = distance_of(a, b);
      const DistanceResult warm = distance(a.hull, a.pose, b.hull, b.pose, cache);
      difference.see(std::abs(static_cast<double>(cold.separation - warm.separation)), i);
      cold_work += step > 0 ? cold.iterations : 0;
      warm_work += step > 0 ? warm.iterations : 0;
      b.pose = {b.pose.position + Vec2(real(0.01), real(0.01)), Rot(Rotd(0.01)) * b.pose.rotation};
    }
  }
  INFO("pair " << difference.pair);
  CHECK(difference.error < tolerance);
  CHECK(warm_work < 0.6 * cold_work);
}

TEST_CASE("Any simplex of the two shapes is a good enough start", "[gjk]") {
  HullPool pool(26);
  Worst difference;
  for (int i = 0; i < 20000; ++i) {
    const PlacedHull a = pool.draw(Kind::polygon, 1.5);
    const PlacedHull b = pool.draw(Kind::polygon, 1.5);
    SimplexCache cache;
    cache.count = static_cast<std::uint8_t>(1 + pool.random().below(3));
    for (int k = 0; k < 3; ++k) {
      cache.a[k] = static_cast<std::uint8_t>(pool.random().below(static_cast<std::uint32_t>(a.hull.count)));
      cache.b[k] = static_cast<std::uint8_t>(pool.random().below(static_cast<std::uint32_t>(b.hull.count)));
    }
    const real warm = distance(a.hull, a.pose, b.hull, b.pose, cache).separation;
    difference.see(std::abs(static_cast<double>(distance_of(a, b).separation - warm)), i);
  }
  INFO("pair " << difference.pair);
  CHECK(difference.error < tolerance);
}

TEST_CASE("Shapes that coincide overlap, a hundred times over", "[gjk]") {
  for (int i = 0; i < 100; ++i) {
    const PlacedHull box = place(box_shape(1 + i, 1), {0.1 * i, 3}, 0.1 * i);
    CHECK(distance_of(box, box).cores_overlap);
    CHECK(distance_of(box, box).separation == 0);
  }
  const PlacedHull disc = place(disc_shape(0.5), {1, 1});
  CHECK(distance_of(disc, disc).cores_overlap);
  CHECK(distance_of(disc, disc).separation == -1);
  const PlacedHull segment = place(segment_shape({-1, 0}, {1, 0}), {2, 0});
  CHECK(distance_of(segment, segment).cores_overlap);
}

TEST_CASE("A sliver 3.2 mm thick is 5 mm from a point to a millionth of a metre", "[gjk]") {
  const PlacedHull sliver = place(box_shape(2, 0.0032), {0, 0});
  for (const double x : {-0.9, 0.0, 0.4}) {
    const DistanceResult r = distance_of(sliver, place(polygon_shape({{0, 0}}), {x, 0.0066}));
    CHECK(r.separation == Approx(0.005).margin(pick(1e-12, 1e-6)));
    CHECK(r.normal.y == Approx(1));
  }
}

TEST_CASE("A needle has its distance at the tip and along its side", "[gjk]") {
  const PlacedHull needle = place(polygon_shape({{0, -1e-5}, {10, 0}, {0, 1e-5}}), {0, 0});
  const PlacedHull disc = place(disc_shape(0.25), {10.5, 0});
  CHECK(distance_of(needle, disc).separation == Approx(0.25).margin(tolerance));
  CHECK(distance_of(needle, disc).on_a.x == Approx(10));
  CHECK(distance_of(needle, place(disc_shape(0.25), {5, 1})).separation == Approx(0.75).margin(pick(1e-5, 2e-5)));
}

TEST_CASE("Shapes that touch at a corner are no distance apart", "[gjk]") {
  const PlacedHull box = place(box_shape(1, 1), {0, 0});
  const PlacedHull diamond = place(polygon_shape({{0, 0}, {1, -1}, {2, 0}, {1, 1}}), {0.5, 0.25});
  CHECK(distance_of(box, diamond).separation == Approx(0).margin(tolerance));
  CHECK(distance_of(box, place(box_shape(1, 1), {1, 1})).separation == Approx(0).margin(tolerance));
}

TEST_CASE("A shape within another overlaps it", "[gjk]") {
  const DistanceResult r = distance_of(place(box_shape(4, 4), {0, 0}), place(box_shape(0.1, 0.1), {1, -1.5}, 0.3));
  CHECK(r.cores_overlap);
  CHECK(r.separation == 0);
}

TEST_CASE("The search ends when the origin lies on the boundary of the simplex", "[gjk]") {
  // Grids of boxes touch at faces and corners: differences of whole numbers are exact, so the origin is exactly there.
  const ShapeDef box = box_shape(2, 2);
  for (int x = -3; x <= 3; ++x) {
    for (int y = -3; y <= 3; ++y) {
      const DistanceResult r = distance_of(place(box, {0, 0}), place(box, Vec2d(x, y)));
      const Vec2d gap{std::max(std::abs(x) - 2, 0) * 1.0, std::max(std::abs(y) - 2, 0) * 1.0};
      CHECK(r.separation == Approx(length(gap)));
      CHECK(r.cores_overlap == (gap == Vec2d{}));
      CHECK(r.iterations < 8);
    }
  }
}

TEST_CASE("Parallel edges are as far apart as their lines", "[gjk]") {
  const PlacedHull floor = place(box_shape(10, 1), {0, -0.5});
  for (int i = 0; i < 1000; ++i) {
    const double gap = 1e-3 * i;
    const DistanceResult r = distance_of(floor, place(box_shape(1, 1), {0.01 * i - 5, 0.5 + gap}));
    CHECK(r.separation == Approx(gap).margin(tolerance));
    if (i > 0) CHECK(r.normal.y == Approx(1).margin(tolerance));
  }
}

TEST_CASE("Roundings that overlap have a normal and a depth of their own", "[gjk]") {
  const PlacedHull a = place(polygon_shape({{-1, 0}, {1, 0}}, 0.3), {0, 0});
  const DistanceResult r = distance_of(a, place(disc_shape(0.2), {0.5, 0.4}));
  CHECK_FALSE(r.cores_overlap);
  CHECK(r.separation == Approx(-0.1).margin(tolerance));
  CHECK(r.normal.y == Approx(1));
  CHECK(r.on_a.y == Approx(0.3));
  CHECK(r.on_b.y == Approx(0.2));
}

TEST_CASE("Who watches the search sees the simplex come nearer the origin and the distance at the end", "[gjk]") {
  const PlacedHull a = place(box_shape(1, 1), {0, 0}, 0.3);
  const PlacedHull b = place(box_shape(1, 2), {2, 1}, 1);
  std::vector<Event> events;
  const Observer observer([&](const Event& event) { events.push_back(event); });
  SimplexCache cache;
  const DistanceResult watched = distance(a.hull, a.pose, b.hull, b.pose, cache, observer);
  CHECK(watched.separation == distance_of(a, b).separation);
  double nearest = 1e300;
  int asked = 0;
  for (const Event& event : events) {
    asked += std::holds_alternative<SupportFound>(event) ? 1 : 0;
    if (const auto* reduced = std::get_if<SimplexReduced>(&event)) {
      CHECK(length(reduced->closest) < nearest);
      nearest = length(reduced->closest);
    }
  }
  CHECK(asked == watched.iterations);
  REQUIRE(std::holds_alternative<DistanceFound>(events.back()));
  CHECK(std::get<DistanceFound>(events.back()).distance == Approx(nearest));
}
