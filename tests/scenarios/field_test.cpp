// Water and force fields, as a scenario writes them.

#include <catch2/catch.hpp>

#include "scene_text.h"

using namespace proofreel;
using Catch::Contains;

namespace {

const std::string disc =
    "scenario{duration=0.5, gravity={0,0}}\nlocal b = body{name='b', mass=2, shape=circle{radius=1}}\n";

/// What running the text in the engine says is wrong.
std::string error_in_run(const std::string& text) {
  const auto scenario = load_text(text);
  try {
    Runner(*scenario).finish();
  } catch (const ScenarioError& error) {
    return error.what();
  }
  return {};
}

double final_value(const std::string& text, const std::string& expression) {
  const auto scenario = load_text(text + "\nmeasure('value', function() return " + expression + " end)");
  return Runner(*scenario).finish().measures[0].final;
}

}  // namespace

TEST_CASE("Water becomes part of the scene") {
  const auto scenario = load_text("scenario{}\nbuoyancy{level=2, density=1000, drag=30}");
  REQUIRE(scenario->scene.water.has_value());
  CHECK(scenario->scene.water->level == 2);
  CHECK(scenario->scene.water->density == 1000);
  CHECK(scenario->scene.water->drag == 30);
}

TEST_CASE("Water that makes no sense is refused with what to do") {
  const auto [text, reason] = GENERATE(table<std::string, std::string>({
      {"scenario{}\nbuoyancy{density=1}", "level"},
      {"scenario{}\nbuoyancy{level=0}", "density"},
      {"scenario{}\nbuoyancy{level=0, density=0}", "density"},
      {"scenario{}\nbuoyancy{level=0, density=2e9}", "density must not exceed 1e9"},
      {"scenario{}\nbuoyancy{level=0, density=1, drag=-1}", "drag"},
      {"scenario{}\nbuoyancy{level=0, density=1, darg=1}", "did you mean \"drag\"?"},
      {"scenario{gravity={1, -9}}\nbuoyancy{level=0, density=1}", "gravity must point straight down"},
      {"scenario{gravity={0, 9}}\nbuoyancy{level=0, density=1}", "gravity must point straight down"},
      {"local first = 1\nbuoyancy{level=0, density=1}", "call scenario{...} first"},
      {"scenario{}\nbuoyancy{level=0, density=1} buoyancy{level=1, density=1}", "was given already"},
  }));
  INFO(text);
  CHECK_THAT(error_of(text), Contains("line 2: ") && Contains(reason));
}

TEST_CASE("A field pushes with what its function returns") {
  CHECK(final_value(disc + "field(function() return 4, -2 end)", "b:velocity().x") == Approx(1));
  CHECK(final_value(disc + "field(function() return 4, -2 end)", "b:velocity().y") == Approx(-0.5));
}

TEST_CASE("A field is told place, velocity and time") {
  const std::string keep = disc +
                           "b:set{at={3, 5}, velocity={7, 9}, gravity_scale=0}\nlocal seen\n"
                           "field(function(x, y, vx, vy, t) seen = seen or {x, y, vx, vy, t} return 0, 0 end)\n";
  const double expected[] = {3, 5, 7, 9, 0};
  for (int i = 0; i < 5; ++i) {
    const std::string item = "(seen and seen[" + std::to_string(i + 1) + "] or -1)";
    CHECK(final_value(keep, item) == expected[i]);
  }
  CHECK(final_value(disc + "local last = 0\nfield(function(x, y, vx, vy, t) last = t return 0, 0 end)", "last") == 0.5);
}

TEST_CASE("Two fields add up") {
  CHECK(final_value(disc + "field(function() return 4, 0 end) field(function() return 8, 0 end)", "b:velocity().x") ==
        Approx(3));
}

TEST_CASE("An error in a field names its line") {
  CHECK_THAT(error_in_run(disc + "field(function()\n  return nothing.at_all, 0\nend)"),
             Contains("scene.lua: line 4: ") && Contains("nothing") && Contains("in a force field"));
}

TEST_CASE("What a field returns must be two finite numbers") {
  const auto [value, shown] = GENERATE(table<std::string, std::string>({
      {"0/0, 1", "nan and 1"},
      {"1, 1/0", "1 and inf"},
      {"1", "1 and nothing"},
      {"'a', 2", "\"a\" and 2"},
      {"{1, 2}", "a table and nothing"},
  }));
  const std::string error = error_in_run(disc + "field(function() return " + value + " end)");
  INFO(error);
  CHECK_THAT(error, Contains("scene.lua: line 3: ") && Contains("must return two finite numbers, fx and fy, got"));
  CHECK_THAT(error, Contains(shown));
}

TEST_CASE("A field may only look, and a field that does not end is stopped") {
  CHECK_THAT(error_in_run(disc + "field(function() b:impulse{1, 0} return 0, 0 end)"), Contains("may only look"));
  CHECK_THAT(error_in_run(disc + "field(function() return math.random(), 0 end)"), Contains("may only look"));
  CHECK_THAT(error_in_run(disc + "field(function() while true do end end)"), Contains("does a loop not end?"));
}

TEST_CASE("A field is a function, given at the top of the file") {
  CHECK_THAT(error_of("scenario{}\nfield{1, 2}"), Contains("line 2: field(fn): fn"));
  CHECK_THAT(error_of("scenario{duration=1}\nlocal b = body{shape=circle{radius=1}}\n"
                      "at(0.5, function() field(function() return 0, 0 end) end)"),
             Contains("line 3: field"));
}

TEST_CASE("The work of a field is counted, so that energy does not drift") {
  const auto scenario = load_text(disc + "b:set{velocity={1, 0}}\nfield(function(x, y) return -y, x + 3 end)");
  const RunReport report = Runner(*scenario).finish();
  CHECK(report.final_energy.kinetic > 1.2);
  CHECK(report.max_energy_drift < 1e-4);
}

TEST_CASE("A list that omits water or a field is warned of, and neither acts") {
  const auto scenario = load_text(
      "scenario{effects={'gravity'}, duration=1}\nlocal b = body{shape=circle{radius=1}}\n"
      "buoyancy{level=10, density=5} field(function() error('asked') end)\n"
      "measure('v', function() return b:velocity().y end)");
  REQUIRE(scenario->warnings.size() == 2);
  CHECK_THAT(scenario->warnings[0], Contains("\"buoyancy\""));
  CHECK_THAT(scenario->warnings[1], Contains("\"field\""));
  CHECK(Runner(*scenario).finish().measures[0].final == Approx(-9.81));
}
