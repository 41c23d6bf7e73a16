#include "engine/polygon.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <limits>

#include "engine/elementary.h"
#include "engine/scene.h"
#include "tests/engine/random.h"

namespace proofreel {
namespace {

using Points = std::vector<Vec2d>;
using Catch::Matchers::Contains;

constexpr double inf = std::numeric_limits<double>::infinity();
constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double pi = 3.141592653589793;

const Points square{{0, 0}, {1, 0}, {1, 1}, {0, 1}};

Points cleaned(const Points& corners) {
  const auto result = clean_polygon(corners);
  if (const auto* sentence = std::get_if<std::string>(&result)) FAIL(*sentence);
  return std::get<Points>(result);
}

std::string refusal(const Points& corners) {
  const auto result = clean_polygon(corners);
  REQUIRE(std::holds_alternative<std::string>(result));
  return std::get<std::string>(result);
}

Points regular(int sides, double radius, Vec2d center = {}) {
  Points corners;
  for (int i = 0; i < sides; ++i) {
    const double angle = 2 * pi * i / sides;
    corners.push_back(center + radius * Vec2d{elementary::cos(angle), elementary::sin(angle)});
  }
  return corners;
}

Points moved(Points corners, Vec2d by) {
  for (Vec2d& p : corners) p += by;
  return corners;
}

Points scattered(Random& random, int count, double size) {
  Points points;
  for (int i = 0; i < count; ++i) points.push_back({random.between(-size, size), random.between(-size, size)});
  return points;
}

/// A point is a corner of the hull when some line through it and another point has everything on its left, and it is
/// not between two others.
Points brute_force_hull_corners(const Points& points) {
  Points corners;
  for (const Vec2d a : points) {
    bool is_corner = false;
    for (const Vec2d b : points) {
      if (a == b) continue;
      is_corner = is_corner || std::all_of(points.begin(), points.end(), [&](Vec2d p) {
                    const double side = orientation(a, b, p);
                    return side > 0 || (side == 0 && dot(p - a, b - a) >= 0);
                  });
    }
    if (is_corner && std::find(corners.begin(), corners.end(), a) == corners.end()) corners.push_back(a);
  }
  return corners;
}

Points in_order(Points points) {
  std::sort(points.begin(), points.end(), [](Vec2d a, Vec2d b) { return a.x < b.x || (a.x == b.x && a.y < b.y); });
  return points;
}

TEST_CASE("Orientation tells left from right where the plain formula drowns in rounding") {
  // Points one last bit apart round the line y = x: the plain formula gets many of them wrong.
  const Vec2d b{12, 12};
  const Vec2d c{24, 24};
  for (int i = -8; i <= 8; ++i) {
    for (int j = -8; j <= 8; ++j) {
      const double side = orientation(Vec2d{0.5 + i * 0x1p-53, 0.5 + j * 0x1p-53}, b, c);
      CAPTURE(i, j);
      REQUIRE((side > 0) == (j > i));
      REQUIRE((side < 0) == (j < i));
    }
  }
  CHECK(orientation({0, 0}, {12, 12}, {24, 24 + 0x1p-48}) > 0);
  CHECK(orientation({0, 0}, {1, 0}, {0, 1}) == 1);
  CHECK(orientation({0, 0}, {0, 1}, {1, 0}) == -1);
}

TEST_CASE("A clean counter-clockwise polygon comes back as it is") {
  CHECK(cleaned(square) == square);
  CHECK(cleaned(regular(16, 2)) == regular(16, 2));
  const Points far_triangle{{1e9, 1e9}, {1e9 - 5, 1e9}, {1e9 - 5, 1e9 - 5}};
  CHECK(cleaned(far_triangle) == far_triangle);
}

TEST_CASE("A clockwise polygon is turned round and keeps its first corner") {
  CHECK(cleaned({{0, 0}, {0, 1}, {1, 1}, {1, 0}}) == square);
}

TEST_CASE("Duplicates and points on straight edges are dropped") {
  CHECK(cleaned({{0, 0}, {0, 0}, {0.3, 0}, {1, 0}, {1, 0.1}, {1, 0.2}, {1, 1}, {1, 1}, {0, 1}, {0, 0}}) == square);
  CHECK(cleaned({{0.5, 0}, {1, 0}, {1, 1}, {0, 1}, {0, 0}, {0.25, 0}}).size() == 4);
  CHECK(cleaned({{0, 0}, {0.1, 0.3}, {0.2, 0.6}, {0.3, 0.9}, {-2, 1}}).size() == 3);  // 0.1, 0.2, 0.3 are rounded
}

TEST_CASE("A hundred points on the edges of a square are no more than its four corners") {
  Points corners;
  for (int i = 0; i < 25; ++i) corners.push_back({i / 25.0, 0});
  for (int i = 0; i < 25; ++i) corners.push_back({1, i / 25.0});
  for (int i = 0; i < 25; ++i) corners.push_back({1 - i / 25.0, 1});
  for (int i = 0; i < 25; ++i) corners.push_back({0, 1 - i / 25.0});
  CHECK(cleaned(corners) == square);
}

TEST_CASE("Coordinates that are not finite or too large are refused by corner") {
  CHECK_THAT(refusal({{0, 0}, {1, nan}, {1, 1}}), Contains("corner 2") && Contains("not finite"));
  CHECK_THAT(refusal({{0, 0}, {1, 0}, {-inf, 1}}), Contains("corner 3") && Contains("not finite"));
  CHECK_THAT(refusal({{1.1e9, 0}, {1, 0}, {1, 1}}), Contains("corner 1") && Contains("1e9"));
  CHECK_THAT(refusal({{0, 0}, {1, 0}, {1, -2e9}}), Contains("corner 3") && Contains("1e9"));
}

TEST_CASE("Fewer than three distinct points are no polygon") {
  for (const Points& corners : {Points{}, Points{{1, 1}}, Points{{0, 0}, {1, 1}},
                                Points{{0, 0}, {1, 1}, {0, 0}, {1, 1}}, Points(5, Vec2d{2, 3})}) {
    CHECK_THAT(refusal(corners), Contains("fewer than three distinct points"));
  }
}

TEST_CASE("Corners on one line have zero area") {
  CHECK_THAT(refusal({{0, 0}, {1, 1}, {2, 2}}), Contains("zero area"));
  CHECK_THAT(refusal({{0, 0}, {3, 0}, {1, 0}, {2, 0}}), Contains("zero area"));
  CHECK_THAT(refusal({{0, 0}, {0.1, 0.3}, {0.2, 0.6}, {0.7, 2.1}}), Contains("zero area"));
}

TEST_CASE("A polygon thinner than a millionth of its extent is refused, one a little thicker is not") {
  CHECK_THAT(refusal({{0, 0}, {1000, 0}, {1000, 0.0009}, {0, 0.0009}}), Contains("thinner than a millionth"));
  CHECK(cleaned({{0, 0}, {1000, 0}, {1000, 0.0011}, {0, 0.0011}}).size() == 4);
  const Points slanted{{0, 0}, {700, 700}, {699.9995, 700.0005}, {-0.0005, 0.0005}};
  CHECK_THAT(refusal(slanted), Contains("thinner than a millionth"));
}

TEST_CASE("A polygon that crosses itself is refused, with the edges by the user's own numbers") {
  CHECK_THAT(refusal({{0, 0}, {1, 1}, {1, 0}, {0, 1}}), Contains("crosses itself") &&
                                                            Contains("from corner 1 to corner 2") &&
                                                            Contains("from corner 3 to corner 4"));
  CHECK_THAT(refusal({{0, 0}, {0.5, 0.5}, {1, 1}, {1, 0}, {0, 1}}), Contains("crosses itself") &&
                                                                        Contains("from corner 1 to corner 3") &&
                                                                        Contains("from corner 4 to corner 5"));
  const Points round = regular(5, 1);
  CHECK_THAT(refusal({round[0], round[2], round[4], round[1], round[3]}), Contains("crosses itself"));
}

TEST_CASE("A polygon that touches itself or goes back on its own edge is refused as crossing") {
  CHECK_THAT(refusal({{0, 0}, {2, 0}, {2, 2}, {1, 0}, {0, 2}}), Contains("crosses itself"));
  CHECK_THAT(refusal({{0, 0}, {4, 0}, {4, 4}, {4, -4}, {2, -4}}), Contains("crosses itself"));
  CHECK_THAT(refusal({{0, 0}, {1, 0}, {0, 1}, {1, 0}}), Contains("crosses itself"));
}

TEST_CASE("More corners than a polygon may have are refused with both numbers") {
  CHECK_THAT(refusal(regular(17, 1)), Contains("17 corners") && Contains("at most 16"));
}

TEST_CASE("A concave polygon is refused in either sense, with the corner and the way out") {
  const Points dart{{0, 0}, {2, 0}, {0.5, 0.5}, {0, 2}};
  CHECK_THAT(refusal(dart), Contains("concave at corner 3") && Contains("not built yet") && Contains("shapes={...}"));
  CHECK_THAT(refusal(Points(dart.rbegin(), dart.rend())), Contains("concave at corner 2"));
}

TEST_CASE("Convexity needs left turns only and one round only") {
  CHECK(is_convex(square));
  CHECK(is_convex(regular(16, 3)));
  CHECK(is_convex(Points{{0, 0}, {1, 0}, {2, 0}, {1, 1}}));
  CHECK_FALSE(is_convex(Points(square.rbegin(), square.rend())));
  CHECK_FALSE(is_convex(Points{{0, 0}, {2, 0}, {0.5, 0.5}, {0, 2}}));
  const Points round = regular(5, 1);
  CHECK_FALSE(is_convex(Points{round[0], round[2], round[4], round[1], round[3]}));
  CHECK_FALSE(is_convex(Points{{0, 0}, {1, 0}}));
}

TEST_CASE("The hull has the corners that brute force finds, counter-clockwise") {
  Random random(21);
  for (int round = 0; round < 200; ++round) {
    const Points points = scattered(random, 3 + static_cast<int>(random.below(30)), 5);
    const Points hull = convex_hull(points);
    REQUIRE(is_convex(hull));
    REQUIRE(in_order(hull) == in_order(brute_force_hull_corners(points)));
  }
}

TEST_CASE("The hull of a grid with many points on one line and many equal ones has no needless corner") {
  Random random(22);
  for (int round = 0; round < 200; ++round) {
    Points points;
    for (int i = 0; i < 40; ++i) points.push_back({0.1 * random.below(5), 0.1 * random.below(5)});
    REQUIRE(in_order(convex_hull(points)) == in_order(brute_force_hull_corners(points)));
  }
}

TEST_CASE("The hull of a hull is itself, and of a polygon's cleaned corners too") {
  Random random(23);
  for (int round = 0; round < 100; ++round) {
    const Points hull = convex_hull(scattered(random, 12, 1e3));
    REQUIRE(convex_hull(hull) == hull);
    REQUIRE(cleaned(hull) == hull);
  }
}

TEST_CASE("The hull of what has no area is its ends") {
  CHECK(convex_hull({}).empty());
  CHECK(convex_hull({{1, 2}, {1, 2}, {1, 2}}) == Points{{1, 2}});
  CHECK(convex_hull({{1, 1}, {3, 3}, {0, 0}, {2, 2}, {3, 3}}) == Points{{0, 0}, {3, 3}});
}

TEST_CASE("The hull of numbers nobody can use comes to an end") {
  CHECK(convex_hull({{0, 0}, {nan, 1}, {1, 1}}).size() == 3);
  CHECK(convex_hull({{1e308, -1e308}, {-1e308, 1e308}, {1e308, 1e308}, {-1e308, -1e308}, {0, 0}}).size() <= 5);
}

TEST_CASE("A rectangle has the area, centre and second moment of the textbook") {
  const Points rectangle{{1, 2}, {4, 2}, {4, 4}, {1, 4}};
  CHECK(area_of(rectangle) == 6);
  CHECK(centroid_of(rectangle) == Vec2d{2.5, 3});
  CHECK(second_moment_of(rectangle) == Approx(6 * (9.0 + 4.0) / 12));
}

TEST_CASE("A regular polygon has the area and second moment of the closed form") {
  for (int sides = 3; sides <= 16; ++sides) {
    const double central_angle = 2 * pi / sides;
    const double area = sides * 4 * elementary::sin(central_angle) / 2;
    const double second = area * 4 * (2 + elementary::cos(central_angle)) / 6;
    const Points corners = regular(sides, 2, {3, -1});
    CAPTURE(sides);
    CHECK(area_of(corners) == Approx(area).epsilon(1e-13));
    CHECK(distance(centroid_of(corners), Vec2d{3, -1}) < 1e-14);
    CHECK(second_moment_of(corners) == Approx(second).epsilon(1e-13));
  }
}

TEST_CASE("Parts of a concave polygon that lie outside do not count") {
  const Points l_shape{{1, 1}, {1, 2}, {0, 2}, {0, 0}, {2, 0}, {2, 1}};  // starts at the inner corner
  CHECK(area_of(l_shape) == 3);
  CHECK(distance(centroid_of(l_shape), Vec2d{5.0 / 6, 5.0 / 6}) < 1e-15);
  CHECK(second_moment_of(l_shape) == Approx(3.0 / 6 + 12.0 / 9));  // of three unit squares
}

TEST_CASE("Area and second moment stay and the centroid goes along when a polygon is moved far away") {
  Random random(24);
  for (int round = 0; round < 100; ++round) {
    Points corners = convex_hull(scattered(random, 10, 4));
    for (Vec2d& p : corners)
      p = {std::ldexp(std::round(std::ldexp(p.x, 20)), -20), std::ldexp(std::round(std::ldexp(p.y, 20)), -20)};
    const Vec2d way{0x1p29, -0x1p28};  // exact on the grid of 2^-20: nothing is rounded by the move itself
    const Points far = moved(corners, way);
    REQUIRE(area_of(far) == area_of(corners));
    REQUIRE(second_moment_of(far) == second_moment_of(corners));
    REQUIRE(distance(centroid_of(far), centroid_of(corners) + way) < 1e-6);
  }
}

TEST_CASE("The second moment of a polygon cut in two is that of its parts moved by the parallel-axis theorem") {
  Random random(25);
  for (int round = 0; round < 100; ++round) {
    const Points whole = convex_hull(scattered(random, 12, 4));
    if (whole.size() < 4) continue;
    const auto middle = whole.begin() + 2;
    const Points first(whole.begin(), middle + 1);
    Points second(middle, whole.end());
    second.push_back(whole.front());
    double sum = 0;
    for (const Points& part : {first, second}) {
      sum += second_moment_of(part) + area_of(part) * length_squared(centroid_of(part) - centroid_of(whole));
    }
    REQUIRE(sum == Approx(second_moment_of(whole)).epsilon(1e-12));
  }
}

}  // namespace
}  // namespace proofreel
