#include <catch2/catch.hpp>

#include "scene_text.h"

using namespace proofreel;
using Catch::Contains;

namespace {

const std::string preamble = "scenario{}\n";

const ShapeDef& shape_of(const Scene& scene, std::size_t body, std::size_t shape = 0) {
  return scene.bodies[body].shapes[shape];
}

}  // namespace

TEST_CASE("A body's rolling resistance and surface speed are those of its shapes, unless these have their own") {
  const auto scenario = load_text(preamble +
                                  "body{rolling_resistance=0.01, surface_speed=-2, shapes={circle{radius=1},"
                                  "box{width=1, height=1, at={3, 0}, rolling_resistance=0.5, surface_speed=4}}}");
  const Scene& scene = scenario->scene;
  CHECK(shape_of(scene, 0, 0).rolling_resistance == 0.01);
  CHECK(shape_of(scene, 0, 0).surface_speed == -2);
  CHECK(shape_of(scene, 0, 1).rolling_resistance == 0.5);
  CHECK(shape_of(scene, 0, 1).surface_speed == 4);
}

TEST_CASE("Every shape, the ground and walls take rolling resistance and surface speed") {
  const std::string shape = GENERATE("circle{radius=1, ", "box{width=1, height=1, ", "polygon{{0,0},{1,0},{0,1}, ",
                                     "hull{{0,0},{1,0},{0,1}, ", "regular{sides=5, radius=1, ",
                                     "capsule{a={0,0}, b={1,0}, radius=1, ", "segment{a={0,0}, b={1,0}, ");
  const auto scenario =
      load_text(preamble + "body{type='static', shape=" + shape + "rolling_resistance=0.1, surface_speed=3}}\n" +
                "ground{rolling_resistance=0.2, surface_speed=4}\n" +
                "wall{a={0,0}, b={1,1}, rolling_resistance=0.3, surface_speed=5}");
  CHECK(shape_of(scenario->scene, 0).rolling_resistance == 0.1);
  CHECK(shape_of(scenario->scene, 0).surface_speed == 3);
  CHECK(shape_of(scenario->scene, 1).rolling_resistance == 0.2);
  CHECK(shape_of(scenario->scene, 1).surface_speed == 4);
  CHECK(shape_of(scenario->scene, 2).rolling_resistance == 0.3);
  CHECK(shape_of(scenario->scene, 2).surface_speed == 5);
}

TEST_CASE("Set changes rolling resistance and surface speed, before the run and during it") {
  const std::string text = "scenario{duration=1}\nlocal b = body{shape=circle{radius=1}}\n";
  const auto scenario = load_text(text + "b:set{rolling_resistance=0.3, surface_speed=7}");
  CHECK(shape_of(scenario->scene, 0).rolling_resistance == 0.3);
  CHECK(shape_of(scenario->scene, 0).surface_speed == 7);
  FakeRun run(text + "at(0.5, function() b:set{rolling_resistance=0.3, surface_speed=7} end)");
  run.until(121);
  REQUIRE(run.simulation->log.size() == 1);
  const auto& change = std::get<ChangeBody>(run.simulation->log[0]);
  CHECK(change.rolling_resistance == 0.3);
  CHECK(change.surface_speed == 7.0);
}

TEST_CASE("Rolling resistances and surface speeds that make no sense are refused") {
  const auto [keys, reason] = GENERATE(table<std::string, std::string>({
      {"rolling_resistance=-1", "rolling_resistance"},
      {"rolling_resistance=2e9", "rolling_resistance must be a number from 0 to 1e9 m"},
      {"rolling_resistance='much'", "rolling_resistance"},
      {"surface_speed=1/0", "surface_speed"},
      {"surface_speed=-2e9", "surface_speed must be a number below 1e9 m/s"},
      {"surfacespeed=1", "did you mean \"surface_speed\"?"},
  }));
  INFO(keys);
  CHECK_THAT(error_of(preamble + "body{shape=circle{radius=1}, " + keys + "}"),
             Contains("line 2: ") && Contains(reason));
}

TEST_CASE("A list that omits rolling resistance or surface speed is warned of") {
  const auto scenario = load_text(
      "scenario{effects={'gravity', 'contacts', 'friction'}}\nground{surface_speed=1}\n"
      "body{at={0, 1}, shape=circle{radius=1}, rolling_resistance=0.1}");
  REQUIRE(scenario->warnings.size() == 2);
  CHECK_THAT(scenario->warnings[0], Contains("\"rolling_resistance\""));
  CHECK_THAT(scenario->warnings[1], Contains("\"surface_speed\""));
}
