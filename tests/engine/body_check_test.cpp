#include <catch2/catch.hpp>
#include <cmath>
#include <limits>

#include "tests/engine/scenes.h"

using namespace proofreel;
using namespace proofreel::test;

namespace {

std::string problem(const BodyDef& body) { return problem_with(body).value_or("sound"); }

BodyDef sound_body() { return body_with(box_shape(1, 1), {0, 0}); }

}  // namespace

TEST_CASE("An ordinary body is sound", "[check]") { CHECK(problem(sound_body()) == "sound"); }

TEST_CASE("Numbers that are not finite are refused by what they are", "[check]") {
  for (const double bad : {std::nan(""), HUGE_VAL, -HUGE_VAL, 1e12}) {
    BodyDef body = sound_body();
    body.position.x = bad;
    CHECK_THAT(problem(body), Catch::Contains("position"));
    body = sound_body();
    body.velocity.y = bad;
    CHECK_THAT(problem(body), Catch::Contains("velocity"));
    body = sound_body();
    body.angle = bad;
    CHECK_THAT(problem(body), Catch::Contains("angle"));
    body = sound_body();
    body.spin = bad;
    CHECK_THAT(problem(body), Catch::Contains("spin"));
    body = sound_body();
    body.shapes[0].points[2].x = bad;
    CHECK_THAT(problem(body), Catch::Contains("coordinate"));
  }
}

TEST_CASE("Coefficients outside their range are refused", "[check]") {
  BodyDef body = sound_body();
  body.shapes[0].restitution = 1.01;
  CHECK_THAT(problem(body), Catch::Contains("restitution"));
  body = sound_body();
  body.shapes[0].friction = {-0.1, -0.1};
  CHECK_THAT(problem(body), Catch::Contains("friction"));
  body.shapes[0].friction = {0.3, 0.4};
  CHECK_THAT(problem(body), Catch::Contains("static friction"));
  body = sound_body();
  body.shapes[0].density = 0;
  CHECK_THAT(problem(body), Catch::Contains("density"));
}

TEST_CASE("Masses must be positive", "[check]") {
  for (const double bad : {0.0, -1.0, std::nan("")}) {
    BodyDef body = sound_body();
    body.mass = bad;
    CHECK_THAT(problem(body), Catch::Contains("mass"));
    body = sound_body();
    body.inertia = bad;
    CHECK_THAT(problem(body), Catch::Contains("inertia"));
  }
}

TEST_CASE("Shapes without extent are refused", "[check]") {
  CHECK_THAT(problem(body_with(disc_shape(0), {0, 0})), Catch::Contains("radius"));
  CHECK_THAT(problem(body_with(disc_shape(-1), {0, 0})), Catch::Contains("radius"));
  BodyDef body = sound_body();
  body.shapes[0].points = {{1, 1}, {1, 1}};
  CHECK_THAT(problem(body), Catch::Contains("same point"));
  body.shapes[0].points = {{0, 0}, {1, 1}, {1, 0}, {0, 1}};
  CHECK_THAT(problem(body), Catch::Contains("crosses itself"));
}

TEST_CASE("A dynamic body needs an area or a mass of its own", "[check]") {
  ShapeDef segment;
  segment.points = {{0, 0}, {1, 0}};
  BodyDef body = body_with(segment, {0, 0});
  CHECK_THAT(problem(body), Catch::Contains("no area"));
  body.mass = 1;
  CHECK(problem(body) == "sound");
  body = body_with(segment, {0, 0}, BodyType::fixed);
  CHECK(problem(body) == "sound");
  BodyDef empty;
  CHECK_THAT(problem(empty), Catch::Contains("no shape"));
}
