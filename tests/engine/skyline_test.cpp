#include "engine/skyline.h"

#include <catch2/catch.hpp>

#include "tests/engine/random.h"
#include "tests/engine/scenes.h"

using namespace proofreel;
using namespace proofreel::test;

TEST_CASE("A factored system solves to the vector it was made from", "[skyline]") {
  Random random(3);
  for (int round = 0; round < 50; ++round) {
    const int n = 1 + static_cast<int>(random.below(40));
    std::vector<int> first;
    for (int r = 0; r < n; ++r) first.push_back(std::max(0, r - static_cast<int>(random.below(6))));
    SkylineMatrix matrix;
    matrix.reset(first);
    std::vector<std::vector<real>> dense(static_cast<std::size_t>(n),
                                         std::vector<real>(static_cast<std::size_t>(n), 0));
    const auto entry = [&](int r, int c) -> real& {
      return dense[static_cast<std::size_t>(r)][static_cast<std::size_t>(c)];
    };
    for (int r = 0; r < n; ++r) {
      for (int c = first[static_cast<std::size_t>(r)]; c <= r; ++c) {
        const auto x = static_cast<real>(r == c ? 20 + random.between(0, 5) : random.between(-1, 1));
        entry(r, c) = entry(c, r) = x;
        matrix.at(r, c) = x;
      }
    }
    std::vector<real> truth;
    for (int r = 0; r < n; ++r) truth.push_back(static_cast<real>(random.between(-3, 3)));
    std::vector<real> right(static_cast<std::size_t>(n), 0);
    for (int r = 0; r < n; ++r) {
      for (int c = 0; c < n; ++c)
        right[static_cast<std::size_t>(r)] += entry(r, c) * truth[static_cast<std::size_t>(c)];
    }
    matrix.factor();
    matrix.solve(right);
    for (std::size_t r = 0; r < right.size(); ++r) REQUIRE(right[r] == Approx(truth[r]).margin(pick(1e-13, 1e-5)));
  }
}

TEST_CASE("A row that repeats another one is dropped, not divided by", "[skyline]") {
  SkylineMatrix matrix;
  matrix.reset({0, 0});
  matrix.at(0, 0) = 2;
  matrix.at(1, 0) = 2;
  matrix.at(1, 1) = 2;
  matrix.factor();
  std::vector<real> x{4, 4};
  matrix.solve(x);
  CHECK(x[0] == Approx(2));
  CHECK(x[1] == 0);
}

TEST_CASE("A system without rows has nothing to solve", "[skyline]") {
  SkylineMatrix matrix;
  matrix.reset({});
  matrix.factor();
  std::vector<real> x;
  matrix.solve(x);
  CHECK(x.empty());
}
