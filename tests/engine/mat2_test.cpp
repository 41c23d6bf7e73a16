#include "engine/mat2.h"

#include <catch2/catch.hpp>

#include "tests/engine/random.h"

namespace proofreel {
namespace {

const Mat2d sample{{1, 3}, {2, 4}};  // columns: | 1 2 |
                                     //          | 3 4 |

TEST_CASE("A matrix sends the axes to its columns") {
  CHECK(sample * Vec2d{1, 0} == Vec2d{1, 3});
  CHECK(sample * Vec2d{0, 1} == Vec2d{2, 4});
  CHECK(Mat2d{} * Vec2d{5, 6} == Vec2d{5, 6});
}

TEST_CASE("The product of matrices applies the right one first") {
  const Mat2d quarter_turn{{0, 1}, {-1, 0}};
  const Vec2d v{5, 7};
  CHECK((sample * quarter_turn) * v == sample * (quarter_turn * v));
  CHECK_FALSE((quarter_turn * sample) * v == sample * (quarter_turn * v));
}

TEST_CASE("The determinant is the area of the unit square's image, with the sign of its sense") {
  CHECK(determinant(sample) == -2);
  CHECK(determinant(Mat2d{{0, 1}, {1, 0}}) == -1);
  CHECK(determinant(Mat2d{}) == 1);
}

TEST_CASE("Solving undoes multiplication") {
  Random random(2);
  for (int i = 0; i < 1000; ++i) {
    const Mat2d m{{random.between(-3, 3), random.between(-3, 3)}, {random.between(-3, 3), random.between(-3, 3)}};
    if (std::fabs(determinant(m)) < 0.1) continue;
    const Vec2d x{random.between(-9, 9), random.between(-9, 9)};
    REQUIRE(distance(solve(m, m * x), x) < 1e-12);
  }
}

TEST_CASE("Solving with a singular matrix gives the zero vector") {
  CHECK(solve(Mat2d{{1, 2}, {2, 4}}, Vec2d{1, 1}) == Vec2d{});
}

}  // namespace
}  // namespace proofreel
