#include "engine/lcp.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>

#include "tests/engine/random.h"

using namespace proofreel;

namespace {

/// By how much z misses being a solution.
double error_of(const Lcp& problem, const std::vector<double>& z) {
  double worst = 0;
  for (int r = 0; r < problem.size; ++r) {
    double w = problem.q(r);
    for (int c = 0; c < problem.size; ++c) w += problem.m(r, c) * z[static_cast<std::size_t>(c)];
    worst = std::max({worst, -w, -z[static_cast<std::size_t>(r)], std::abs(w * z[static_cast<std::size_t>(r)])});
  }
  return worst;
}

/// B B^T of a random B with as many columns as its rank.
void fill_semidefinite(Lcp& problem, int rank, Random& random) {
  std::vector<double> b;
  for (int i = 0; i < problem.size * rank; ++i) b.push_back(random.between(-1, 1));
  for (int r = 0; r < problem.size; ++r) {
    for (int c = 0; c < problem.size; ++c) {
      problem.m(r, c) = 0;
      for (int k = 0; k < rank; ++k)
        problem.m(r, c) += b[static_cast<std::size_t>(r * rank + k)] * b[static_cast<std::size_t>(c * rank + k)];
    }
  }
}

}  // namespace

TEST_CASE("Lemke's method finds what presses and what parts", "[lcp]") {
  Lcp two(2);  // two boxes, one on the other: both press
  two.m(0, 0) = 1;
  two.m(0, 1) = two.m(1, 0) = -1;
  two.m(1, 1) = 2;
  two.q(0) = -1;
  two.q(1) = 0;
  const auto z = solve(two);
  REQUIRE(z);
  CHECK((*z)[0] == Approx(2));
  CHECK((*z)[1] == Approx(1));
}

TEST_CASE("Where nothing approaches nothing is solved", "[lcp]") {
  Lcp parting(3);
  for (int i = 0; i < 3; ++i) parting.q(i) = i;
  CHECK(solve(parting) == std::vector<double>{0, 0, 0});
  CHECK(solve(Lcp(0)) == std::vector<double>{});
}

TEST_CASE("Random problems of full and of lower rank are solved", "[lcp]") {
  Random random(1);
  for (int run = 0; run < 3000; ++run) {
    Lcp problem(1 + static_cast<int>(random.below(12)));
    const int rank = 1 + static_cast<int>(random.below(static_cast<std::uint32_t>(problem.size)));
    fill_semidefinite(problem, rank, random);
    // M x + q >= 0 for some x >= 0: then there is a solution.
    for (int r = 0; r < problem.size; ++r) problem.q(r) = random.between(0, 0.5);
    for (int c = 0; c < problem.size; ++c) {
      const double x = random.between(0, 1);
      for (int r = 0; r < problem.size; ++r) problem.q(r) -= problem.m(r, c) * x;
    }
    const auto z = solve(problem);
    INFO("run " << run << ", size " << problem.size << ", rank " << rank);
    REQUIRE(z);
    CHECK(error_of(problem, *z) < 1e-7);
  }
}

TEST_CASE("A positive definite problem has one solution, the one that trying all cases finds", "[lcp]") {
  Random random(2);
  for (int run = 0; run < 500; ++run) {
    Lcp problem(2);
    fill_semidefinite(problem, 2, random);
    problem.m(0, 0) += 0.1;
    problem.m(1, 1) += 0.1;
    problem.q(0) = random.between(-1, 1);
    problem.q(1) = random.between(-1, 1);
    const double a = problem.m(0, 0), b = problem.m(0, 1), d = problem.m(1, 1), p = problem.q(0), q = problem.q(1);
    const double det = a * d - b * b;
    const std::vector<std::vector<double>> cases = {
        {0, 0}, {-p / a, 0}, {0, -q / d}, {(-p * d + q * b) / det, (-q * a + p * b) / det}};
    const auto right =
        std::find_if(cases.begin(), cases.end(), [&](const auto& z) { return error_of(problem, z) < 1e-12; });
    REQUIRE(right != cases.end());
    const auto z = solve(problem);
    REQUIRE(z);
    CHECK((*z)[0] == Approx((*right)[0]).margin(1e-10));
    CHECK((*z)[1] == Approx((*right)[1]).margin(1e-10));
  }
}

TEST_CASE("What is squeezed by two walls that close in has no solution, and none is made up", "[lcp]") {
  Lcp squeezed(2);  // pushing one wall away pushes the body into the other one
  squeezed.m(0, 0) = squeezed.m(1, 1) = 1;
  squeezed.m(0, 1) = squeezed.m(1, 0) = -1;
  squeezed.q(0) = squeezed.q(1) = -1;
  CHECK_FALSE(solve(squeezed));
}
