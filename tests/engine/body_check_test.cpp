#include <catch2/catch.hpp>
#include <cmath>

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

TEST_CASE("A polygon must be listed as the collision stages take it", "[check]") {
  const auto of = [](std::vector<Vec2d> points) {
    BodyDef body = sound_body();
    body.shapes[0].points = std::move(points);
    return problem(body);
  };
  CHECK(of({{0, 0}, {1, 0}, {1, 1}}) == "sound");
  CHECK(of({{0, 0}, {1, 0}, {2, 0}, {1, 1}}) == "sound");
  CHECK_THAT(of({{0, 0}, {1, 1}, {1, 0}}), Catch::Contains("counter-clockwise") && Catch::Contains("clean_polygon"));
  CHECK_THAT(of({{0, 0}, {1, 0}, {1, 0}, {1, 1}}), Catch::Contains("every corner once"));
  CHECK_THAT(of({{0, 0}, {1, 0}, {1, 1}, {0, 0}}), Catch::Contains("every corner once"));
  CHECK_THAT(of({{0, 0}, {2, 0}, {0.5, 0.5}, {0, 2}}), Catch::Contains("concave") && Catch::Contains("convex_parts"));
  CHECK_THAT(of({{0, 0}, {1000, 0}, {1000, 0.0001}}), Catch::Contains("thinner than a millionth"));
  CHECK_THAT(of({{0, 0}, {1, 1}, {2, 2}}), Catch::Contains("zero area"));
  std::vector<Vec2d> many;
  for (int i = 0; i <= max_polygon_vertices; ++i) many.push_back({1.0 * i, 1.0 * i * i});
  CHECK_THAT(of(many), Catch::Contains("17 corners") && Catch::Contains("at most 16"));
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
