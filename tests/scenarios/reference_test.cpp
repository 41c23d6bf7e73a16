/// The reference problems with the default method of each, and with a method that is worse: an expectation that cannot
/// fail is none, and a problem without reference values is no reference problem.

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <filesystem>

#include "scenarios/runner.h"
#include "scene_text.h"

using namespace proofreel;

namespace {

/// Under which setting at least one of its expectations fails.
struct Worse {
  std::string name;
  Override setting;
};

const std::vector<Worse>& worse_methods() {
  static const Override late{"contact_solver", "soft_step"};
  static const Override soft{"contact_hz", "3"};
  static const Override first_order{"integrator", "symplectic_euler"};
  static const Override swept{"joint_solver", "iterative"};
  static const Override coarse{"precision", "single"};
  static const Override long_steps{"substeps", "1"};  // symplectic Euler is conjugate to verlet, and no worse for long
  static const std::vector<Worse> all = {
      {"arch_threshold", soft},
      {"billiard", coarse},
      {"capstan", late},
      {"counting_pi", late},
      {"counting_pi_31415", late},
      {"double_pendulum", first_order},
      {"double_pendulum_by_angles", first_order},
      {"elastic_ball", coarse},
      {"four_bars", swept},
      {"hanging_chain", swept},
      {"incline_holds", soft},
      {"incline_slides", first_order},
      {"incline_threshold", soft},
      {"kepler", long_steps},
      {"mass_on_spring", first_order},
      {"newtons_cradle", coarse},
      {"overhang_threshold", soft},
      {"painleve_threshold", late},
      {"pendulum_179", first_order},
      {"pendulum_60", first_order},
      {"pendulum_90", first_order},
      {"pendulum_by_angle", first_order},
      {"projectile", first_order},
      {"rocking_block", late},
      {"rod_pendulum", first_order},
      {"slider_crank", swept},
      {"sliding_stop", first_order},
      {"squeezer", first_order},
      {"stack_of_fifteen", soft},
      {"zeno_ball", late},
  };
  return all;
}

std::string path_of(const Worse& problem) { return "scenarios/reference/" + problem.name + ".lua"; }

/// The first expectation that does not hold, or why the run stopped; empty when all is well.
std::string failure_in(const RunReport& report) {
  for (const ExpectationResult& expectation : report.expectations) {
    if (expectation.failed()) return expectation.text;
  }
  return report.failure ? report.failure->stage : std::string();
}

RunReport run(const std::string& path, const std::vector<Override>& settings) {
  const auto scenario = load_scenario(path, settings);
  return Runner(*scenario).finish();
}

/// The error of the first measure at 60 ticks per second.
double first_error(const std::string& name, const char* integrator, const char* substeps) {
  const RunReport report =
      run("scenarios/reference/" + name + ".lua", {{"rate", "60"}, {"integrator", integrator}, {"substeps", substeps}});
  return report.measures[0].max_error.value();
}

}  // namespace

TEST_CASE("Every reference problem is there to be solved worse") {
  std::vector<std::string> paths;
  for (const auto& entry : std::filesystem::directory_iterator("scenarios/reference")) {
    if (entry.path().extension() == ".lua") paths.push_back(entry.path().generic_string());
  }
  std::sort(paths.begin(), paths.end());
  std::vector<std::string> known;
  for (const Worse& problem : worse_methods()) known.push_back(path_of(problem));
  CHECK(paths == known);
}

TEST_CASE("Every reference problem compares something, and is solved as well as it expects") {
  for (const Worse& problem : worse_methods()) {
    INFO(problem.name);
    const RunReport report = run(path_of(problem), {});
    CHECK(failure_in(report) == "");
    CHECK(std::any_of(report.measures.begin(), report.measures.end(), [](const auto& m) { return m.max_error; }));
  }
}

TEST_CASE("Every reference problem shows a worse method") {
  for (const Worse& problem : worse_methods()) {
    INFO(problem.name);
    CHECK(failure_in(run(path_of(problem), {problem.setting})) != "");
  }
}

/// At 60 degrees: from 90 the angle of a drift-kick-drift verlet converges by the fourth order, from there only.
TEST_CASE("On the large pendulum every integrator converges by its order, with a rod and by its angle") {
  struct Order {
    const char* name;
    const char* integrator;
    double order;
  };
  const Order tried =
      GENERATE(Order{"pendulum_60", "symplectic_euler", 1}, Order{"pendulum_60", "verlet", 2},
               Order{"pendulum_60", "suzuki4", 4}, Order{"pendulum_by_angle", "symplectic_euler", 1},
               Order{"pendulum_by_angle", "verlet", 2}, Order{"pendulum_by_angle", "implicit_midpoint", 2},
               Order{"pendulum_by_angle", "rk4", 4}, Order{"pendulum_by_angle", "gauss_legendre6", 6});
  INFO(tried.name << ", " << tried.integrator);
  const double measured =
      std::log2(first_error(tried.name, tried.integrator, "1") / first_error(tried.name, tried.integrator, "2"));
  CHECK(std::abs(measured - tried.order) <= 0.2);
}
