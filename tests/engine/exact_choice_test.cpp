// Which islands of contacts the default method solves exactly, and what it says of the others.

#include <catch2/catch.hpp>

#include "tests/engine/scenes.h"

using namespace proofreel;
using namespace proofreel::test;

namespace {

std::string told_after(const Scene& scene, double seconds) {
  const auto simulation = simulate(scene);
  run(*simulation, seconds, scene.rate);
  for (const EffectDecision& decision : simulation->effects()) {
    if (decision.effect == Effect::contacts) return decision.how;
  }
  return "no contacts";
}

BodyDef box_at(double x, double y) { return body_with(box_shape(1, 1), {x, y}); }

/// A box of 1 kg on the floor, and another one of this density welded on top of it.
Scene jointed_box(double heavy) {
  Scene scene;
  scene.bodies = {floor_body(), box_at(0, 0.5), box_at(0, 1.5)};
  scene.bodies[2].shapes[0].density = heavy;
  scene.joints = {joint_between(JointKind::weld, BodyId(2), {0, 0.5}, BodyId(3), {0, -0.5})};
  return scene;
}

}  // namespace

TEST_CASE("Boxes apart are islands of their own, and solved exactly", "[exact choice]") {
  Scene scene;
  scene.bodies = {floor_body(), box_at(0, 0.5), box_at(3, 0.5), box_at(6, 0.5)};
  CHECK(told_after(scene, 0.1) == "at the last tick 3 of 3 contacts were solved exactly, in 3 islands");
}

TEST_CASE("Where nothing touches, nothing is claimed", "[exact choice]") {
  Scene scene;
  scene.bodies = {floor_body(), box_at(0, 50)};
  CHECK(told_after(scene, 0.1) == "nothing touched at the last tick");
}

namespace {

/// Fourteen rows of boxes, each half a box aside of the one below, that slide as one.
Scene wall(double speed) {
  Scene scene;
  scene.rate = 60;
  scene.bodies = {floor_body()};
  for (int row = 0; row < 14; ++row) {
    for (int i = 0; i < 14; ++i) {
      scene.bodies.push_back(box_at(i + 0.5 * (row % 2), row + 0.5));
      scene.bodies.back().velocity = {speed, 0};
    }
  }
  return scene;
}

}  // namespace

TEST_CASE("A wall of more contacts than are affordable is exact at rest, else soft and said to be too large",
          "[exact choice]") {
  CHECK_THAT(told_after(wall(2), 0.02),
             Catch::StartsWith("at the last tick 0 of ") && Catch::Contains("too large for how they move"));
  if (is_double) CHECK_THAT(told_after(wall(0), 0.02), Catch::EndsWith("were solved exactly, in 1 island"));
}

TEST_CASE("What a lift presses against a ceiling is soft: that has no exact solution", "[exact choice]") {
  Scene scene;
  BodyDef lift = body_with(box_shape(4, 1), {0, -0.5}, BodyType::kinematic);
  lift.velocity = {0, 0.01};
  scene.bodies = {lift, box_at(0, 0.5), body_with(box_shape(4, 1), {0, 1.5}, BodyType::fixed)};
  CHECK_THAT(told_after(scene, 0.1), Catch::Contains("2 softly: a body that moves regardless presses them"));
}

TEST_CASE("A lift that carries a box presses it against nothing else: that is exact", "[exact choice]") {
  Scene scene;
  BodyDef lift = body_with(box_shape(4, 1), {0, -0.5}, BodyType::kinematic);
  lift.velocity = {0, 0.5};
  scene.bodies = {lift, box_at(0, 0.5)};
  CHECK_THAT(told_after(scene, 0.1), Catch::StartsWith("at the last tick 1 of 1 contacts were solved exactly"));
}

TEST_CASE("Jointed bodies are exact where their load would show, else soft", "[exact choice]") {
  CHECK_THAT(told_after(jointed_box(1), 0.2), Catch::Contains("bear too little to give way visibly"));
  CHECK_THAT(told_after(jointed_box(2000), 0.2), Catch::StartsWith("at the last tick 1 of 1 contacts were solved"));
}

TEST_CASE("A contact stiffness that the scene sets makes all contacts soft", "[exact choice]") {
  Scene scene;
  scene.bodies = {floor_body(), box_at(0, 0.5)};
  scene.method.contact_hz = 30;
  CHECK(told_after(scene, 0.1).empty());
}
