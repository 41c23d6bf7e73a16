// The contact solver "event": every impact at its own time.

#include <catch2/catch.hpp>
#include <cmath>

#include "engine/closing.h"
#include "tests/engine/scenes.h"

using namespace proofreel;
using namespace proofreel::test;

namespace {

Scene located(Scene scene) {
  scene.method.contact_solver = ContactMethod::event;
  return scene;
}

Scene ball_above_floor(double restitution, double height) {
  Scene scene = with_floor(body_with(disc_shape(0.5), {0, 0.5 + height}));
  scene.bodies[1].shapes[0].restitution = restitution;
  return located(scene);
}

/// The impacts that Galperin's billiard counts: a block comes in and strikes another one against a wall.
std::size_t impacts_before_parting(double mass) {
  Scene scene;
  scene.gravity = {0, 0};
  scene.bodies = {body_with(box_shape(1, 4), {-0.5, 0}, BodyType::fixed), body_with(box_shape(1, 1), {2, 0}),
                  body_with(box_shape(1, 1), {4, 0})};
  scene.bodies[1].mass = 1;
  scene.bodies[2].mass = mass;
  scene.bodies[2].velocity = {-1, 0};
  for (BodyDef& body : scene.bodies) {
    body.fixed_rotation = true;
    body.shapes[0].friction = {0, 0};
    body.shapes[0].restitution = 1;
  }
  const auto simulation = simulate(located(scene));
  std::size_t impacts = 0;
  for (int i = 0; i < 40 * 240; ++i) {
    simulation->step();
    impacts += simulation->contact_events().size();
  }
  return impacts;
}

}  // namespace

TEST_CASE("Impacts of two blocks and a wall count the digits of pi", "[event]") {
  CHECK(impacts_before_parting(1) == 3);
  CHECK(impacts_before_parting(100) == 31);
  if (is_double) CHECK(impacts_before_parting(10000) == 314);
}

TEST_CASE("Bounces reach e squared of the height before", "[event]") {
  const double e = GENERATE(0.3, 0.5, 0.8, 0.95);
  const auto simulation = simulate(ball_above_floor(e, 1));
  double height = 1;
  double highest = 0;
  int bounces = 0;
  for (int i = 0; i < 4 * 240 && bounces < 4 && height > 0.01; ++i) {
    simulation->step();
    if (!simulation->contact_events().empty()) {
      if (bounces > 0) CHECK(highest == Approx(e * e * height).epsilon(5e-3));
      if (bounces > 0) height *= e * e;
      highest = 0;
      bounces += static_cast<int>(simulation->contact_events().size());
    }
    if (bounces > 0) highest = std::max(highest, simulation->body(BodyId(2)).position.y - 0.5);
  }
  CHECK(bounces > 1);
}

TEST_CASE("A ball bounces infinitely often in a finite time and then rests", "[event]") {
  const auto simulation = simulate(ball_above_floor(0.5, 1));
  const double fall = std::sqrt(2 / 9.81);
  const double rest = 3 * fall;  // the sum of the geometric series of all bounces
  run(*simulation, rest - 0.05);
  CHECK(std::abs(simulation->body(BodyId(2)).velocity.y) > 1e-3);
  run(*simulation,
      pick(0.1, 0.3));  // in single precision the last bounces are lost among the digits of a floor of 100 m
  CHECK(length(simulation->body(BodyId(2)).velocity) < pick(1e-12, 1e-5));
  CHECK(simulation->body(BodyId(2)).position.y == Approx(0.5).margin(pick(1e-8, 5e-5)));
}

TEST_CASE("On ground so wide that coordinates tell gaps badly, a ball still rests in the end", "[event]") {
  Scene scene = ball_above_floor(0.5, 1);
  scene.bodies[0] = body_with(box_shape(2000, 100), {0, -50}, BodyType::fixed);
  const auto simulation = simulate(scene);
  run(*simulation, 2, scene.rate);  // 1.35 s after Zeno
  const Vec2d resting = simulation->body(BodyId(2)).position;
  run(*simulation, 0.5, scene.rate);
  CHECK(length(simulation->body(BodyId(2)).velocity) < pick(1e-12, 1e-6));
  CHECK(simulation->body(BodyId(2)).position.y == Approx(resting.y).margin(pick(1e-12, 1e-6)));
  CHECK(resting.y - 0.5 < pick(1e-8, 2e-3));
}

TEST_CASE("An elastic ball keeps its energy and its beat over a thousand bounces", "[event]") {
  const auto simulation = simulate(ball_above_floor(1, 0.05));
  const double before = simulation->energy().total();
  std::size_t bounces = 0;
  for (int i = 0; i < 240 * 20; ++i) {
    simulation->step();
    bounces += simulation->contact_events().size();
  }
  const double beat = 2 * std::sqrt(2 * 0.05 / 9.81);
  CHECK(static_cast<double>(bounces) == Approx(20 / beat).margin(1.01));
  CHECK(simulation->energy().total() == Approx(before).epsilon(pick(1e-9, 1e-3)));
}

