#include <catch2/catch.hpp>
#include <cmath>

#include "engine/mass.h"
#include "engine/polygon.h"
#include "scene_text.h"

using namespace proofreel;
using Catch::Contains;

namespace {

const std::string l_shape = "polygon{{0,0},{2,0},{2,1},{1,1},{1,2},{0,2}}";

/// A polygon of the given number of corners, written in Lua.
std::string polygon_of(int corners, const std::string& radius) {
  return "local c = {} for i = 1, " + std::to_string(corners) + " do local a = 2 * math.pi * i / " +
         std::to_string(corners) + " local r = " + radius + " c[i] = {r * math.cos(a), r * math.sin(a)} end\n";
}

BodyDef body_of(const std::string& text) { return load_text("scenario{}\n" + text)->scene.bodies.at(0); }

double area_of_shapes(const BodyDef& body) {
  double area = 0;
  for (const ShapeDef& shape : body.shapes) area += area_of(shape.points);
  return area;
}

/// What a body of that shape is refused with, from the name on.
std::string refusal(const std::string& shape) {
  const std::string message = error_of("scenario{}\nbody{name='odd', shape=" + shape + "}");
  const std::string start = "scene.lua: line 2: ";
  INFO(message);
  REQUIRE(message.substr(0, start.size()) == start);
  return message.substr(start.size());
}

}  // namespace

TEST_CASE("A concave polygon becomes convex shapes that fill it") {
  const BodyDef body = body_of("body{shape=" + l_shape + "}");
  CHECK(body.shapes.size() == 2);
  CHECK(area_of_shapes(body) == 3);
  for (const ShapeDef& shape : body.shapes) CHECK(is_convex(shape.points));
}

TEST_CASE("A concave body has the mass, centre and inertia of the whole polygon") {
  const MassProperties mass = mass_of(body_of("body{density=4, shape=" + l_shape + "}"));
  CHECK(mass.mass == Approx(12));
  CHECK(mass.center.x == Approx(5.0 / 6));
  CHECK(mass.center.y == Approx(5.0 / 6));
  CHECK(mass.inertia == Approx(4 * (3.0 / 6 + 12.0 / 9)));  // of three unit squares
}

TEST_CASE("All parts of a concave polygon have its coefficients, or else the body's") {
  const BodyDef body = body_of(
      "body{friction=0.1, density=3, shape="
      "polygon{{0,0},{2,0},{2,1},{1,1},{1,2},{0,2}, density=7, friction={static=0.9, kinetic=0.8}, restitution=0.5}}");
  REQUIRE(body.shapes.size() == 2);
  for (const ShapeDef& shape : body.shapes) {
    CHECK(shape.density == 7);
    CHECK(shape.friction == FrictionDef{0.9, 0.8});
    CHECK(shape.restitution == 0.5);
  }
  for (const ShapeDef& shape : body_of("body{friction=0.1, density=3, shape=" + l_shape + "}").shapes) {
    CHECK(shape.density == 3);
    CHECK(shape.friction == FrictionDef{0.1, 0.1});
  }
}

TEST_CASE("Concave polygons stand beside other shapes in a list") {
  const BodyDef body = body_of("body{shapes={circle{radius=1}, " + l_shape + ", box{width=1, height=1}}}");
  REQUIRE(body.shapes.size() == 4);
  CHECK(body.shapes[0].points.size() == 1);
  CHECK(body.shapes[3].points.size() == 4);
}

TEST_CASE("set gives a body a concave shape, while loading and while running") {
  const BodyDef loaded = body_of("local b = body{shape=circle{radius=1}, friction=0.2}\nb:set{shape=" + l_shape + "}");
  REQUIRE(loaded.shapes.size() == 2);
  CHECK(loaded.shapes[1].friction.at_rest == 0.2);
  FakeRun run("scenario{gravity={0, 0}}\nlocal b = body{shape=circle{radius=1}}\nat(0.1, function() b:set{shape=" +
              l_shape + "} end)\nmeasure('mass', function() return b:mass() end)");
  run.until(30);
  CHECK(run.simulation->tick() == 30);
  const auto scenario = load_text(
      "scenario{gravity={0, 0}}\nlocal b = body{shape=circle{radius=1}}\n"
      "at(0.1, function() b:set{shape=" +
      l_shape + "} end)\nmeasure('mass', function() return b:mass() end)");
  Runner runner(*scenario);
  runner.finish();
  CHECK(scenario->script->measure(0) == Approx(3));
}

