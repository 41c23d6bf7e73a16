#include <catch2/catch.hpp>

#include "golden/json.h"
#include "tests/cli/collection.h"

namespace proofreel {
namespace {

using Catch::Matchers::Contains;

Json stage_of(const Json& explanation, const std::string& name) {
  for (const Json& stage : explanation.at("stages")) {
    if (stage.at("name") == name) return stage;
  }
  FAIL("no stage " << name);
  return {};
}

TEST_CASE("A pendulum calls for no broad phase, no contacts and no friction, and says why", "[cli]") {
  const Outcome o = proofreel_program({"explain", "pendulum", "--set", "duration=1", "--json"});
  REQUIRE(o.status == 0);
  const Json explanation = Json::parse(o.out);
  for (const char* name : {"broad_phase", "narrow_phase", "contacts", "friction", "restitution", "ccd"}) {
    const Json stage = stage_of(explanation, name);
    CAPTURE(name);
    REQUIRE(stage.at("on") == false);
    REQUIRE(stage.at("why") == "no two bodies can meet");
    REQUIRE(stage.at("us_per_tick").is_null());
  }
  const Json joints = stage_of(explanation, "joints");
  REQUIRE(joints.at("on") == true);
  REQUIRE(joints.at("why") == "there is a rigid joint");
  REQUIRE(joints.at("us_per_tick").get<double>() > 0);
}

TEST_CASE("The stages' costs add up to that of the tick", "[cli]") {
  const Outcome o = proofreel_program({"explain", "pyramid", "--set", "duration=0.2", "--json"});
  const Json explanation = Json::parse(o.out);
  double sum = 0;
  for (const Json& stage : explanation.at("stages")) {
    if (stage.at("us_per_tick").is_number()) sum += stage.at("us_per_tick").get<double>();
  }
  REQUIRE(sum == Approx(explanation.at("us_per_tick").get<double>()));
  REQUIRE(explanation.at("ticks") == 48);
  REQUIRE(stage_of(explanation, "friction").at("part_of") == "contacts");
}

TEST_CASE("What a script adds while it runs is explained too", "[cli]") {
  const Collection c;
  c.write("late",
          "scenario{duration=1}\nbody{shape=circle{radius=1}}\n"
          "at(0.5, function() body{at={0,5}, shape=circle{radius=1}, restitution=0.5} end)");
  const Outcome o = c.run({"explain", "late"});
  REQUIRE(o.status == 0);
  REQUIRE_THAT(o.out, Contains("restitution         on") && Contains("bodies can meet, and a shape has restitution"));
}

TEST_CASE("A list of effects that overrules the scene is said to", "[cli]") {
  const Collection c;
  c.write("listed", "scenario{duration=0.1, effects={'drag'}}\nbody{shape=circle{radius=1}}");
  const Json explanation = Json::parse(c.run({"explain", "listed", "--json"}).out);
  REQUIRE(stage_of(explanation, "drag").at("why") == "the list of effects names it, though no drag is given");
  REQUIRE(stage_of(explanation, "gravity").at("why") == "the list of effects omits it, though gravity is not zero");
}

TEST_CASE("Explaining has an example, and refuses what it does not know", "[cli]") {
  REQUIRE_THAT(proofreel_program({"explain", "--help"}).out, Contains("Example: proofreel explain"));
  REQUIRE(proofreel_program({"explain", "nowhere"}).status == 2);
}

TEST_CASE("Instructions are counted alike in every run, and more for turning bodies than for falling ones", "[cli]") {
  const Collection c;
  const std::string discs = "for i = 1, 50 do body{at={3 * i, 0}, group=-1, spin=SPIN, shape=circle{radius=1}} end";
  const auto with_spin = [&](const std::string& spin) {
    const std::string file = "spin" + spin;
    std::string text = "scenario{duration=0.5}\n" + discs;
    c.write(file, text.replace(text.find("SPIN"), 4, spin));
    const Outcome o = c.run({"explain", file, "--instructions", "--json"});
    REQUIRE(o.status == 0);
    return Json::parse(o.out).at("instructions_per_body_step").get<double>();
  };
  const double falling = with_spin("0");
  REQUIRE(falling > 5);
  REQUIRE(falling == with_spin("0"));
  REQUIRE(with_spin("1") > falling + 5);
}

TEST_CASE("Where bodies are free, gravity's time is part of the motion", "[cli]") {
  const Collection c;
  c.write("free", "scenario{duration=0.1}\nbody{shape=circle{radius=1}}");
  const Json explanation = Json::parse(c.run({"explain", "free", "--json"}).out);
  REQUIRE(stage_of(explanation, "gravity").at("on") == true);
  REQUIRE(stage_of(explanation, "gravity").at("part_of") == "motion");
}

}  // namespace
}  // namespace proofreel
