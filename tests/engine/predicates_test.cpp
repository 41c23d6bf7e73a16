#include "engine/predicates.h"

#include <algorithm>
#include <array>
#include <catch2/catch.hpp>
#include <limits>

#include "tests/engine/random.h"

namespace proofreel {
namespace {

using Wide = __int128;

/// A point of the whole-number grid; up to 2^60 in size all products fit in 128 bits.
struct GridPoint {
  std::int64_t x = 0;
  std::int64_t y = 0;
};

template <typename Number>
int sign_of(Number x) {
  return (x > 0) - (x < 0);
}

int exact_side(GridPoint a, GridPoint b, GridPoint c) {
  return sign_of(Wide(b.x - a.x) * Wide(c.y - a.y) - Wide(b.y - a.y) * Wide(c.x - a.x));
}

Vec2d scaled(GridPoint p, int x_exponent, int y_exponent) {
  return {std::ldexp(static_cast<double>(p.x), x_exponent), std::ldexp(static_cast<double>(p.y), y_exponent)};
}

std::int64_t whole(Random& random, int bits) {
  const auto size = static_cast<std::int64_t>(random.bits() >> (64 - bits));
  return (random.bits() & 1U) != 0 ? -size : size;
}

/// Three points on a line or next to it: `c` is off by at most `bump`.
std::array<GridPoint, 3> nearly_in_line(Random& random, int bits, std::uint32_t bump) {
  const GridPoint a{whole(random, bits), whole(random, bits)};
  const GridPoint step{whole(random, bits), whole(random, bits)};
  const auto m = static_cast<std::int64_t>(random.below(8));
  const auto n = static_cast<std::int64_t>(random.below(8));
  const auto off = [&] { return std::int64_t{random.below(2 * bump + 1)} - bump; };
  return {a, {a.x + m * step.x, a.y + m * step.y}, {a.x + n * step.x + off(), a.y + n * step.y + off()}};
}

TEST_CASE("Orientation has the sign of exact arithmetic next to a line, at every scale") {
  Random random(11);
  int on_line = 0;
  for (int round = 0; round < 200'000; ++round) {
    const int bits = 2 + static_cast<int>(random.below(48));  // so that 8 steps still are doubles
    const auto [a, b, c] = nearly_in_line(random, bits, random.below(3));
    const int ex = static_cast<int>(random.below(1900)) - 1074;
    const int ey = static_cast<int>(random.below(1900)) - 1074;
    const int expected = exact_side(a, b, c);
    on_line += expected == 0 ? 1 : 0;
    CAPTURE(a.x, a.y, b.x, b.y, c.x, c.y, ex, ey);
    REQUIRE(sign_of(orientation(scaled(a, ex, ey), scaled(b, ex, ey), scaled(c, ex, ey))) == expected);
  }
  CHECK(on_line > 20'000);
}

TEST_CASE("Orientation has the sign of exact arithmetic for points of very different sizes") {
  Random random(12);
  for (int round = 0; round < 200'000; ++round) {
    std::array<GridPoint, 3> p;
    for (GridPoint& q : p) {
      const int bits = 1 + static_cast<int>(random.below(53));
      const int up = static_cast<int>(random.below(8));
      q = {whole(random, bits) * (std::int64_t{1} << up), whole(random, bits) * (std::int64_t{1} << up)};
    }
    REQUIRE(sign_of(orientation(scaled(p[0], 0, 0), scaled(p[1], 0, 0), scaled(p[2], 0, 0))) ==
            exact_side(p[0], p[1], p[2]));
  }
}

TEST_CASE("Orientation tells left from right where the plain formula drowns in rounding") {
  // Points one last bit apart round the line y = x: the plain formula gets many of them wrong.
  for (int i = -8; i <= 8; ++i) {
    for (int j = -8; j <= 8; ++j) {
      const double side = orientation(Vec2d{0.5 + i * 0x1p-53, 0.5 + j * 0x1p-53}, {12, 12}, {24, 24});
      CAPTURE(i, j);
      REQUIRE(sign_of(side) == sign_of(j - i));
    }
  }
}

TEST_CASE("Orientation sees the smallest number beside the largest coordinate") {
  constexpr double tiny = std::numeric_limits<double>::denorm_min();
  CHECK(orientation({0, 0}, {1e9, tiny}, {-1e9, -tiny}) == 0);
  CHECK(orientation({0, 0}, {1e9, tiny}, {-1e9, 0}) > 0);
  CHECK(orientation({0, 0}, {1e9, 0}, {-1e9, -tiny}) < 0);
  CHECK(orientation({tiny, 0}, {1e9, 1e9}, {-1e9, -1e9}) > 0);
  CHECK(orientation({-tiny, 0}, {1e9, 1e9}, {-1e9, -1e9}) < 0);
  CHECK(orientation({0, 0}, {tiny, 0}, {0, tiny}) > 0);
  CHECK(orientation({0, 0}, {tiny, tiny}, {2 * tiny, 2 * tiny}) == 0);
  CHECK(orientation({0, 0}, {1e308, 1e308}, {-1e308, -1e308}) == 0);
  CHECK(orientation({1e308, 1e308}, {-1e308, 1e308}, {-1e308, -1e308}) > 0);
}

TEST_CASE("Orientation changes its sign, and nothing else, when two points change places") {
  Random random(13);
  for (int round = 0; round < 50'000; ++round) {
    std::array<Vec2d, 3> p;
    for (Vec2d& q : p) q = {random.any_double(), random.any_double()};
    if (round % 2 == 0) p[2] = {2 * p[1].x - p[0].x, 2 * p[1].y - p[0].y};
    if (!is_finite(p[2])) continue;
    const int side = sign_of(orientation(p[0], p[1], p[2]));
    REQUIRE(sign_of(orientation(p[1], p[2], p[0])) == side);
    REQUIRE(sign_of(orientation(p[2], p[0], p[1])) == side);
    REQUIRE(sign_of(orientation(p[1], p[0], p[2])) == -side);
    REQUIRE(sign_of(orientation(p[0], p[2], p[1])) == -side);
    REQUIRE(sign_of(orientation(p[2], p[1], p[0])) == -side);
  }
}

TEST_CASE("The value of orientation is twice the area, also where it takes exact arithmetic to find it") {
  CHECK(orientation({0, 0}, {1, 0}, {0, 1}) == 1);
  CHECK(orientation({0, 0}, {0, 1}, {1, 0}) == -1);
  CHECK(orientation({0, 0}, {12, 12}, {24, 24 + 0x1p-48}) == 12 * 0x1p-48);
  CHECK(orientation({0, 0}, {0x1p29 + 1, 0x1p29}, {0x1p29, 0x1p29 - 1}) == -1);
  CHECK(orientation({0, 0}, {0x1p52 + 1, 0x1p52}, {0x1p52, 0x1p52 - 1}) == -1);
}

/// The two segments solved for where they meet, in whole numbers: a + t (b - a) = c + s (d - c).
bool meet_in_fractions(GridPoint a, GridPoint b, GridPoint c, GridPoint d) {
  const GridPoint u{b.x - a.x, b.y - a.y}, v{d.x - c.x, d.y - c.y}, w{c.x - a.x, c.y - a.y};
  const auto cross_of = [](GridPoint p, GridPoint q) { return p.x * q.y - p.y * q.x; };
  std::int64_t denominator = cross_of(u, v);
  std::int64_t t = cross_of(w, v);
  std::int64_t s = cross_of(w, u);
  if (denominator != 0) {
    if (denominator < 0) denominator = -denominator, t = -t, s = -s;
    return 0 <= t && t <= denominator && 0 <= s && s <= denominator;
  }
  if (cross_of(u, w) != 0 || cross_of(v, w) != 0) return false;
  // On one line, or points: their shadows on both axes meet.
  const auto shadows = [](std::int64_t p, std::int64_t q, std::int64_t r, std::int64_t e) {
    return std::max(std::min(p, q), std::min(r, e)) <= std::min(std::max(p, q), std::max(r, e));
  };
  return shadows(a.x, b.x, c.x, d.x) && shadows(a.y, b.y, c.y, d.y);
}

TEST_CASE("Segments meet exactly where fractions say so: every case on a grid of four by four") {
  const auto point = [](int code) { return GridPoint{code % 4, code / 4}; };
  // Scales that are no powers of two would move the points; these keep them on the grid far from the origin.
  for (const double offset : {0.0, 0x1p40}) {
    const auto placed = [&](GridPoint p) {
      return Vec2d{offset + static_cast<double>(p.x), offset - static_cast<double>(p.y)};
    };
    for (int code = 0; code < 16 * 16 * 16 * 16; ++code) {
      const std::array<GridPoint, 4> p{point(code & 15), point(code >> 4 & 15), point(code >> 8 & 15),
                                       point(code >> 12)};
      const Vec2d a = placed(p[0]), b = placed(p[1]), c = placed(p[2]), d = placed(p[3]);
      const bool meets = meet_in_fractions(p[0], p[1], p[2], p[3]);
      if (segments_meet(a, b, c, d) != meets) FAIL("segments_meet is wrong for case " << code);
      const bool touches = exact_side(p[0], p[1], p[2]) == 0 || exact_side(p[0], p[1], p[3]) == 0 ||
                           exact_side(p[2], p[3], p[0]) == 0 || exact_side(p[2], p[3], p[1]) == 0;
      if (segments_cross(a, b, c, d) != (meets && !touches)) FAIL("segments_cross is wrong for case " << code);
    }
  }
}

TEST_CASE("A segment that ends one last bit before another does not meet it") {
  const Vec2d a{0, 0}, b{3, 1};
  const Vec2d on{1.5, 0.5};
  const double beyond = std::nextafter(on.y, 1);
  CHECK(segments_meet(a, b, {1.5, 9}, on));
  CHECK_FALSE(segments_cross(a, b, {1.5, 9}, on));
  CHECK_FALSE(segments_meet(a, b, {1.5, 9}, {1.5, beyond}));
  CHECK(segments_cross(a, b, {1.5, 9}, {1.5, std::nextafter(on.y, 0)}));
  CHECK(is_between(on, a, b));
  CHECK(is_between(a, a, b));
  CHECK_FALSE(is_between({-0.3, -0.1}, a, b));
}

}  // namespace
}  // namespace proofreel
