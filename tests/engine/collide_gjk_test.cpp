#include "engine/collide_gjk.h"

#include <catch2/catch.hpp>

#include "engine/collide.h"
#include "tests/engine/hulls.h"

using namespace proofreel;
using namespace proofreel::test;

namespace {

constexpr real margin = real(0.05);
const double rounding = pick(1e-7, 1e-5);

Manifold by_gjk(const PlacedHull& a, const PlacedHull& b) {
  return collide_gjk(a.hull, a.pose, b.hull, b.pose, margin);
}
Manifold by_sat(const PlacedHull& a, const PlacedHull& b) { return collide(a.hull, a.pose, b.hull, b.pose, margin); }

/// What the two may differ by: of two almost equally good faces separating axes take A's.
double slack_of(const PlacedHull& a, const PlacedHull& b) {
  return rounding + 2e-4 * static_cast<double>(std::min(a.hull.thickness, b.hull.thickness));
}

}  // namespace

TEST_CASE("Separating axes and GJK with EPA agree on touching, depth and normal", "[collide_gjk]") {
  HullPool pool(41);
  for (const KindPair kinds : kind_pairs) {
    Worst depth;
    Worst normal;
    int disagree = 0;
    int missed = 0;
    int touching = 0;
    for (int i = 0; i < pairs_per_kind; ++i) {
      const PlacedHull a = pool.draw(kinds.a, 1);
      const PlacedHull b = pool.draw(kinds.b, 1);
      const Manifold sat = by_sat(a, b);
      const Manifold gjk = by_gjk(a, b);
      const double slack = slack_of(a, b);
      if ((sat.count > 0) != (gjk.count > 0)) {
        // Only where one of them is all but the margin away. Separating axes may also find the right face and then
        // nothing to clip in front of it, about once in a million pairs; GJK may not.
        disagree += std::abs(deepest(sat.count > 0 ? sat : gjk) - margin) < slack ? 0 : 1;
        missed += sat.count > 0 && deepest(sat) < margin - real(slack) ? 1 : 0;
        continue;
      }
      if (sat.count == 0) continue;
      ++touching;
      depth.see(std::abs(static_cast<double>(deepest(sat) - deepest(gjk))) - slack, i);
      if (deepest(gjk) + a.hull.radius + b.hull.radius > 0.01 && dot(sat.normal, gjk.normal) > 0) {
        // Apart: only one normal is right. Both are. Beside the end of a face, one may take the face and the other the
        // corner as long as it does not show in the distance, which grows with the square of the angle between them.
        const double core = static_cast<double>(deepest(gjk) + a.hull.radius + b.hull.radius);
        normal.see((length(Vec2d(sat.normal - gjk.normal)) - std::sqrt(2 * rounding / core)) * 0.01 - slack, i);
      }
      const Corners ca(a, a.pose.position);
      const Corners cb(b, a.pose.position);
      const double radii = static_cast<double>(a.hull.radius) + static_cast<double>(b.hull.radius);
      if (deepest(gjk) + radii <= 0 && (ca.count > 1 || cb.count > 1)) {
        // Overlapping: on other axes of the same depth they may part.
        normal.see(
            std::abs(separation_along(Vec2d(gjk.normal), ca, cb) - radii - static_cast<double>(deepest(gjk))) - slack,
            i);
      }
    }
    INFO("kinds " << static_cast<int>(kinds.a) << ' ' << static_cast<int>(kinds.b) << ", pair " << depth.pair << " and "
                  << normal.pair);
    CHECK(disagree <= 5);
    CHECK(missed == 0);
    CHECK(depth.error <= 0);
    CHECK(normal.error <= 0);
    CHECK(touching > pairs_per_kind / 50);
  }
}

TEST_CASE("Where the normals agree, so do the points", "[collide_gjk]") {
  HullPool pool(42);
  Worst apart;
  int seen = 0;
  int counts_differ = 0;
  for (int i = 0; i < pairs_per_kind / 4; ++i) {
    const PlacedHull a = pool.draw(Kind::polygon, 1);
    const PlacedHull b = pool.draw(Kind::polygon, 1);
    if (std::min(a.hull.thickness, b.hull.thickness) < 0.1) continue;
    const Manifold sat = by_sat(a, b);
    const Manifold gjk = by_gjk(a, b);
    if (sat.count == 0 || gjk.count == 0 || length(Vec2d(sat.normal - gjk.normal)) > pick(1e-9, 1e-5)) continue;
    ++seen;
    if (sat.count != gjk.count) {
      ++counts_differ;  // a second point at the margin
      continue;
    }
    for (int k = 0; k < sat.count; ++k) {
      const Vec2 p = sat.points[k].point;
      apart.see(static_cast<double>(std::min(distance(p, gjk.points[0].point), distance(p, gjk.points[1].point))), i);
    }
  }
  INFO("pair " << apart.pair);
  CHECK(apart.error < pick(1e-7, 1e-5));
  CHECK(counts_differ < seen / 200);
  CHECK(seen > pairs_per_kind / 20);
}