TEST_CASE("A concave body falls, lands and rests: a U on its feet keeps its height") {
  const auto scenario = load_text(
      "scenario{duration=2}\nground{y=0}\n"
      "local u = body{at={0, 0.05}, shape=polygon{{0,0},{1,0},{1,2},{2,2},{2,0},{3,0},{3,3},{0,3}}}\n"
      "measure('y', function() return u:position().y end)\nmeasure('angle', function() return u:angle() end)");
  Runner runner(*scenario);
  runner.finish();
  CHECK(std::fabs(scenario->script->measure(0)) < 0.01);
  CHECK(std::fabs(scenario->script->measure(1)) < 0.001);
}

TEST_CASE("A polygon of more corners than a shape may have becomes several shapes") {
  const BodyDef round = body_of(polygon_of(40, "1") + "body{shape=polygon(c)}");
  CHECK(round.shapes.size() == 3);
  CHECK(area_of_shapes(round) == Approx(20 * std::sin(2 * 3.141592653589793 / 40)));
  CHECK(body_of(polygon_of(40, "1") + "body{shape=hull(c)}").shapes.size() == 3);
  CHECK(body_of(polygon_of(64, "1 + i % 2") + "body{shape=polygon(c)}").shapes.size() > 16);
}

TEST_CASE("A convex polygon of few corners is one shape with the corners as they are written") {
  const BodyDef body = body_of("body{shape=polygon{{0.1,0.2},{3.3,0.4},{2.5,2.6}}}");
  REQUIRE(body.shapes.size() == 1);
  CHECK(body.shapes[0].points == std::vector<Vec2d>{{0.1, 0.2}, {3.3, 0.4}, {2.5, 2.6}});
}