TEST_CASE("A step as long as the fall does not move the impact", "[event]") {
  Scene scene = ball_above_floor(1, 1);
  scene.rate = 2;
  scene.method.substeps = 1;
  const auto simulation = simulate(scene);
  simulation->step();  // 0.5 s, the impact is at 0.4515 s
  const double fall = std::sqrt(2 / 9.81);
  const double since = 0.5 - fall;
  const double expected = 9.81 * fall * since - 0.5 * 9.81 * since * since;
  CHECK(simulation->body(BodyId(2)).position.y - 0.5 == Approx(expected).epsilon(pick(1e-8, 1e-4)));
  REQUIRE(simulation->contact_events().size() == 1);
  CHECK(simulation->contact_events()[0].impulse == Approx(2 * simulation->body(BodyId(2)).mass * 9.81 * fall));
}

TEST_CASE("A box that falls on an edge and then lies flat makes both impacts and rests", "[event]") {
  Scene scene = with_floor(body_with(box_shape(1, 1), {0, 1.5}));
  scene.bodies[1].angle = 0.3;
  const auto simulation = simulate(located(scene));
  run(*simulation, 4);
  const BodyState box = simulation->body(BodyId(2));
  CHECK(box.position.y == Approx(0.5).margin(pick(1e-7, 1e-4)));
  CHECK(length(box.velocity) + std::abs(box.spin) < pick(1e-7, 1e-3));
}

TEST_CASE("In a row of equal balls the last one flies off alone", "[event]") {
  Scene scene;
  scene.gravity = {0, 0};
  for (int i = 0; i < 5; ++i) scene.bodies.push_back(body_with(disc_shape(0.5), {1.0 * i, 0}));
  scene.bodies[0].position.x = -1;
  scene.bodies[0].velocity = {2, 0};
  for (BodyDef& body : scene.bodies) body.shapes[0].restitution = 1;
  const auto simulation = simulate(located(scene));
  run(*simulation, 1.5);
  for (std::uint32_t i = 1; i <= 4; ++i) CHECK(length(simulation->body(BodyId(i)).velocity) < pick(1e-9, 1e-4));
  CHECK(simulation->body(BodyId(5)).velocity.x == Approx(2));
}

TEST_CASE("What flies through a wall within one step is stopped by it", "[event]") {
  Scene scene;
  scene.gravity = {0, 0};
  scene.bodies = {body_with(box_shape(0.02, 4), {0, 0}, BodyType::fixed), body_with(disc_shape(0.05), {-3, 0.1})};
  scene.bodies[1].velocity = {700, 0};
  scene.bodies[1].shapes[0].restitution = 1;
  const auto simulation = simulate(located(scene));
  run(*simulation, 0.1);
  CHECK(simulation->body(BodyId(2)).velocity.x == Approx(-700));
}

TEST_CASE("Rockets and fields, which go by the clock, are refused with impacts at times of their own", "[event]") {
  Scene scene = located(with_floor(body_with(box_shape(1, 1), {0, 2})));
  CHECK_FALSE(problem_with_method(scene));
  scene.fields = {[](Vec2d, Vec2d, double) { return Vec2d{}; }};
  CHECK(problem_with_method(scene).value_or("").find("use \"exact\"") != std::string::npos);
  scene.fields.clear();
  scene.rockets = {{BodyId(2), 10, 0.1, 0.5, {}}};
  CHECK(problem_with_method(scene).value_or("").find("use \"exact\"") != std::string::npos);
}

TEST_CASE("A gap that is closed within the span is found where it closes", "[event]") {
  const auto at = [](real speed, real margin) {
    const auto gap = [speed](real t) { return 1 - speed * t; };
    return time_of_closing(gap, margin * speed, real(2), real(1e-6));
  };
  CHECK(at(1, 1) == Approx(1).margin(1e-5));
  CHECK(at(1, 10) == Approx(1).margin(1e-5));
  CHECK(at(1, 1000) == Approx(1).margin(1e-5));  // where the bound says little the end tells
  CHECK(std::isinf(at(real(0.4), 1)));
  CHECK(std::isinf(at(real(0.4), 1000)));
}

TEST_CASE("What is struck within a step does not fly through a wall behind it", "[event]") {
  Scene scene;
  scene.rate = 30;
  scene.method.substeps = 1;
  scene.gravity = {0, 0};
  scene.bodies = {body_with(disc_shape(0.1), {0, 0}), body_with(disc_shape(0.1), {1.03, 0}),
                  body_with(box_shape(0.02, 4), {1.5, 0}, BodyType::fixed)};
  scene.bodies[0].velocity = {100, 0};
  for (BodyDef& body : scene.bodies) {
    body.bullet = true;
    body.shapes[0].friction = {0, 0};
    body.shapes[0].restitution = 1;
  }
  const auto simulation = simulate(located(scene));
  run(*simulation, 1, 30);
  // Equal balls: the struck one comes back from the wall and hands the speed back to the first one.
  CHECK(simulation->body(BodyId(1)).velocity.x == Approx(-100));
  CHECK(simulation->body(BodyId(2)).position.x == Approx(1.03).margin(pick(1e-6, 1e-3)));
}
