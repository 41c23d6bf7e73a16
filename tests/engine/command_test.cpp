#include <catch2/catch.hpp>

#include "tests/engine/scenes.h"

using namespace proofreel;
using namespace proofreel::test;

namespace {

constexpr double g = 9.81;

}  // namespace

TEST_CASE("Nothing pushes a kinematic body, and its work is booked", "[command]") {
  Scene scene;
  scene.bodies = {body_with(box_shape(4, 0.4), {0, 0}, BodyType::kinematic), body_with(box_shape(1, 1), {0, 0.7})};
  scene.bodies[0].velocity = {0, 0.5};
  auto simulation = simulate(scene);
  run(*simulation, 4);
  CHECK(simulation->body(BodyId{1}).position.y == Approx(2).epsilon(1e-5));
  CHECK(simulation->body(BodyId{2}).position.y == Approx(2.7).epsilon(1e-2));
  const Energy energy = simulation->energy();
  // Lifted by 2 m and moving: all of it came from the lift.
  const double mass = simulation->body(BodyId{2}).mass;
  CHECK(energy.total() - mass * g * 0.7 == Approx(energy.booked_work).epsilon(0.02));
}

TEST_CASE("A pushed body's work is booked to the last digits", "[command]") {
  Scene scene;
  scene.bodies = {body_with(disc_shape(0.5), {0, 3})};
  auto simulation = simulate(scene);
  const double start = simulation->energy().total();
  for (int i = 0; i < 240; ++i) {
    simulation->apply(ApplyForce{BodyId{1}, {2, 5}, std::nullopt});
    simulation->apply(ApplyTorque{BodyId{1}, 0.5});
    if (i % 50 == 0) simulation->apply(ApplyImpulse{BodyId{1}, {-1, 0.3}, Vec2d{0.2, 3}});
    simulation->step();
  }
  const Energy energy = simulation->energy();
  CHECK(energy.total() - energy.booked_work == Approx(start).margin(pick(1e-10, 1e-3)));
}

TEST_CASE("A removed body is gone with its contacts and joints, and its id is not used again", "[command]") {
  Scene scene = with_floor(body_with(box_shape(1, 1), {0, 0.5}));
  scene.joints = {joint_between(JointKind::distance, BodyId::world, {0, 3}, BodyId{2}, {0, 0}, 2.5)};
  auto simulation = simulate(scene);
  run(*simulation, 0.1);
  simulation->apply(RemoveBody{BodyId{2}});
  CHECK_FALSE(simulation->exists(BodyId{2}));
  CHECK_FALSE(simulation->exists(JointId{0}));
  CHECK(simulation->contacts().empty());
  simulation->apply(CreateBody{body_with(disc_shape(0.5), {0, 2})});
  CHECK(simulation->exists(BodyId{3}));
  run(*simulation, 2);
  CHECK(simulation->body(BodyId{3}).position.y == Approx(0.5).margin(1e-3));
  Snapshot snapshot;
  simulation->observe(snapshot);
  CHECK(snapshot.bodies.size() == 2);
}

TEST_CASE("A body made later lands on what was alone before", "[command]") {
  Scene scene;
  scene.bodies = {floor_body()};
  auto simulation = simulate(scene);
  run(*simulation, 0.5);
  simulation->apply(CreateBody{body_with(disc_shape(0.5), {0, 1})});
  run(*simulation, 1);
  CHECK(simulation->body(BodyId{2}).position.y == Approx(0.5).margin(1e-3));
}

TEST_CASE("Changing a body keeps what the change does not name", "[command]") {
  Scene scene;
  scene.gravity = {0, 0};
  scene.bodies = {body_with(box_shape(1, 1), {0, 0})};
  scene.bodies[0].velocity = {1, 0};
  scene.bodies[0].spin = 2;
  auto simulation = simulate(scene);
  ChangeBody change;
  change.body = BodyId{1};
  change.position = Vec2d{5, 5};
  simulation->apply(change);
  CHECK(simulation->body(BodyId{1}).position == Vec2d{5, 5});
  CHECK(simulation->body(BodyId{1}).velocity == Vec2d{1, 0});
  change = {};
  change.body = BodyId{1};
  change.density = 4;
  simulation->apply(change);
  CHECK(simulation->body(BodyId{1}).mass == Approx(4));
  CHECK(simulation->body(BodyId{1}).spin == Approx(2));
  change = {};
  change.body = BodyId{1};
  change.type = BodyType::fixed;
  simulation->apply(change);
  CHECK(simulation->body(BodyId{1}).velocity == Vec2d{0, 0});
}

TEST_CASE("A change of material does not make resting bodies meet anew", "[command]") {
  auto simulation = simulate(with_floor(body_with(box_shape(1, 1), {0, 0.5})));
  run(*simulation, 2);
  ChangeBody change;
  change.body = BodyId{2};
  change.friction = FrictionDef{0.2, 0.1};
  simulation->apply(change);
  simulation->step();
  CHECK(simulation->contact_events().empty());
  CHECK(length(simulation->body(BodyId{2}).velocity) < pick(1e-9, 1e-5));
}

TEST_CASE("A body that was set static pushes nobody with the gravity it no longer feels", "[command]") {
  Scene scene;
  scene.bodies = {body_with(box_shape(4, 0.4), {0, 0}), body_with(disc_shape(0.2), {0, 2})};
  scene.bodies[1].shapes[0].restitution = 1;
  auto simulation = simulate(scene);
  run(*simulation, 0.1);
  ChangeBody change;
  change.body = BodyId{1};
  change.type = BodyType::fixed;
  simulation->apply(change);
  const double start = simulation->energy().total();
  run(*simulation, 5);
  CHECK(simulation->energy().total() == Approx(start).epsilon(pick(1e-9, 1e-3)));
}

TEST_CASE("A new shape moves the centre of mass and leaves joints and motion where they were", "[command]") {
  Scene scene;
  scene.gravity = {0, 0};
  scene.bodies = {body_with(disc_shape(0.2), {1, 0})};
  scene.joints = {joint_between(JointKind::revolute, BodyId::world, {0, 0}, BodyId{1}, {-1, 0})};
  scene.bodies[0].velocity = {0, 2};
  scene.bodies[0].spin = 2;  // turns about the hinge
  auto simulation = simulate(scene);
  ChangeBody change;
  change.body = BodyId{1};
  ShapeDef off_centre = box_shape(0.4, 0.2);
  for (Vec2d& p : off_centre.points) p.x += 0.5;
  change.shapes = std::vector{off_centre};
  simulation->apply(change);
  CHECK(simulation->joint(JointId{0}).gap < pick(1e-14, 1e-6));
  CHECK(simulation->body(BodyId{1}).center.x == Approx(1.5));
  CHECK(simulation->body(BodyId{1}).velocity.y == Approx(3));  // 1.5 m from the hinge at 2 rad/s
  CHECK(simulation->body(BodyId{1}).position == Vec2d{1, 0});
}