TEST_CASE("Geometry nobody can use is refused with body, shape, reason and remedy") {
  const auto [shape, sentence] = GENERATE(table<std::string, std::string>({
      {"circle{radius=1e10}", "the radius of its circle must not exceed 1e9 m: make it smaller"},
      {"circle{radius=1/0}", "the radius of its circle must not exceed 1e9 m: make it smaller"},
      {"circle{radius=0/0}", "the radius of its circle must be a positive number"},
      {"circle{radius=0}", "the radius of its circle must be a positive number"},
      {"circle{radius=-1}", "the radius of its circle must be a positive number"},
      {"circle{radius=1, at={0/0, 0}}", "the centre of its circle is not finite: give two ordinary numbers"},
      {"circle{radius=1, at={0, 2e9}}",
       "the centre of its circle has a coordinate above 1e9 m: make it smaller or move it nearer"},
      {"box{width=0, height=1}", "the width of its box must be a positive number"},
      {"box{width=1, height=1e10}", "the height of its box must not exceed 1e9 m: make it smaller"},
      {"box{width=1, height=1, at={1/0, 0}}", "corner 1 of its box is not finite: give two ordinary numbers"},
      {"box{width=1, height=1, at={2e9, 0}}",
       "corner 1 of its box has a coordinate above 1e9 m: make it smaller or move it nearer"},
      {"box{width=1, height=1e-7}",
       "its box is thinner than a millionth of its extent: make it thicker, or use a segment or capsule"},
      {"box{width=1e-6, height=1e-6, at={1e9-1,0}}",
       "its box is too small for its corners to be told apart so far away: make it larger or move it nearer"},
      {"regular{sides=3, radius=0}", "the radius of its regular polygon must be a positive number"},
      {"capsule{a={0,0}, b={0,0}, radius=1}",
       "the two ends of its capsule are the same point: move one, or use a circle"},
      {"capsule{a={0,0}, b={1,0}, radius=0}", "the radius of its capsule must be a positive number"},
      {"capsule{a={0,0}, b={1/0,0}, radius=1}", "the end b of its capsule is not finite: give two ordinary numbers"},
      {"segment{a={3e9,0}, b={1,0}}",
       "the end a of its segment has a coordinate above 1e9 m: make it smaller or move it nearer"},
      {"polygon{{0,0},{0/0,0},{1,1}}", "corner 2 of its polygon is not finite: give two ordinary numbers"},
      {"polygon{{0,0},{1,0},{1,1/0}}", "corner 3 of its polygon is not finite: give two ordinary numbers"},
      {"polygon{{0,0},{1,0},{1,1e10}}",
       "corner 3 of its polygon has a coordinate above 1e9 m: make it smaller or move it nearer"},
      {"polygon{}", "its polygon has fewer than three distinct points: give at least three corners"},
      {"polygon{{0,0},{1,0},{0,0},{1,0}}",
       "its polygon has fewer than three distinct points: give at least three corners"},
      {"polygon{{0,0},{1,1},{3,3}}",
       "all corners of its polygon lie on one line, it has zero area: move one off the line"},
      {"polygon{{0,0},{1,0},{1,1e-7}}",
       "its polygon is thinner than a millionth of its extent: make it thicker, or use a segment or capsule"},
      {"polygon{{0,0},{1,1},{1,0},{0,1}}",
       "its polygon crosses itself: its edge from corner 1 to corner 2 meets the one from corner 3 to corner 4; list "
       "the corners in the order of the outline"},
      {"polygon{{0,0},{4,0},{4,4},{0,4},{0,0},{1,1},{1,3},{3,3},{3,1},{1,1}}",
       "its polygon touches itself: its edge from corner 1 to corner 2 meets the one from corner 4 to corner 5; leave "
       "a "
       "gap, and build what goes round a hole of several polygons, shapes={...}"},
      {"polygon{{0,0},{4,0},{4,4},{2+1e-7,4},{2,9},{2-1e-7,4},{0,4}}",
       "its polygon cannot be used: however it is cut into convex parts, one at its corner {2.0000001, 4} is thinner "
       "than a millionth of its extent: move that corner or leave it out"},
      {"hull{{0,0},{1,1},{2,2}}", "all points of its hull lie on one line, it has zero area: move one off the line"},
      {"hull{{0,0},{1,0}}", "its hull has fewer than three distinct points: give at least three"},
      {"hull{}", "its hull has fewer than three distinct points: give at least three"},
      {"hull{{0,0},{1,0},{0/0,1}}", "point 3 of its hull is not finite: give two ordinary numbers"},
      {"hull{{0,0},{1,0},{-1e10,1}}",
       "point 3 of its hull has a coordinate above 1e9 m: make it smaller or move it nearer"},
      {"hull{{0,0},{1,0},{1,1e-7}}",
       "its hull is thinner than a millionth of its extent: make it thicker, or use a segment or capsule"},
  }));
  CHECK(refusal(shape) == "body \"odd\": " + sentence);
}

TEST_CASE("Of several shapes the one that cannot be used is named by its place, parts not counted") {
  CHECK_THAT(error_of("scenario{}\nbody{name='odd', shapes={" + l_shape + ", circle{radius=-1}}}"),
             Contains("body \"odd\": shape 2: the radius of its circle must be a positive number"));
}

TEST_CASE("Too many corners are refused with both numbers") {
  CHECK_THAT(error_of("scenario{}\n" + polygon_of(300, "1") + "body{name='odd', shape=polygon(c)}"),
             Contains("body \"odd\": its polygon has 300 corners, at most 256 are possible: leave some out"));
  CHECK_THAT(error_of("scenario{}\n" + polygon_of(1001, "1") + "body{name='odd', shape=polygon(c)}"),
             Contains("polygon: 1001 points are too many, at most 1000 can be given: leave some out"));
}

