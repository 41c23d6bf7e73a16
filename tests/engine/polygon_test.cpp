#include "engine/polygon.h"

#include <catch2/catch.hpp>

#include "engine/elementary.h"
#include "tests/engine/outlines.h"

namespace proofreel {
namespace {

using namespace test;
constexpr double pi = 3.141592653589793;

TEST_CASE("A rectangle has the area and centre of the textbook") {
  const Points rectangle{{1, 2}, {4, 2}, {4, 4}, {1, 4}};
  CHECK(area_of(rectangle) == 6);
  CHECK(centroid_of(rectangle) == Vec2d{2.5, 3});
}

TEST_CASE("A regular polygon has the area of the closed form, and its centre in the middle") {
  for (int sides = 3; sides <= 16; ++sides) {
    const double central_angle = 2 * pi / sides;
    const double area = sides * 4 * elementary::sin(central_angle) / 2;
    const Points corners = regular(sides, 2, {3, -1});
    CAPTURE(sides);
    CHECK(area_of(corners) == Approx(area).epsilon(1e-13));
    CHECK(distance(centroid_of(corners), Vec2d{3, -1}) < 1e-14);
  }
}

TEST_CASE("Parts of a concave polygon that lie outside do not count") {
  const Points l_shape{{1, 1}, {1, 2}, {0, 2}, {0, 0}, {2, 0}, {2, 1}};  // starts at the inner corner
  CHECK(area_of(l_shape) == 3);
  CHECK(distance(centroid_of(l_shape), Vec2d{5.0 / 6, 5.0 / 6}) < 1e-15);
}

TEST_CASE("The area stays and the centroid goes along when a polygon is moved far away") {
  Random random(24);
  for (int round = 0; round < 100; ++round) {
    Points corners = convex_hull(scattered(random, 10, 4));
    for (Vec2d& p : corners)
      p = {std::ldexp(std::round(std::ldexp(p.x, 20)), -20), std::ldexp(std::round(std::ldexp(p.y, 20)), -20)};
    const Vec2d way{0x1p29, -0x1p28};  // exact on the grid of 2^-20: nothing is rounded by the move itself
    const Points far = moved(corners, way);
    REQUIRE(area_of(far) == area_of(corners));
    REQUIRE(distance(centroid_of(far), centroid_of(corners) + way) < 1e-6);
  }
}

TEST_CASE("Area and centroid can be redrawn from the triangles") {
  const Points l_shape{{1, 1}, {1, 2}, {0, 2}, {0, 0}, {2, 0}, {2, 1}};
  double area = 0;
  Vec2d weighted;
  int triangles = 0;
  const Observer observer([&](const Event& event) {
    const auto& triangle = std::get<TriangleAdded>(event);
    CHECK(triangle.a == l_shape[0]);
    CHECK(triangle.signed_area == Approx(orientation(triangle.a, triangle.b, triangle.c) / 2));
    CHECK(distance(triangle.centroid, (1.0 / 3) * (triangle.a + triangle.b + triangle.c)) < 1e-15);
    area += triangle.signed_area;
    weighted += triangle.signed_area * triangle.centroid;
    ++triangles;
  });
  const Vec2d centroid = centroid_of(l_shape, observer);
  CHECK(distance(centroid, (1 / area) * weighted) < 1e-15);
  CHECK(triangles == 4);
  area = 0;
  const double whole = area_of(l_shape, observer);
  CHECK(whole == area);
}

}  // namespace
}  // namespace proofreel
