#include "engine/vec2.h"

#include <catch2/catch.hpp>
#include <limits>

#include "tests/engine/random.h"

namespace proofreel {
namespace {

TEMPLATE_TEST_CASE("Vectors add, subtract and scale by component", "", float, double) {
  using Vec = BasicVec2<TestType>;
  const Vec a{1, 2};
  const Vec b{3, -5};
  CHECK(a + b == Vec{4, -3});
  CHECK(a - b == Vec{-2, 7});
  CHECK(-b == Vec{-3, 5});
  CHECK(TestType(2) * a == a * TestType(2));
  Vec c = a;
  c += b;
  c -= a;
  c *= TestType(3);
  CHECK(c == Vec{9, -15});
  CHECK(Vec{} == Vec{0, 0});
}

TEMPLATE_TEST_CASE("The cross product is positive when the second vector lies counter-clockwise", "", float, double) {
  using Vec = BasicVec2<TestType>;
  CHECK(cross(Vec{1, 0}, Vec{0, 1}) == TestType(1));
  CHECK(cross(Vec{0, 1}, Vec{1, 0}) == TestType(-1));
  CHECK(cross(Vec{2, 4}, Vec{1, 2}) == TestType(0));
  CHECK(perp(Vec{1, 0}) == Vec{0, 1});
  CHECK(cross(TestType(2), Vec{3, 0}) == Vec{0, 6});
}

TEST_CASE("Dot and cross product make up the product of the lengths") {
  Random random(1);
  for (int i = 0; i < 1000; ++i) {
    const Vec2d a{random.between(-9, 9), random.between(-9, 9)};
    const Vec2d b{random.between(-9, 9), random.between(-9, 9)};
    const double sum = dot(a, b) * dot(a, b) + cross(a, b) * cross(a, b);
    REQUIRE(sum == Approx(length_squared(a) * length_squared(b)));
    REQUIRE(cross(a, b) == dot(perp(a), b));
  }
}

TEMPLATE_TEST_CASE("Normalizing gives length one and leaves the zero vector alone", "", float, double) {
  using Vec = BasicVec2<TestType>;
  CHECK(normalized(Vec{3, -4}) == Vec{TestType(3) / 5, TestType(-4) / 5});
  CHECK(normalized(Vec{0, 0}) == Vec{0, 0});
  CHECK(length(Vec{3, 4}) == TestType(5));
  CHECK(distance(Vec{1, 1}, Vec{4, 5}) == TestType(5));
}

TEST_CASE("Interpolation starts at the first point and ends at the second") {
  const Vec2d a{1, 5};
  const Vec2d b{3, -3};
  CHECK(lerp(a, b, 0.0) == a);
  CHECK(lerp(a, b, 1.0) == b);
  CHECK(lerp(a, b, 0.5) == Vec2d{2, 1});
}

TEST_CASE("A vector is finite only when both components are") {
  constexpr double inf = std::numeric_limits<double>::infinity();
  CHECK(is_finite(Vec2d{1, -1e300}));
  CHECK_FALSE(is_finite(Vec2d{inf, 0}));
  CHECK_FALSE(is_finite(Vec2d{0, -inf}));
  CHECK_FALSE(is_finite(Vec2d{0, std::numeric_limits<double>::quiet_NaN()}));
}

TEST_CASE("Conversion to single precision rounds each component") {
  CHECK(BasicVec2<float>(Vec2d{0.1, -1.0 / 3}) == BasicVec2<float>{0.1F, -1.0F / 3});
}

}  // namespace
}  // namespace proofreel
