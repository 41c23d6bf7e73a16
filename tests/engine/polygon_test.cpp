#include "engine/polygon.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <limits>

#include "engine/elementary.h"
#include "engine/scene.h"
#include "tests/engine/outlines.h"

namespace proofreel {
namespace {

using namespace test;
using Catch::Matchers::Contains;

constexpr double inf = std::numeric_limits<double>::infinity();
constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double pi = 3.141592653589793;

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

TEST_CASE("A polygon that touches itself or goes back on its own edge is refused, with the edges") {
  CHECK_THAT(refusal({{0, 0}, {2, 0}, {2, 2}, {1, 0}, {0, 2}}), Contains("touches itself") &&
                                                                    Contains("from corner 1 to corner 2") &&
                                                                    Contains("from corner 3 to corner 4"));
  CHECK_THAT(refusal({{0, 0}, {4, 0}, {4, 4}, {4, -4}, {2, -4}}), Contains("touches itself"));
  CHECK_THAT(refusal({{0, 0}, {1, 0}, {0, 1}, {1, 0}}), Contains("touches itself"));
  const Points two_squares_at_a_corner{{0, 0}, {1, 0}, {1, 1}, {2, 1}, {2, 2}, {1, 2}, {1, 1}, {0, 1}};
  CHECK_THAT(refusal(two_squares_at_a_corner), Contains("touches itself"));
}

TEST_CASE("A hole reached over a bridge is refused as touching, with the way out") {
  const Points keyhole{{0, 0}, {4, 0}, {4, 4}, {0, 4}, {0, 0}, {1, 1}, {1, 3}, {3, 3}, {3, 1}, {1, 1}};
  CHECK_THAT(refusal(keyhole), Contains("touches itself") && Contains("hole") && Contains("shapes={...}"));
}

TEST_CASE("An outline that leaves a millionth of its extent free is sound, and one that leaves a trillionth is not") {
  CHECK(cleaned({{0, 0}, {2, 0}, {2, 2}, {1, 2e-6}, {0, 2}}).size() == 5);
  CHECK_THAT(refusal({{0, 0}, {2, 0}, {2, 2}, {1, 2e-12}, {0, 2}}), Contains("touches itself"));
}

TEST_CASE("More corners than an outline may have are refused with both numbers") {
  CHECK(cleaned(regular(256, 1)).size() == 256);
  CHECK_THAT(refusal(regular(257, 1)), Contains("257 corners") && Contains("at most 256"));
}

TEST_CASE("A concave polygon comes back counter-clockwise from either sense, without needless corners") {
  const Points dart{{0, 0}, {2, 0}, {0.5, 0.5}, {0, 2}};
  CHECK(cleaned(dart) == dart);
  CHECK(cleaned({{0, 0}, {0, 2}, {0.5, 0.5}, {2, 0}}) == dart);
  CHECK(cleaned({{0, 0}, {1, 0}, {2, 0}, {1.25, 0.25}, {0.5, 0.5}, {0.5, 0.5}, {0, 2}}) == dart);
}

TEST_CASE("The sense of an outline is right where the area drowns in rounding") {
  // Two arms of a nanometre far from the origin round a square of one metre; areas are rounded to some 1e-7.
  const Vec2d far{3e8, -3e8};
  Points hairpin{{0, 0}, {1, 0}, {1, 1}, {0.9999, 1}, {0.9999, 0.0001}, {0, 0.0001}};
  CHECK(area_of(cleaned(moved(hairpin, far))) > 0);
  std::reverse(hairpin.begin(), hairpin.end());
  CHECK(area_of(cleaned(moved(hairpin, far))) > 0);
}

TEST_CASE("The sentences call the polygon what they are told to") {
  const auto named = [](const Points& corners) { return std::get<std::string>(clean_polygon(corners, "its hull")); };
  CHECK(named({{0, 0}, {1, nan}, {1, 1}}) == "corner 2 of its hull is not finite: give two ordinary numbers");
  CHECK_THAT(named({{0, 0}, {2e9, 0}, {1, 1}}), Contains("corner 2 of its hull has a coordinate above 1e9 m"));
  CHECK_THAT(named({{0, 0}}), Contains("its hull has fewer than three"));
  CHECK_THAT(named({{0, 0}, {1, 1}, {2, 2}}), Contains("all corners of its hull lie on one line"));
  CHECK_THAT(named({{0, 0}, {1, 0}, {1, 1e-8}}), Contains("its hull is thinner"));
  CHECK_THAT(named({{0, 0}, {1, 1}, {1, 0}, {0, 1}}), Contains("its hull crosses itself"));
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

using Wide = __int128;

/// The second moment about the centroid, rounded only at the end, of corners on the whole-number grid up to 2^16 from
/// the first.
double exact_moment(const Points& corners) {
  Wide area = 0, first_x = 0, first_y = 0, second = 0;
  for (std::size_t i = 2; i < corners.size(); ++i) {
    const auto ax = static_cast<Wide>(corners[i - 1].x - corners[0].x), ay = Wide(corners[i - 1].y - corners[0].y);
    const auto bx = static_cast<Wide>(corners[i].x - corners[0].x), by = Wide(corners[i].y - corners[0].y);
    const Wide twice = ax * by - ay * bx;
    area += twice;
    first_x += twice * (ax + bx);
    first_y += twice * (ay + by);
    second += twice * (ax * ax + ay * ay + ax * bx + ay * by + bx * bx + by * by);
  }
  const Wide numerator = 3 * second * area - 2 * (first_x * first_x + first_y * first_y);
  return static_cast<double>(numerator) / (36 * static_cast<double>(area));
}

TEST_CASE("The second moment of thin hulls far away is positive and right to the last digits") {
  Random random(29);
  for (int round = 0; round < 2000; ++round) {
    const std::uint32_t thin = 1U << random.below(16);
    Points points;
    for (int i = 0; i < 12; ++i) {
      points.push_back({static_cast<double>(random.below(60'000)), static_cast<double>(random.below(thin + 1))});
    }
    const Points hull = convex_hull(moved(points, {0x1p40, -0x1p41}));
    if (hull.size() < 3) continue;
    REQUIRE(second_moment_of(hull) > 0);
    REQUIRE(second_moment_of(hull) == Approx(exact_moment(hull)).epsilon(1e-14));
  }
}

TEST_CASE("An outline that pinches itself to a width of almost nothing is refused as touching itself") {
  for (const double gap : {1e-270, 1e-12}) {
    const auto cleaned = clean_polygon({{0, 0}, {1, 1}, {2, 0}, {2, 2}, {1, 1 + gap}, {0, 2}});
    REQUIRE(std::holds_alternative<std::string>(cleaned));
    CHECK_THAT(std::get<std::string>(cleaned), Catch::Contains("touches itself"));
  }
  CHECK(std::holds_alternative<std::vector<Vec2d>>(clean_polygon({{0, 0}, {1, 1}, {2, 0}, {2, 2}, {1, 1.01}, {0, 2}})));
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
