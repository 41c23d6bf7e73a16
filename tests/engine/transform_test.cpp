#include "engine/transform.h"

#include <catch2/catch.hpp>

#include "tests/engine/random.h"

namespace proofreel {
namespace {

TEST_CASE("A transform scales along the body's own axes before it turns") {
  const Transformd t = make_transform(Vec2d{10, 20}, Rotd{0, 1}, Vec2d{2, 3});
  CHECK(t * Vec2d{1, 0} == Vec2d{10, 22});
  CHECK(t * Vec2d{0, 1} == Vec2d{7, 20});
}

TEST_CASE("A transform made from a pose moves points as the pose does") {
  Random random(6);
  for (int i = 0; i < 1000; ++i) {
    const Posed pose{{random.between(-9, 9), random.between(-9, 9)}, Rotd(random.between(-9, 9))};
    const Vec2d p{random.between(-9, 9), random.between(-9, 9)};
    REQUIRE(distance(make_transform(pose) * p, to_world(pose, p)) < 1e-14);
  }
}

TEST_CASE("A product of transforms applies the right one first") {
  const Transformd a = make_transform(Vec2d{1, 2}, Rotd{0.6, 0.8}, Vec2d{2, 2});
  const Transformd b = make_transform(Vec2d{-3, 5}, Rotd{0.8, -0.6}, Vec2d{1, 4});
  const Vec2d p{7, -2};
  CHECK(distance((a * b) * p, a * (b * p)) < 1e-13);
  CHECK(distance((b * a) * p, a * (b * p)) > 1);
}

TEST_CASE("The scales stand in all four entries, so areas grow by their product") {
  const Transformd t = make_transform(Vec2d{}, Rotd{0.6, 0.8}, Vec2d{2, 5});
  CHECK(determinant(t.linear) == Approx(10));
}

}  // namespace
}  // namespace proofreel
