#include "engine/aabb.h"

#include <catch2/catch.hpp>

namespace proofreel {
namespace {

const Aabbd unit_box{{0, 0}, {1, 1}};

TEST_CASE("Boxes that touch overlap, boxes apart in one direction do not") {
  CHECK(overlaps(unit_box, Aabbd{{1, 1}, {2, 2}}));
  CHECK(overlaps(unit_box, Aabbd{{0.2, 0.2}, {0.3, 0.3}}));
  CHECK_FALSE(overlaps(unit_box, Aabbd{{1.1, 0}, {2, 1}}));
  CHECK_FALSE(overlaps(unit_box, Aabbd{{0, -1}, {1, -0.1}}));
}

TEST_CASE("A default box is empty: it overlaps nothing and grows to what it is merged with") {
  CHECK_FALSE(overlaps(Aabbd{}, unit_box));
  const Aabbd grown = merged(merged(Aabbd{}, Vec2d{2, 5}), Vec2d{-1, 7});
  CHECK(grown.lower == Vec2d{-1, 5});
  CHECK(grown.upper == Vec2d{2, 7});
}

TEST_CASE("A box contains itself and what lies inside, and is not contained in a smaller one") {
  CHECK(contains(unit_box, unit_box));
  CHECK(contains(expanded(unit_box, 0.5), unit_box));
  CHECK_FALSE(contains(unit_box, expanded(unit_box, 0.5)));
  CHECK_FALSE(contains(unit_box, Aabbd{{0.5, 0.5}, {1.5, 0.6}}));
}

TEST_CASE("A swept box covers both ends of the way and is no larger than needed") {
  const Aabbd box = swept(unit_box, Vec2d{3, -2});
  CHECK(box.lower == Vec2d{0, -2});
  CHECK(box.upper == Vec2d{4, 1});
}

TEST_CASE("Perimeter and centre of a box") {
  const Aabbd box{{1, 2}, {4, 6}};
  CHECK(perimeter(box) == 14);
  CHECK(center(box) == Vec2d{2.5, 4});
}

}  // namespace
}  // namespace proofreel