TEST_CASE("A box on a floor touches it in two points by GJK too", "[collide_gjk]") {
  const PlacedHull floor = place(box_shape(4, 1), {0, 0});
  for (const double height : {0.99, 1.0, 1.01}) {
    const Manifold m = by_gjk(floor, place(box_shape(1, 1), {0.5, height}));
    REQUIRE(m.count == 2);
    CHECK(m.normal.y == Approx(1));
    CHECK(std::abs(m.points[0].point.x - m.points[1].point.x) == Approx(1));
    CHECK(m.points[0].separation == Approx(height - 1).margin(1e-6));
    CHECK(m.points[0].feature != m.points[1].feature);
  }
}

TEST_CASE("Of two parallel faces the reference is always A's, so features do not flicker", "[collide_gjk]") {
  const PlacedHull floor = place(box_shape(4, 1), {0, 0});
  const Manifold before = by_gjk(floor, place(box_shape(1, 1), {0.5, 0.999}));
  for (const double x : {0.4, 0.45, 0.55, 0.6}) {
    const Manifold after = by_gjk(floor, place(box_shape(1, 1), {x, 1.0}));
    REQUIRE(after.count == 2);
    CHECK(after.points[0].feature == before.points[0].feature);
    CHECK(after.points[1].feature == before.points[1].feature);
  }
}

TEST_CASE("Coincident discs overlap by both radii, and so do coincident capsules", "[collide_gjk]") {
  const PlacedHull disc = place(disc_shape(0.5), {1, 1});
  const Manifold discs = by_gjk(disc, disc);
  REQUIRE(discs.count == 1);
  CHECK(discs.points[0].separation == -1);
  CHECK(discs.normal == Vec2{0, 1});
  const PlacedHull capsule = place(polygon_shape({{-1, 0}, {1, 0}}, 0.25), {1, 1});
  const Manifold capsules = by_gjk(capsule, capsule);
  REQUIRE(capsules.count == 2);
  CHECK(deepest(capsules) == Approx(-0.5));
}

TEST_CASE("Corner against corner touches in one point on the line between them", "[collide_gjk]") {
  const PlacedHull box = place(box_shape(2, 2), {0, 0});
  const Manifold m = by_gjk(box, place(box_shape(2, 2), {2.03, 2.03}));
  REQUIRE(m.count == 1);
  CHECK(m.normal.x == Approx(m.normal.y).margin(1e-4));
  CHECK(m.points[0].separation == Approx(0.03 * std::sqrt(2.0)).margin(1e-6));
  CHECK(m.points[0].point.x == Approx(1.015));
}

TEST_CASE("Shapes farther apart than the margin make no manifold by GJK either", "[collide_gjk]") {
  CHECK(by_gjk(place(disc_shape(1), {0, 0}), place(disc_shape(1), {2.1, 0})).count == 0);
  CHECK(by_gjk(place(box_shape(1, 1), {0, 0}), place(box_shape(1, 1), {1.1, 0})).count == 0);
}

TEST_CASE("Who watches sees GJK, EPA and clipping in this order", "[collide_gjk]") {
  std::vector<Event> events;
  const Observer observer([&](const Event& event) { events.push_back(event); });
  const PlacedHull a = place(box_shape(1, 1), {0, 0});
  const PlacedHull b = place(box_shape(1, 1), {0.3, 0.8}, 0.2);
  collide_gjk(a.hull, a.pose, b.hull, b.pose, margin, observer);
  const auto first = [&](auto holds) { return std::find_if(events.begin(), events.end(), holds) - events.begin(); };
  const auto gjk = first([](const Event& e) { return std::holds_alternative<DistanceFound>(e); });
  const auto epa = first([](const Event& e) { return std::holds_alternative<ClosestEdge>(e); });
  const auto faces = first([](const Event& e) { return std::holds_alternative<FacesChosen>(e); });
  const auto clipped = first([](const Event& e) { return std::holds_alternative<PointClipped>(e); });
  CHECK(gjk < epa);
  CHECK(epa < faces);
  CHECK(faces < clipped);
  CHECK(clipped < static_cast<std::ptrdiff_t>(events.size()));
}