TEST_CASE("A script that cuts polygons all day is stopped") {
  const std::string zigzag =
      "local c = {} for i = 1, 125 do c[i] = {i, i % 2 * 3 - 1} c[251 - i] = {i, i % 2 * 3} end\n";
  CHECK_THAT(error_of("scenario{}\n" + zigzag + "while true do polygon(c) end"), Contains("million instructions"));
}

TEST_CASE("Rounding takes the corners off and leaves the width and height") {
  const BodyDef body = body_of("body{density=1, shape=box{width=4, height=2, rounding=0.5}}");
  REQUIRE(body.shapes.size() == 1);
  CHECK(body.shapes[0].radius == 0.5);
  for (const Vec2d p : body.shapes[0].points) {
    CHECK(std::abs(p.x) == Approx(1.5));
    CHECK(std::abs(p.y) == Approx(0.5));
  }
  CHECK(mass_of(body).mass == Approx(8 - (4 - 3.14159265358979) * 0.25));
}

TEST_CASE("A rounded triangle touches the sides of the sharp one") {
  const BodyDef body = body_of("body{shape=polygon{{0,0},{3,0},{0,4}, rounding=0.25}}");
  REQUIRE(body.shapes[0].points.size() == 3);
  double left = 1;
  double low = 1;
  double across = 0;
  for (const Vec2d p : body.shapes[0].points) {
    left = std::min(left, p.x);
    low = std::min(low, p.y);
    across = std::max(across, 0.8 * p.x + 0.6 * p.y);
  }
  CHECK(left == Approx(0.25));
  CHECK(low == Approx(0.25));
  CHECK(across == Approx(2.4 - 0.25));
}

TEST_CASE("A rounding that cannot be had is refused with its reason") {
  CHECK_THAT(refusal("box{width=1, height=0.4, rounding=0.2}"), Contains("is 0.2 m") && Contains("smaller than 0.2 m"));
  CHECK_THAT(refusal("regular{sides=4, radius=2, rounding=3}"), Contains("smaller than 1.41421 m"));
  CHECK_THAT(refusal("polygon{{0,0},{4,0},{0,3}, rounding=1.5}"),
             Contains("smaller than 1 m, the radius of the largest"));
  CHECK_THAT(refusal("polygon{{0,0},{2,0},{2,1},{1,1},{1,2},{0,2}, rounding=0.1}"), Contains("concave"));
  CHECK_THAT(error_of("scenario{}\nbody{shape=box{width=1, height=1, rounding=-1}}"), Contains("rounding"));
}

TEST_CASE("The largest rounding named is the largest there is") {
  for (const std::string shape : {"polygon{{0,0},{4,0},{0,3}", "hull{{0,0},{2,-1},{5,1},{4,3},{1,2}",
                                  "regular{sides=7, radius=1.5", "box{width=3, height=0.7"}) {
    const std::string sentence = refusal(shape + ", rounding=9}");
    const std::string::size_type at = sentence.find("smaller than ");
    REQUIRE(at != std::string::npos);
    const double largest = std::stod(sentence.substr(at + 13));
    CHECK(body_of("body{shape=" + shape + ", rounding=" + std::to_string(0.9999 * largest) + "}}").shapes.size() == 1);
    CHECK_THAT(refusal(shape + ", rounding=" + std::to_string(1.0001 * largest) + "}"), Contains("leaves nothing"));
  }
}

TEST_CASE("A corner numbered beyond the sequence is refused with its place and what to do") {
  const std::string error = error_of("scenario{}\nbody{shape=polygon{{0,0},{1,0},{1,1},[7]={0,1}}}");
  CHECK_THAT(error,
             Contains("scene.lua: line 2: polygon: [7] comes after a gap, the list ends at 3: number the points"));
  CHECK_THAT(error_of("scenario{}\nbody{shape=hull{{0,0},{1,0},{1,1},[9]={0,1},[5]={2,2}}}"), Contains("hull: [5]"));
  CHECK(body_of("body{shape=polygon{{0,0},{1,0},{1,1},[4]={0,1}}}").shapes[0].points.size() == 4);
}
