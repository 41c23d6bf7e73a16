#include <algorithm>
#include <catch2/catch.hpp>
#include <limits>

#include "engine/outline.h"
#include "engine/polygon.h"
#include "tests/engine/outlines.h"

namespace proofreel {
namespace {

using namespace test;

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

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

TEST_CASE("Convexity needs left turns only and one round only") {
  CHECK(is_convex(square));
  CHECK(is_convex(regular(16, 3)));
  CHECK(is_convex(Points{{0, 0}, {1, 0}, {2, 0}, {1, 1}}));
  CHECK_FALSE(is_convex(Points(square.rbegin(), square.rend())));
  CHECK_FALSE(is_convex(Points{{0, 0}, {2, 0}, {0.5, 0.5}, {0, 2}}));
  const Points round = regular(5, 1);
  CHECK_FALSE(is_convex(Points{round[0], round[2], round[4], round[1], round[3]}));
  CHECK_FALSE(is_convex(Points{{0, 0}, {1, 0}}));
  CHECK_FALSE(is_convex(Points{}));
}

TEST_CASE("Convexity is not fooled by repeated corners or by outlines without area") {
  CHECK(is_convex(Points{{0, 0}, {1, 0}, {1, 0}, {1, 1}, {0, 1}, {0, 0}}));
  CHECK_FALSE(is_convex(Points{{0, 0}, {2, 0}, {0.5, 0.5}, {0.5, 0.5}, {0, 2}}));
  CHECK_FALSE(is_convex(Points{{0, 0}, {1, 0}, {2, 0}}));
  CHECK_FALSE(is_convex(Points{{0, 0}, {1, 1}, {2, 2}}));
  CHECK_FALSE(is_convex(Points{{0, 0}, {1, 1}, {2, 2}, {1, 1}}));
  CHECK_FALSE(is_convex(Points{{1, 1}, {1, 1}, {1, 1}}));
}

TEST_CASE("A dart is not convex, though it passes the thesis' formula as printed") {
  const Vec2d a{1, 1}, b{0, 4}, c{0, 0}, d{4, 0};
  const double printed_one = cross(d - b, a - c) * cross(d - b, c - b);  // CA where BA belongs
  const double printed_two = cross(c - a, d - a) * cross(c - a, b - a);
  REQUIRE((printed_one < 0 && printed_two < 0));
  CHECK_FALSE(quadrilateral_is_convex(a, b, c, d));
  CHECK_FALSE(quadrilateral_is_convex(b, c, d, a));
  CHECK(quadrilateral_is_convex({3, 3}, b, c, d));
}

/// What the edge walk says of the quadrilateral in either sense.
bool walks_convex(Vec2d a, Vec2d b, Vec2d c, Vec2d d) {
  return is_convex(Points{a, b, c, d}) || is_convex(Points{d, c, b, a});
}

TEST_CASE("Diagonals and edge walk agree on every quadrilateral of a grid of four by four") {
  const auto point = [](int code) { return Vec2d{0.1 * (code % 4), 0.1 * (code / 4)}; };
  int convex = 0;
  for (int code = 0; code < 16 * 16 * 16 * 16; ++code) {
    const Vec2d a = point(code & 15), b = point(code >> 4 & 15), c = point(code >> 8 & 15), d = point(code >> 12);
    const bool by_diagonals = quadrilateral_is_convex(a, b, c, d);
    if (by_diagonals != walks_convex(a, b, c, d)) FAIL("they differ in case " << code);
    convex += by_diagonals ? 1 : 0;
  }
  CHECK(convex > 5000);
  CHECK(convex < 50'000);
}

TEST_CASE("Diagonals and edge walk agree on random quadrilaterals, nearly flat ones included") {
  Random random(26);
  for (int round = 0; round < 20'000; ++round) {
    Points p = scattered(random, 4, 1);
    if (round % 3 == 0) p[2] = lerp(p[0], p[1], random.between(-1, 2));
    if (round % 3 == 1) p[3] = lerp(p[0], p[2], random.between(0, 1));
    REQUIRE(quadrilateral_is_convex(p[0], p[1], p[2], p[3]) == walks_convex(p[0], p[1], p[2], p[3]));
  }
}

TEST_CASE("The edge walk shows every corner up to the first that turns right") {
  std::vector<CornerTested> seen;
  const Observer observer([&](const Event& event) { seen.push_back(std::get<CornerTested>(event)); });
  CHECK(is_convex(square, observer));
  REQUIRE(seen.size() == 4);
  CHECK(seen[1].before == square[0]);
  CHECK(seen[1].corner == square[1]);
  CHECK(seen[1].after == square[2]);
  CHECK(seen[1].turn == 1);
  seen.clear();
  CHECK_FALSE(is_convex(Points{{0, 0}, {2, 0}, {0.5, 0.5}, {0, 2}}, observer));
  REQUIRE(seen.size() == 3);
  CHECK((seen[0].convex && seen[1].convex && !seen[2].convex));
}

TEST_CASE("The diagonal test shows its diagonals and which one fails") {
  std::vector<DiagonalTested> seen;
  const Observer observer([&](const Event& event) { seen.push_back(std::get<DiagonalTested>(event)); });
  CHECK(quadrilateral_is_convex(square[0], square[1], square[2], square[3], observer));
  REQUIRE(seen.size() == 2);
  CHECK((seen[0].a == square[0] && seen[0].c == square[2] && seen[0].separates));
  CHECK((seen[1].a == square[1] && seen[1].c == square[3] && seen[1].separates));
  seen.clear();
  CHECK_FALSE(quadrilateral_is_convex({0, 0}, {4, 0}, {1, 1}, {0, 4}, observer));
  REQUIRE(seen.size() == 2);
  CHECK_FALSE(seen[1].separates);
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

TEST_CASE("The hull is the same far from the origin, and exact there") {
  Random random(27);
  for (int round = 0; round < 100; ++round) {
    Points points;
    for (int i = 0; i < 60; ++i) points.push_back({0x1p-20 * random.below(9), 0x1p-20 * random.below(9)});
    const Vec2d way{0x1p29, -0x1p28};  // exact on the grid of 2^-20
    REQUIRE(convex_hull(moved(points, way)) == moved(convex_hull(points), way));
    for (Vec2d& p : points) p += Vec2d{1e8 / 3, 1e8 / 7};  // rounded: nearly in line
    REQUIRE(in_order(convex_hull(points)) == in_order(brute_force_hull_corners(points)));
  }
}

/// The events of one gift wrapping.
struct WrappingSeen {
  Points corners;
  std::vector<HullCandidate> candidates;
};

WrappingSeen watch_wrapping(const Points& points) {
  WrappingSeen seen;
  const Observer observer([&](const Event& event) {
    if (const auto* corner = std::get_if<HullCorner>(&event)) {
      CHECK(corner->number == seen.corners.size());
      seen.corners.push_back(corner->corner);
    } else {
      seen.candidates.push_back(std::get<HullCandidate>(event));
      CHECK(seen.candidates.back().from == seen.corners.back());
    }
  });
  CHECK(convex_hull(points, observer) == convex_hull(points));
  return seen;
}

TEST_CASE("The hull can be redrawn from its events, and takes at most n h comparisons") {
  Random random(28);
  for (int round = 0; round < 50; ++round) {
    Points points = scattered(random, 40, 5);
    if (round % 2 == 0) {
      for (Vec2d& p : points) p = {std::round(p.x), std::round(p.y)};
    }
    const WrappingSeen seen = watch_wrapping(points);
    REQUIRE(seen.corners == convex_hull(points));
    REQUIRE(seen.candidates.size() <= points.size() * seen.corners.size());
    // The last candidate that was better, or the one all were worse than, is the next corner.
    for (std::size_t i = 0; i < seen.candidates.size(); ++i) {
      const HullCandidate& tested = seen.candidates[i];
      if (i + 1 < seen.candidates.size() && seen.candidates[i + 1].from == tested.from) {
        REQUIRE(seen.candidates[i + 1].best == (tested.better ? tested.candidate : tested.best));
      }
    }
  }
}

TEST_CASE("Gift wrapping n points on a circle compares each with each, and never more") {
  for (const int n : {8, 32, 100}) {
    const WrappingSeen seen = watch_wrapping(regular(n, 1));
    CHECK(seen.corners.size() == static_cast<std::size_t>(n));
    CHECK(seen.candidates.size() == static_cast<std::size_t>(n * (n - 2)));
  }
}

TEST_CASE("The hull of a hull is itself, and of a polygon's cleaned corners too") {
  Random random(23);
  for (int round = 0; round < 100; ++round) {
    const Points hull = convex_hull(scattered(random, 12, 1e3));
    REQUIRE(convex_hull(hull) == hull);
    REQUIRE(std::get<Points>(clean_polygon(hull)) == hull);
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

}  // namespace
}  // namespace proofreel
