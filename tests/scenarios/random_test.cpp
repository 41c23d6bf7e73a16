#include "scenarios/random.h"

#include <catch2/catch.hpp>

using proofreel::Random;

TEST_CASE("The generator starts as its authors' reference does") {
  Random random(1);
  CHECK(random.next() == 0xB3F2AF6D0FC710C5U);
}

TEST_CASE("Every value of an interval is drawn about equally often") {
  Random random(7);
  int counts[5] = {};
  for (int i = 0; i < 50000; ++i) ++counts[random.between(-2, 2) + 2];
  for (const int count : counts) CHECK(std::abs(count - 10000) < 400);  // 4.5 standard deviations
}

TEST_CASE("The widest and the narrowest interval work") {
  Random random(3);
  CHECK(random.between(5, 5) == 5);
  const auto any = random.between(INT64_MIN, INT64_MAX);
  CHECK(any != random.between(INT64_MIN, INT64_MAX));
}
