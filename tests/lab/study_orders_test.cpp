// The orders of convergence that numerical analysis promises, found by studies of the reference problems.

#include <catch2/catch.hpp>
#include <cmath>

#include "lab/study.h"
#include "lab/study_analysis.h"
#include "lab/study_run.h"

namespace proofreel {
namespace {

struct Case {
  std::string integrator;
  std::string rates;
  double order = 0;
};

/// The order of a study of one method over some rates, without its times.
std::optional<FittedOrder> order_of(const std::string& scenario, const Case& each, const std::string& measure,
                                    const std::vector<Override>& set) {
  StudyRequest request{"scenarios/reference/" + scenario + ".lua", set, {}, {}, {measure}};
  request.axes = parse_axes({"integrator=" + each.integrator, "rate=" + each.rates});
  const Study study = plan_study(request);
  std::vector<double> steps;
  std::vector<std::optional<double>> errors;
  for (const StudyRun& run : study.runs) {
    const Trace trace = trace_of(study, run, 60);
    steps.push_back(run.step_s);
    errors.push_back(trace.status == RunStatus::ended ? error_of(trace.values[0], trace.expected[0]) : std::nullopt);
  }
  return fitted_order(steps, errors);
}

void require_orders(const std::string& scenario, const std::vector<Case>& cases, const std::string& measure,
                    const std::vector<Override>& set) {
  for (const Case& each : cases) {
    INFO(scenario << " by " << each.integrator);
    const auto fitted = order_of(scenario, each, measure, set);
    REQUIRE(fitted);
    REQUIRE(std::abs(fitted->order - each.order) <= 0.15);
  }
}

TEST_CASE("On a mass on a spring every integrator has its order", "[study_orders]") {
  require_orders("mass_on_spring",
                 {{"symplectic_euler", "3840,7680,15360", 1},
                  {"verlet", "240,480,960", 2},
                  {"implicit_midpoint", "240,480,960", 2},
                  {"rk4", "120,240,480", 4},
                  {"suzuki4", "120,240,480", 4},
                  {"gauss_legendre6", "30,60,120", 6}},
                 "x", {{"duration", "10"}, {"substeps", "1"}});
}

TEST_CASE("On Kepler's ellipse every integrator has its order", "[study_orders]") {
  require_orders("kepler",
                 {{"symplectic_euler", "30720,61440,122880", 1},
                  {"verlet", "480,960,1920", 2},
                  {"implicit_midpoint", "480,960,1920", 2},
                  {"rk4", "240,480,960", 4},
                  {"suzuki4", "120,240,480", 4},
                  {"gauss_legendre6", "40,80,160", 6}},
                 "x", {{"duration", "10"}, {"substeps", "1"}});
}

TEST_CASE("With joints those that take them have their order", "[study_orders]") {
  const std::vector<Override> set{{"duration", "5"}, {"substeps", "1"}};
  const std::vector<Case> cases{
      {"symplectic_euler", "3840,7680,15360", 1}, {"verlet", "480,960,1920", 2}, {"suzuki4", "240,480,960", 4}};
  require_orders("pendulum_60", cases, "x", set);
  require_orders("double_pendulum", cases, "tip x", set);
  require_orders("rod_pendulum", cases, "angle", set);
}

TEST_CASE("A bouncing ball is exact where impacts are located, and a staircase without an order where they are not",
          "[study_orders]") {
  StudyRequest request{
      "scenarios/reference/elastic_ball.lua", {{"duration", "5"}}, {}, {Peer::box2d, Peer::chipmunk}, {"gap"}};
  request.axes = parse_axes({"contact_solver=event", "rate=60,120,240,480,960"});
  const Study study = plan_study(request);
  for (std::size_t method = 0; method < study.methods.size(); ++method) {
    std::vector<double> steps;
    std::vector<std::optional<double>> errors;
    const auto [first, last] = runs_of(study, method);
    for (std::size_t i = first; i < last; ++i) {
      const Trace trace = trace_of(study, study.runs[i], 60);
      steps.push_back(study.runs[i].step_s);
      errors.push_back(error_of(trace.values[0], trace.expected[0]));
      INFO(study.methods[method].name);
      // Between impacts verlet is exact: what is left is how well an impact is located.
      REQUIRE((*errors.back() < 1e-8) == (method == 0));
    }
    REQUIRE_FALSE(fitted_order(steps, errors));
  }
}

TEST_CASE("Single precision has a floor, from which smaller steps lead up again", "[study_orders]") {
  const auto floor_in = [](const char* precision) {
    StudyRequest request{
        "scenarios/reference/pendulum_by_angle.lua", {{"substeps", "1"}, {"precision", precision}}, {}, {}, {"angle"}};
    request.axes = parse_axes({"integrator=verlet", "rate=60,240,960,3840,15360,61440"});
    const Study study = plan_study(request);
    std::vector<std::optional<double>> errors;
    for (const StudyRun& run : study.runs) {
      const Trace trace = trace_of(study, run, 60);
      errors.push_back(error_of(trace.values[0], trace.expected[0]));
    }
    return error_floor(errors);
  };
  REQUIRE_FALSE(floor_in("double"));
  const auto floor = floor_in("single");
  REQUIRE(floor);
  REQUIRE(*floor > 1e-8);
  REQUIRE(*floor < 1e-3);
}

}  // namespace
}  // namespace proofreel
