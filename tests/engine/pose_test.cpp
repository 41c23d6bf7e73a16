#include "engine/pose.h"

#include <catch2/catch.hpp>

#include "tests/engine/random.h"

namespace proofreel {
namespace {

TEST_CASE("A pose turns first and moves then") {
  const Posed pose{{10, 20}, Rotd{0, 1}};
  CHECK(to_world(pose, Vec2d{1, 0}) == Vec2d{10, 21});
  CHECK(to_world(Posed{}, Vec2d{3, 4}) == Vec2d{3, 4});
}

TEST_CASE("Going to body coordinates undoes going to the world") {
  Random random(5);
  for (int i = 0; i < 1000; ++i) {
    const Posed pose{{random.between(-9, 9), random.between(-9, 9)}, Rotd(random.between(-9, 9))};
    const Vec2d p{random.between(-9, 9), random.between(-9, 9)};
    REQUIRE(distance(to_local(pose, to_world(pose, p)), p) < 1e-14);
  }
}

TEST_CASE("A pose in single precision holds the rounded numbers") {
  const Posed pose{{0.1, 0.2}, Rotd(0.3)};
  const BasicPose<float> rounded(pose);
  CHECK(rounded.position == BasicVec2<float>{0.1F, 0.2F});
  CHECK(rounded.rotation.c == static_cast<float>(pose.rotation.c));
}

}  // namespace
}  // namespace proofreel
