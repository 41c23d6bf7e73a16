#include "lab/study_analysis.h"

#include <catch2/catch.hpp>
#include <cmath>

#include "tests/lab/study_scenes.h"

namespace proofreel {
namespace {

using namespace test;
using Catch::Matchers::Contains;
using Catch::Matchers::StartsWith;
using Numbers = std::vector<std::optional<double>>;

/// Errors of the given order at steps that halve, from 1 s on.
struct Series {
  std::vector<double> steps_s;
  Numbers errors;
};

Series series(double order, int count, double scale = 0.1) {
  Series s;
  for (int i = 0; i < count; ++i) {
    s.steps_s.push_back(std::pow(0.5, i));
    s.errors.push_back(scale * std::pow(s.steps_s.back(), order));
  }
  return s;
}

TEST_CASE("The fitted order is the order of the errors", "[study]") {
  for (const double order : {1.0, 2.0, 4.0, 6.0}) {
    const Series s = series(order, 6);
    const auto fitted = fitted_order(s.steps_s, s.errors);
    REQUIRE(fitted);
    REQUIRE(fitted->order == Approx(order));
    REQUIRE(fitted->last == 5);
  }
}

TEST_CASE("An order is fitted before rounding spoils it, and after the coarse steps", "[study]") {
  Series s = series(4, 8);
  s.errors[0] = 0.09;  // not yet in the asymptotic range
  s.errors[6] = 1e-6;  // the floor
  s.errors[7] = 2e-6;
  const auto fitted = fitted_order(s.steps_s, s.errors);
  REQUIRE(fitted);
  REQUIRE(fitted->order == Approx(4));
  REQUIRE(fitted->last == 5);
}

TEST_CASE("What jumps about, stands still or has lost its way has no order", "[study]") {
  const std::vector<double> steps{1, 0.5, 0.25, 0.125};
  REQUIRE_FALSE(fitted_order(steps, {0.1, 0.02, 0.03, 0.001}));
  REQUIRE_FALSE(fitted_order(steps, {0.1, 0.1, 0.1, 0.1}));
  REQUIRE_FALSE(fitted_order(steps, {8.0, 4.0, 2.0, 1.0}));
  REQUIRE_FALSE(fitted_order({1, 0.5}, {0.1, 0.05}));
  REQUIRE_FALSE(fitted_order(steps, {0.1, std::nullopt, 0.02, std::nullopt}));
}

TEST_CASE("A floor is where smaller steps no longer help", "[study]") {
  REQUIRE(error_floor({1e-2, 1e-4, 1e-6, 3e-6, 8e-6}) == std::optional(1e-6));
  REQUIRE(error_floor({1e-2, 1e-4, 1e-6, 0.95e-6}) == std::optional(0.95e-6));
  REQUIRE_FALSE(error_floor({1e-2, 1e-4, 1e-6, 1e-8}));
  REQUIRE_FALSE(error_floor({1.0, 0.9, 1.1, 0.95}));
  REQUIRE_FALSE(error_floor({}));
}

TEST_CASE("On the Pareto front is whom nobody beats in both", "[study]") {
  // By brute force, over seeded points.
  std::uint32_t seed = 7;
  const auto next = [&seed] {
    seed = seed * 1664525U + 1013904223U;
    return static_cast<double>(seed >> 24U);
  };
  Numbers work;
  Numbers errors;
  for (int i = 0; i < 200; ++i) {
    work.emplace_back(next());
    errors.emplace_back(next());
  }
  work[3] = std::nullopt;
  errors[4] = std::nullopt;
  errors[5] = NAN;
  const std::vector<bool> front = pareto_front(work, errors);
  const auto is_known = [&](std::size_t i) { return work[i] && errors[i] && !std::isnan(*errors[i]); };
  for (std::size_t i = 0; i < work.size(); ++i) {
    bool beaten = !is_known(i);
    for (std::size_t k = 0; k < work.size() && !beaten; ++k) {
      if (k == i || !is_known(k)) continue;
      const bool as_good = *work[k] <= *work[i] && *errors[k] <= *errors[i];
      const bool better = *work[k] < *work[i] || *errors[k] < *errors[i];
      beaten = as_good && (better || k < i);
    }
    INFO(i);
    REQUIRE(front[i] == !beaten);
  }
}

TEST_CASE("The verdict names the cheapest method for the error, and what the others need", "[study]") {
  const Study study = study_of({"verlet", "rk4", "euler"}, 4);
  std::vector<StudyResult> results;
  for (const double order : {2.0, 4.0, 0.0}) {
    for (int i = 0; i < 4; ++i)
      results.push_back(result_of(0.5 * std::pow(0.1, order * i), (order + 1) * std::pow(2, i)));
  }
  REQUIRE(verdict_for(study, results, 1e-4) ==
          "For an error of 1e-4, rk4 at rate 120 is the cheapest: 10 ms per simulated second; verlet needs 1.2 times "
          "that; euler does not reach it.");
  Study unknown = study;
  unknown.measures.front().has_reference = false;
  REQUIRE_THAT(verdict_for(unknown, results, 1e-4),
               StartsWith("For a difference of 1e-4 from itself at a far smaller step, rk4 at rate 120"));
  REQUIRE(verdict_for(study, results, 1e-20).empty());
  REQUIRE_THAT(verdict_of(study, results), Contains("For an error of 1e-"));
  REQUIRE(verdict_of(study, {}).empty());
}

TEST_CASE("Targets worth asking for are reached by somebody and missed by somebody", "[study]") {
  REQUIRE(worthwhile_targets({result_of(0.05, 1), result_of(3e-4, 2)}) == std::vector<double>{1e-2, 1e-3});
  REQUIRE(worthwhile_targets({result_of(0.05, 1)}).empty());
}

TEST_CASE("Work is counted per simulated second, and not made up where it is not known", "[study]") {
  StudyResult result = result_of(1e-3, 5);
  result.simulated_s = 10;
  result.cpu_s = 0.02;
  REQUIRE(work_of(result, WorkAxis::cpu) == std::optional(2.0));
  REQUIRE_FALSE(work_of(result, WorkAxis::updates));
  REQUIRE_FALSE(work_of(result, WorkAxis::instructions));
  result.row_updates = 100;
  result.evaluations = 50;
  result.instructions = 4000;
  REQUIRE(work_of(result, WorkAxis::updates) == std::optional(15.0));
  REQUIRE(work_of(result, WorkAxis::instructions) == std::optional(400.0));
}

TEST_CASE("Powers of ten are written as such", "[study]") {
  REQUIRE(power_text(1) == "1");
  REQUIRE(power_text(1e-4) == "1e-4");
  REQUIRE(power_text(0.1) == "1e-1");
  REQUIRE(power_text(2.5e-7) == "2.5e-07");
}

}  // namespace
}  // namespace proofreel
