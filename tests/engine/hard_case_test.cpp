/// Cases that physics engines are known to fail at, kept in small here; named after what happens in them.

#include <algorithm>
#include <catch2/catch.hpp>
#include <numbers>

#include "engine/elementary.h"
#include "tests/engine/scenes.h"

using namespace proofreel;
using namespace proofreel::test;

namespace {

#ifdef NDEBUG
constexpr int crowd = 1000;
constexpr int turning_ticks = 1000;
#else
constexpr int crowd = 200;
constexpr int turning_ticks = 200;
#endif

/// A sixtieth of a second in four substeps.
Scene coarse_scene() {
  Scene scene;
  scene.rate = 60;
  scene.method.substeps = 4;
  return scene;
}

ShapeDef capsule_shape(double half_length, double radius) {
  ShapeDef shape;
  shape.points = {{-half_length, 0}, {half_length, 0}};
  shape.radius = radius;
  return shape;
}

constexpr double ring_radius = 20;
constexpr Vec2d pivot{0, -9};
constexpr BodyId paddle{2};

/// A ring of 90 capsules, and in it a paddle on a pivot, which reaches to a metre from the ring.
Scene spinner() {
  Scene scene = coarse_scene();
  BodyDef ring = body_with(capsule_shape(1, 0.25), {0, 0}, BodyType::fixed);
  ring.shapes.clear();
  constexpr int pieces = 90;
  const auto corner = [](int i) {
    const double angle = 2 * std::numbers::pi * i / pieces;
    return ring_radius * Vec2d{elementary::cos(angle), elementary::sin(angle)};
  };
  for (int i = 0; i < pieces; ++i) {
    ShapeDef& piece = ring.shapes.emplace_back();
    piece.points = {corner(i), corner(i + 1)};
    piece.radius = 0.25;
  }
  scene.bodies = {ring, body_with(box_shape(0.4, 20), pivot)};
  scene.joints = {joint_between(JointKind::revolute, BodyId::world, pivot, paddle, {0, 0})};
  const ShapeDef shapes[] = {capsule_shape(0.12, 0.12), disc_shape(0.2), box_shape(0.4, 0.4)};
  for (int i = 0; i < crowd; ++i) {
    const Vec2d place{-8 + 0.5 * (i % 33), 2 + 0.5 * (i / 33) * (i % 2 == 0 ? 1 : -1)};
    scene.bodies.push_back(body_with(shapes[i % 3], place));
  }
  return scene;
}

/// The torque of a motor of at most 10 kN m that would have the paddle turn at 5 rad/s.
ApplyTorque motor(const Simulation& simulation) {
  return {paddle, std::clamp(2000 * (5 - simulation.body(paddle).spin), -1e4, 1e4)};
}

/// Ten boxes on a floor, everything `far` metres to the right and above.
Scene stack_at(double far) {
  Scene scene;
  scene.method.substeps = 4;
  scene.bodies = {floor_body()};
  for (int i = 0; i < 10; ++i) scene.bodies.push_back(body_with(box_shape(0.8, 0.8), {0, 0.4 + 0.8 * i}));
  for (BodyDef& body : scene.bodies) body.position += Vec2d{far, far};
  return scene;
}

}  // namespace

TEST_CASE("A paddle that stirs a crowd with all its might drives nobody out of the ring", "[hard]") {
  auto simulation = simulate(spinner());
  for (int i = 0; i < turning_ticks; ++i) {
    simulation->apply(motor(*simulation));
    simulation->step();
  }
  REQUIRE_FALSE(simulation->failure());
  int escaped = 0;
  for (int i = 3; i < 3 + crowd; ++i) escaped += length(simulation->body(BodyId(i)).center) > ring_radius ? 1 : 0;
  CHECK(escaped == 0);
}

TEST_CASE("A stack stands ten thousand kilometres away as it does at the origin, to a millimetre", "[hard]") {
  // A float has seven digits: a kilometre away it knows places to a sixteenth of a millimetre.
  const double far = pick(1e7, 1e3);
  auto here = simulate(stack_at(0));
  auto there = simulate(stack_at(far));
  run(*here, 10);
  run(*there, 10);
  for (int i = 2; i <= 11; ++i) {
    const Vec2d moved = there->body(BodyId(i)).position - Vec2d{far, far} - here->body(BodyId(i)).position;
    INFO("box " << i - 1 << " is off by " << moved.x << ", " << moved.y);
    CHECK(length(moved) < 1e-3);
    CHECK(length(there->body(BodyId(i)).velocity) < 0.01);
  }
}

TEST_CASE("Boxes rest on a floor of two thousand kilometres", "[hard]") {
  Scene scene = coarse_scene();
  scene.bodies = {body_with(box_shape(2e6, 1), {0, -0.5}, BodyType::fixed)};
  for (int i = 0; i < 3; ++i) scene.bodies.push_back(body_with(box_shape(1, 1), {2.0 * i, 1.0 + i}));
  auto simulation = simulate(scene);
  run(*simulation, 10, scene.rate);
  for (int i = 2; i <= 4; ++i) {
    const BodyState box = simulation->body(BodyId(i));
    CHECK(box.position.y == Approx(0.5).margin(0.1));
    CHECK(length(box.velocity) < 0.1);
  }
}
