#include "engine/pair_set.h"

#include <catch2/catch.hpp>
#include <set>

#include "tests/engine/random.h"

namespace proofreel {
namespace {

TEST_CASE("A pair enters once and can enter again after it was taken out") {
  PairSet set;
  CHECK_FALSE(set.contains(0, 1));
  CHECK(set.insert(0, 1));
  CHECK_FALSE(set.insert(0, 1));
  CHECK(set.contains(0, 1));
  set.erase(0, 1);
  CHECK(set.size() == 0);
  CHECK_FALSE(set.contains(0, 1));
  CHECK(set.insert(0, 1));
}

TEST_CASE("Taking out a pair that is not in the set changes nothing") {
  PairSet set;
  set.insert(3, 7);
  set.erase(3, 8);
  set.erase(2, 7);
  CHECK(set.contains(3, 7));
  CHECK(set.size() == 1);
}

TEST_CASE("Whatever is put in and taken out, the set holds what std::set holds") {
  Random random(21);
  PairSet set;
  std::set<std::pair<std::uint32_t, std::uint32_t>> expected;
  for (int i = 0; i < 200'000; ++i) {
    const std::uint32_t stride = i < 100'000 ? 1 : 0x5000001;  // close together, and all over the range
    const std::uint32_t a = random.below(50);
    const std::uint32_t b = a + 1 + random.below(50 - a);
    const std::pair pair{stride * a, stride * b};
    if (random.below(2) == 0) {
      REQUIRE(set.insert(pair.first, pair.second) == expected.insert(pair).second);
    } else {
      set.erase(pair.first, pair.second);
      expected.erase(pair);
    }
    REQUIRE(set.size() == expected.size());
    REQUIRE(set.contains(pair.first, pair.second) == expected.contains(pair));
  }
  for (const auto& [a, b] : expected) REQUIRE(set.contains(a, b));
}

}  // namespace
}  // namespace proofreel
