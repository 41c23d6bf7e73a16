#include "engine/outline.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <limits>

#include "engine/polygon.h"
#include "tests/engine/outlines.h"

namespace proofreel {
namespace {

using namespace test;
using Catch::Matchers::Contains;

constexpr double inf = std::numeric_limits<double>::infinity();
constexpr double nan = std::numeric_limits<double>::quiet_NaN();

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

TEST_CASE("An outline that pinches itself to a width of almost nothing is refused as touching itself") {
  for (const double gap : {1e-270, 1e-12}) {
    const auto cleaned = clean_polygon({{0, 0}, {1, 1}, {2, 0}, {2, 2}, {1, 1 + gap}, {0, 2}});
    REQUIRE(std::holds_alternative<std::string>(cleaned));
    CHECK_THAT(std::get<std::string>(cleaned), Catch::Contains("touches itself"));
  }
  CHECK(std::holds_alternative<std::vector<Vec2d>>(clean_polygon({{0, 0}, {1, 1}, {2, 0}, {2, 2}, {1, 1.01}, {0, 2}})));
}

}  // namespace
}  // namespace proofreel
