#include "engine/rot.h"

#include <catch2/catch.hpp>

#include "tests/engine/random.h"

namespace proofreel {
namespace {

TEMPLATE_TEST_CASE("A quarter turn takes x to y", "", float, double) {
  const BasicRot<TestType> quarter{TestType(0), TestType(1)};
  CHECK(rotate(quarter, BasicVec2<TestType>{1, 0}) == BasicVec2<TestType>{0, 1});
  CHECK(rotate(BasicRot<TestType>{}, BasicVec2<TestType>{3, 4}) == BasicVec2<TestType>{3, 4});
}

TEST_CASE("Composing rotations adds their angles") {
  Random random(3);
  for (int i = 0; i < 1000; ++i) {
    const double a = random.between(-10, 10);
    const double b = random.between(-10, 10);
    const Rotd both = Rotd(a) * Rotd(b);
    const Rotd sum(a + b);
    REQUIRE(both.c == Approx(sum.c).margin(3e-15));
    REQUIRE(both.s == Approx(sum.s).margin(3e-15));
  }
}

TEST_CASE("Rotating back undoes rotating and lengths stay") {
  Random random(4);
  for (int i = 0; i < 1000; ++i) {
    const Rotd q(random.between(-10, 10));
    const Vec2d v{random.between(-9, 9), random.between(-9, 9)};
    REQUIRE(distance(inverse_rotate(q, rotate(q, v)), v) < 1e-14);
    REQUIRE(distance(rotate(inverse(q), v), inverse_rotate(q, v)) == 0);
    REQUIRE(length(rotate(q, v)) == Approx(length(v)).epsilon(1e-15));
  }
}

TEST_CASE("Normalizing a rotation that has drifted keeps its direction") {
  const Rotd q = normalized(Rotd{0.6 * 1.001, 0.8 * 1.001});
  CHECK(q.c == Approx(0.6).epsilon(1e-15));
  CHECK(q.s == Approx(0.8).epsilon(1e-15));
}

TEST_CASE("A rotation in single precision is the rounded one in double") {
  const BasicRot<float> q(0.7F);
  CHECK(q == BasicRot<float>(Rotd(static_cast<double>(0.7F))));
}

}  // namespace
}  // namespace proofreel
