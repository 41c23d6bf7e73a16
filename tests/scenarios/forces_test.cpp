#include <catch2/catch.hpp>

#include "scene_text.h"

using namespace proofreel;
using Catch::Contains;

namespace {

const std::string two =
    "scenario{}\nlocal b = body{name='b', mass=4, shape=circle{radius=1}}\n"
    "local wall = wall{a={3,0}, b={3,1}}\n";

Scene scene_of(const std::string& text) { return load_text(two + text)->scene; }

}  // namespace

TEST_CASE("Drag, wind, attractors, n-body gravity and rockets become part of the scene") {
  const Scene scene = scene_of(
      "drag{linear=1, quadratic=2, angular=3} wind{velocity={4, 5}} nbody{G=6}\n"
      "attractor{at={1, 2}, strength=7} attractor{body=b, strength=-8, law='linear'}\n"
      "rocket{body=b, thrust=9, burn_rate=0.5, fuel=3, at={0, -1}}");
  CHECK(scene.drag.linear == 1);
  CHECK(scene.drag.quadratic == 2);
  CHECK(scene.drag.angular == 3);
  CHECK(scene.wind == Vec2d{4, 5});
  CHECK(scene.gravitational_constant == 6);
  REQUIRE(scene.attractors.size() == 2);
  CHECK(scene.attractors[0].at == Vec2d{1, 2});
  CHECK(scene.attractors[0].law == AttractionLaw::inverse_square);
  CHECK(scene.attractors[1].body == BodyId{1});
  CHECK(scene.attractors[1].law == AttractionLaw::linear);
  REQUIRE(scene.rockets.size() == 1);
  CHECK(scene.rockets[0].fuel == 3);
  CHECK(scene.rockets[0].at == Vec2d{0, -1});
}

TEST_CASE("A body's drag is a number or a table, and can be set") {
  const Scene scene = scene_of("body{shape=circle{radius=1}, drag=2}\nb:set{drag={quadratic=3}}");
  CHECK(scene.bodies[2].drag->linear == 2);
  CHECK(scene.bodies[0].drag->quadratic == 3);
}

TEST_CASE("Forces that make no sense are refused with what to do") {
  const auto [line, reason] = GENERATE(table<std::string, std::string>({
      {"drag{}", "linear, quadratic or angular"},
      {"drag{linear=-1}", "linear"},
      {"drag{lineal=1}", "linear"},
      {"wind{}", "velocity"},
      {"attractor{strength=1}", "either at={x, y} or body="},
      {"attractor{at={0,0}, body=b, strength=1}", "either at={x, y} or body="},
      {"attractor{at={0,0}}", "strength"},
      {"attractor{at={0,0}, strength=1, law='cubic'}", "inverse_square"},
      {"nbody{}", "G"},
      {"rocket{body=b, thrust=1, burn_rate=0, fuel=1}", "burn_rate"},
      {"rocket{body=b, thrust=1, burn_rate=1, fuel=4}", "carries 4.0 kg of fuel but has a mass of 4.0 kg"},
      {"rocket{body=wall, thrust=1, burn_rate=1, fuel=1}", "not dynamic"},
      {"rocket{thrust=1, burn_rate=1, fuel=1}", "body"},
      {"body{shape=circle{radius=1}, drag='much'}", "drag"},
  }));
  INFO(line);
  CHECK_THAT(error_of(two + line), Contains("line 4: ") && Contains(reason));
}

TEST_CASE("Forces belong at the top of the file") {
  CHECK_THAT(error_of("scenario{duration=1}\nlocal b = body{shape=circle{radius=1}}\n"
                      "at(0.5, function() drag{linear=1} end)"),
             Contains("line 3: drag"));
}

TEST_CASE("A list of effects that omits drag is warned of") {
  const auto scenario = load_text("scenario{effects={'gravity'}}\nbody{shape=circle{radius=1}}\ndrag{linear=1}");
  REQUIRE(scenario->warnings.size() == 1);
  CHECK_THAT(scenario->warnings[0], Contains("\"drag\""));
}
