#include "engine/drift.h"

#include <catch2/catch.hpp>
#include <cmath>
#include <cstring>
#include <limits>
#include <vector>

#include "tests/engine/random.h"

using namespace proofreel;

namespace {

bool same_bits(const Motion& a, const Motion& b) {
  const auto same = [](real x, real y) { return std::memcmp(&x, &y, sizeof x) == 0; };
  return same(a.delta.x, b.delta.x) && same(a.delta.y, b.delta.y) && same(a.rotation.c, b.rotation.c) &&
         same(a.rotation.s, b.rotation.s) && same(a.angle, b.angle) && same(a.velocity.x, b.velocity.x) &&
         same(a.velocity.y, b.velocity.y) && same(a.spin, b.spin);
}

/// One in three does not turn, some turn slowly, some far.
Motion random_motion(Random& random) {
  Motion m;
  m.velocity = Vec2(Vec2d{random.between(-9, 9), random.between(-9, 9)});
  m.delta = Vec2(Vec2d{random.between(-1, 1), random.between(-1, 1)});
  m.angle = static_cast<real>(random.between(-20, 20));
  m.rotation = Rot(m.angle);
  m.spin = random.below(3) == 0 ? real(0) : static_cast<real>(random.of_size(-30, 8));
  return m;
}

}  // namespace

TEST_CASE("Many bodies drift together as each of them does alone, to the last bit") {
  Random random(71);
  for (int round = 0; round < 500; ++round) {
    std::vector<Motion> together(random.below(12));
    for (Motion& m : together) m = random_motion(random);
    std::vector<Motion> alone = together;
    const auto h = static_cast<real>(random.between(-0.02, 0.02));
    drift(together, h);
    for (Motion& m : alone) drift(m, h);
    for (std::size_t i = 0; i < alone.size(); ++i) REQUIRE(same_bits(together[i], alone[i]));
  }
}

TEST_CASE(
    "A body that does not turn keeps its rotation beside others that do, even one that is not quite of length 1") {
  std::vector<Motion> motions(8);
  for (std::size_t i = 0; i < motions.size(); ++i) motions[i].spin = i % 2 == 0 ? real(1) : real(0);
  for (Motion& m : motions) m.rotation = {real(0.6000001), real(0.8)};
  drift(motions, real(0.01));
  for (std::size_t i = 0; i < motions.size(); ++i)
    CHECK((motions[i].rotation == Rot{real(0.6000001), real(0.8)}) == (i % 2 != 0));
}

TEST_CASE("What has lost its numbers spoils nobody beside it") {
  std::vector<Motion> motions(4);
  for (Motion& m : motions) m.spin = 1;
  motions[1].spin = std::numeric_limits<real>::quiet_NaN();
  Motion sound = motions[0];
  drift(motions, real(0.01));
  drift(sound, real(0.01));
  CHECK(std::isnan(motions[1].angle));
  for (const std::size_t i : {0U, 2U, 3U}) CHECK(same_bits(motions[i], sound));
}
