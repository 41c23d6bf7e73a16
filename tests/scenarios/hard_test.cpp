/// The hard cases with the default method, and with a method or a scene that is broken on purpose: an expectation that
/// cannot fail is none.

#include <algorithm>
#include <catch2/catch.hpp>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "scenarios/runner.h"
#include "scene_text.h"

using namespace proofreel;

namespace {

/// Under which settings at least one of its expectations fails.
struct Broken {
  const char* name;
  std::vector<Override> settings;
};

const std::vector<Broken>& broken_cases() {
  static const std::vector<Broken> all = {
      {"arch", {{"contact_hz", "3"}}},
      {"arch_falls", {{"gravity", "{0,-0.001}"}}},
      {"arch_stands", {{"contact_hz", "3"}}},
      {"ball_and_chain", {{"joint_solver", "iterative"}}},
      {"bouncing_balls", {{"effects", "{\"gravity\",\"contacts\",\"friction\"}"}}},
      {"bullet", {{"effects", "{\"contacts\"}"}}},
      {"card_house", {{"contact_hz", "3"}}},
      {"column", {{"contact_hz", "3"}}},
      {"confined_discs", {{"contact_solver", "sequential_impulses"}}},
      {"crank", {{"joint_solver", "iterative"}}},
      {"dominoes", {{"contact_hz", "3"}}},
      {"doubling_boxes", {{"contact_hz", "3"}}},
      {"drag_stack", {{"contact_hz", "3"}}},
      {"elastic_ball", {{"integrator", "symplectic_euler"}}},
      {"elastic_box_on_rim", {{"integrator", "symplectic_euler"}}},
      {"far_from_origin", {{"precision", "single"}}},
      {"far_pyramid", {{"contact_hz", "3"}}},
      {"fast_disc", {{"effects", "{\"contacts\"}"}}},
      {"flat_landing", {{"contact_solver", "ngs"}}},
      {"free_fall", {{"integrator", "symplectic_euler"}}},
      {"friction_ramp", {{"contact_hz", "3"}}},
      {"galperin", {{"contact_solver", "soft_step"}}},
      {"heavy_chain", {{"joint_solver", "iterative"}}},
      {"heavy_on_triangles", {{"contact_hz", "3"}}},
      {"heavy_on_two", {{"contact_hz", "3"}}},
      {"heavy_rope", {{"joint_solver", "iterative"}}},
      {"incline_slides", {{"effects", "{\"gravity\",\"contacts\",\"ccd\"}"}}},
      {"incline_stands", {{"contact_hz", "3"}}},
      {"joint_net", {{"joint_solver", "iterative"}, {"substeps", "1"}}},
      {"large_pyramid", {{"contact_hz", "3"}}},
      {"light_wheels", {{"contact_solver", "ngs"}}},
      {"load_removed", {{"contact_hz", "15"}}},
      {"long_pendulum", {{"integrator", "symplectic_euler"}}},
      {"overhang_falls", {{"gravity", "{0,-0.001}"}}},
      {"overhang_stands", {{"contact_hz", "3"}}},
      {"overlapped_pyramid", {{"contact_hz", "3"}}},
      {"overlapped_pyramid_10", {{"contact_hz", "3"}}},
      {"overstretched_chain", {{"joint_solver", "iterative"}, {"substeps", "1"}}},
      {"painleve", {{"contact_hz", "3"}}},
      {"plate_friction", {{"contact_hz", "3"}}},
      {"ragdoll_on_stairs", {{"contact_hz", "3"}}},
      {"rolling_on_seams", {{"contact_hz", "3"}}},
      {"seams", {{"contact_hz", "3"}}},
      {"singular_double_pendulum", {{"substeps", "1"}}},
      {"skinny_plank", {{"contact_solver", "ngs"}}},
      {"sleep_and_nudge", {{"contact_hz", "2"}}},
      {"sliver", {{"contact_hz", "3"}}},
      {"spinner", {{"effects", "{\"contacts\"}"}}},
      {"stack", {{"contact_hz", "3"}}},
      {"stiff_prismatics", {{"joint_solver", "iterative"}}},
      {"struck_into_wall", {{"contact_solver", "ngs"}}},
      {"tall_column", {{"contact_hz", "3"}}},
      {"tilted_box_falls", {{"gravity", "{0,-0.001}"}}},
      {"tilted_box_stands", {{"contact_hz", "3"}}},
      {"tiny_hulls", {{"contact_hz", "3"}}},
      {"tiny_pyramid", {{"contact_hz", "3"}}},
      {"topped_pyramid_100", {{"contact_hz", "3"}}},
      {"topped_pyramid_200", {{"contact_hz", "3"}}},
      {"topped_pyramid_300", {{"contact_hz", "3"}}},
      {"wide_ground", {{"contact_hz", "3"}}},
      {"zeno", {{"contact_solver", "soft_step"}}},
  };
  return all;
}

/// What is too dear to be run to its end every time: soft contacts (`contact_solver=soft_step`) fail before this one.
std::vector<Override> shortened(const std::string& name, std::vector<Override> settings) {
  if (name == "large_pyramid") settings.push_back({"duration", "0.5"});
  return settings;
}

std::vector<std::string> names_in(const std::string& folder) {
  std::vector<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    if (entry.path().extension() == ".lua") names.push_back(entry.path().stem().string());
  }
  std::sort(names.begin(), names.end());
  return names;
}

/// The first expectation that does not hold, or why the run stopped; empty when all is well.
std::string failure_in(const std::string& path, const std::vector<Override>& settings) {
  const auto scenario = load_scenario(path, settings);
  const RunReport report = Runner(*scenario).finish();
  for (const ExpectationResult& expectation : report.expectations) {
    if (expectation.failed()) return expectation.text;
  }
  return report.failure ? report.failure->stage : std::string();
}

std::string text_of(const std::string& path) {
  std::ifstream file(path);
  return {std::istreambuf_iterator<char>(file), {}};
}

}  // namespace

TEST_CASE("Every hard case is there to be broken") {
  std::vector<std::string> known;
  for (const Broken& broken : broken_cases()) known.emplace_back(broken.name);
  CHECK(names_in("scenarios/hard") == known);
}

TEST_CASE("Every hard case holds with the default method") {
  for (const std::string& name : names_in("scenarios/hard")) {
    INFO(name);
    CHECK(failure_in("scenarios/hard/" + name + ".lua", shortened(name, {})) == "");
  }
}

TEST_CASE("Every hard case fails where something is broken") {
  for (const Broken& broken : broken_cases()) {
    INFO(broken.name);
    CHECK(failure_in(std::string("scenarios/hard/") + broken.name + ".lua", shortened(broken.name, broken.settings)) !=
          "");
  }
}

TEST_CASE("What is beyond the default method is no hard case that it holds: those move to the others") {
  for (const std::string& name : names_in("scenarios/beyond")) {
    INFO(name);
    CHECK(failure_in("scenarios/beyond/" + name + ".lua", {}) != "");
  }
}

TEST_CASE("Both folders have the same gates") {
  const std::string beyond = text_of("scenarios/beyond/include/gates.lua");
  CHECK(beyond.substr(beyond.find('\n') + 1) == text_of("scenarios/hard/include/gates.lua"));
}
