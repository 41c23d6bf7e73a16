#include <catch2/catch.hpp>
#include <cmath>

#include "tests/engine/random.h"
#include "tests/engine/scenes.h"

using namespace proofreel;
using namespace proofreel::test;

namespace {

constexpr double g = 9.81;

/// How far a box has slid down a 30 degree ramp after two seconds.
double slid_down(double at_rest, double sliding) {
  const double slope = 3.14159265358979323846 / 6;
  const Vec2d up{-std::sin(slope), std::cos(slope)};
  Scene scene;
  scene.bodies = {body_with(box_shape(40, 0.4), {0, 0}, BodyType::fixed), body_with(box_shape(0.4, 0.4), 0.4 * up)};
  for (BodyDef& body : scene.bodies) {
    body.angle = slope;
    body.shapes[0].friction = {at_rest, sliding};
  }
  auto simulation = simulate(scene);
  run(*simulation, 2);
  const Vec2d way = simulation->body(BodyId{2}).position - 0.4 * up;
  return -dot(way, Vec2d{std::cos(slope), std::sin(slope)});
}

}  // namespace

TEST_CASE("Free fall is exact: a constant force makes the verlet integrator's path the parabola itself", "[world]") {
  Scene scene;
  scene.bodies = {body_with(disc_shape(0.1), {0, 10})};
  scene.bodies[0].velocity = {3, 5};
  auto simulation = simulate(scene);
  run(*simulation, 1);
  const BodyState state = simulation->body(BodyId{1});
  CHECK(state.position.x == Approx(3).margin(pick(1e-12, 1e-4)));
  CHECK(state.position.y == Approx(10.095).margin(pick(1e-12, 1e-4)));
  CHECK(state.velocity.y == Approx(5 - g).margin(pick(1e-12, 1e-4)));
}

TEST_CASE("Symplectic Euler falls short by exactly g T h / 2", "[world]") {
  Scene scene;
  scene.method.integrator = Integrator::symplectic_euler;
  scene.bodies = {body_with(disc_shape(0.1), {0, 10})};
  auto simulation = simulate(scene);
  run(*simulation, 1);
  const double h = 1.0 / 480;
  CHECK(simulation->body(BodyId{1}).position.y == Approx(10 - g / 2 - g * h / 2).margin(pick(1e-12, 1e-4)));
}

TEST_CASE("A spinning body turns by spin times time and its angle never wraps", "[world]") {
  Scene scene;
  scene.gravity = {0, 0};
  scene.bodies = {body_with(box_shape(1, 2), {0, 0})};
  scene.bodies[0].spin = 7;
  scene.bodies[0].angle = 0.5;
  auto simulation = simulate(scene);
  run(*simulation, 10);
  CHECK(simulation->body(BodyId{1}).angle == Approx(70.5).margin(pick(1e-10, 2e-2)));
  Snapshot snapshot;
  simulation->observe(snapshot);
  CHECK(snapshot.bodies[0].pose.rotation.c == Approx(std::cos(70.5)).margin(pick(1e-11, 1e-3)));
}

TEST_CASE("An off-centre shape turns about its centre of mass, not about its origin", "[world]") {
  Scene scene;
  scene.gravity = {0, 0};
  ShapeDef disc = disc_shape(0.2);
  disc.points = {{1, 0}};
  scene.bodies = {body_with(disc, {0, 0})};
  scene.bodies[0].spin = 3.14159265358979323846;
  auto simulation = simulate(scene);
  run(*simulation, 1);
  CHECK(simulation->body(BodyId{1}).center.x == Approx(1).margin(1e-6));
  CHECK(simulation->body(BodyId{1}).position.x == Approx(2).margin(1e-4));
}

TEST_CASE("A kinematic body turns about its origin", "[world]") {
  Scene scene;
  ShapeDef arm = box_shape(2, 0.2);
  for (Vec2d& p : arm.points) p.x += 1;
  scene.bodies = {body_with(arm, {3, 4}, BodyType::kinematic)};
  scene.bodies[0].spin = 1;
  auto simulation = simulate(scene);
  run(*simulation, 2);
  CHECK(simulation->body(BodyId{1}).position == Vec2d{3, 4});
  CHECK(simulation->body(BodyId{1}).angle == Approx(2).epsilon(1e-5));
}

TEST_CASE("A resting box reports no velocity and is carried by m g", "[world]") {
  auto simulation = simulate(with_floor(body_with(box_shape(1, 1), {0, 0.5})));
  run(*simulation, 3);
  const BodyState box = simulation->body(BodyId{2});
  CHECK(length(box.velocity) < pick(1e-13, 1e-5));
  CHECK(box.position.y == Approx(0.5).margin(1e-3));
  double impulse = 0;
  for (const ContactView& contact : simulation->contacts()) {
    for (int k = 0; k < contact.point_count; ++k) impulse += contact.points[k].normal_impulse;
  }
  CHECK(impulse * 240 == Approx(box.mass * g).epsilon(1e-4));
}

TEST_CASE("A stack of ten boxes comes to rest where it was built", "[world]") {
  Scene scene;
  scene.bodies = {floor_body()};
  for (int i = 0; i < 10; ++i) scene.bodies.push_back(body_with(box_shape(0.8, 0.8), {0, 0.4 + 0.8 * i}));
  auto simulation = simulate(scene);
  run(*simulation, 10);
  const BodyState top = simulation->body(BodyId{11});
  CHECK(top.position.y == Approx(7.6).margin(0.01));
  CHECK(std::abs(top.position.x) < 0.01);
  CHECK(length(top.velocity) < 1e-3);
}

TEST_CASE("Boxes stay on the ramp exactly when static friction exceeds the slope", "[world]") {
  CHECK(slid_down(0.60, 0.60) < 1e-3);
  CHECK(slid_down(0.80, 0.80) < 1e-3);
  CHECK(slid_down(0.57, 0.57) > 0.1);
}

TEST_CASE("A sliding box goes as far as Coulomb says", "[world]") {
  for (const double mu : {0.1, 0.3, 0.5}) {
    const double truth = 2 * g * (0.5 - mu * std::sqrt(0.75));
    CHECK(slid_down(mu, mu) == Approx(truth).margin(pick(1e-3, 2e-3)));
  }
}

TEST_CASE("Static friction holds what kinetic friction could not stop", "[world]") {
  CHECK(slid_down(0.7, 0.2) < 1e-3);
  const double truth = 2 * g * (0.5 - 0.2 * std::sqrt(0.75));
  CHECK(slid_down(0.5, 0.2) == Approx(truth).epsilon(0.01));
}

TEST_CASE("Friction stops a sliding block after v^2 / (2 mu g)", "[world]") {
  Scene scene = with_floor(body_with(box_shape(1, 0.1), {-10, 0.05}));
  scene.bodies[1].velocity = {5, 0};
  for (BodyDef& body : scene.bodies) body.shapes[0].friction = {0.4, 0.4};
  auto simulation = simulate(scene);
  run(*simulation, 3);
  CHECK(simulation->body(BodyId{2}).position.x + 10 == Approx(3.18552497451).epsilon(2e-3));
  CHECK(length(simulation->body(BodyId{2}).velocity) < pick(1e-9, 1e-4));
}

TEST_CASE("Filters decide what meets: a negative group never does, masks must agree both ways", "[world]") {
  const auto meets = [](FilterDef a, FilterDef b) {
    Scene scene;
    scene.gravity = {0, 0};
    scene.bodies = {body_with(disc_shape(0.5), {0, 0}), body_with(disc_shape(0.5), {0.8, 0})};
    scene.bodies[0].filter = a;
    scene.bodies[1].filter = b;
    auto simulation = simulate(scene);
    run(*simulation, 0.5);
    return simulation->body(BodyId{2}).position.x > 0.81;
  };
  CHECK(meets({}, {}));
  CHECK_FALSE(meets({-1, 1, 1}, {-1, 1, 1}));
  CHECK(meets({-1, 1, 1}, {-2, 1, 1}));
  CHECK(meets({3, 1, 1}, {3, 1, 1}));
  CHECK_FALSE(meets({0, 2, 2}, {0, 4, 4}));
  CHECK_FALSE(meets({0, 2, 4}, {0, 4, 4}));
  CHECK(meets({0, 2, 4}, {0, 4, 2}));
}

TEST_CASE("A sensor reports what passes and pushes nothing", "[world]") {
  Scene scene;
  scene.bodies = {body_with(box_shape(4, 0.2), {0, 0}, BodyType::fixed), body_with(disc_shape(0.2), {0, 1})};
  scene.bodies[0].sensor = true;
  auto simulation = simulate(scene);
  int reports = 0;
  for (int i = 0; i < 240; ++i) {
    simulation->step();
    reports += static_cast<int>(simulation->contact_events().size());
  }
  CHECK(reports == 1);
  CHECK(simulation->body(BodyId{2}).position.y == Approx(1 - g / 2).epsilon(1e-4));
}

TEST_CASE("A body of fixed rotation is pushed but never turns", "[world]") {
  Scene scene = with_floor(body_with(box_shape(1, 1), {0, 2}));
  scene.bodies[1].fixed_rotation = true;
  scene.bodies[1].angle = 0.4;
  auto simulation = simulate(scene);
  run(*simulation, 2);
  CHECK(simulation->body(BodyId{2}).angle == Approx(0.4));
  CHECK(length(simulation->body(BodyId{2}).velocity) < 1e-3);
}

TEST_CASE("The same scene takes the same bits every time", "[world]") {
  const auto chain = [] {
    Random random(4);
    Scene scene;
    scene.bodies = {floor_body()};
    for (int i = 0; i < 60; ++i) {
      const ShapeDef shape = i % 3 == 0 ? box_shape(0.5, 0.3) : disc_shape(0.2);
      scene.bodies.push_back(body_with(shape, {random.between(-2, 2), random.between(1, 6)}));
      scene.bodies.back().shapes[0].restitution = 0.1 * (i % 4);
    }
    auto simulation = simulate(scene);
    std::uint64_t hash = chained_hash(0, simulation->state_hash());
    for (int i = 0; i < 480; ++i) {
      simulation->step();
      hash = chained_hash(hash, simulation->state_hash());
    }
    return hash;
  };
  CHECK(chain() == chain());
}

TEST_CASE("The state hash sees the smallest change of any coordinate", "[world]") {
  Scene scene;
  scene.bodies = {body_with(disc_shape(0.5), {1, 3})};
  const std::uint64_t before = simulate(scene)->state_hash();
  scene.bodies[0].position.x = std::nextafter(static_cast<real>(1), static_cast<real>(2));
  CHECK(simulate(scene)->state_hash() != before);
}

TEST_CASE("A number that is not finite stops the simulation and names tick, body and stage", "[world]") {
  Scene scene;
  scene.bodies = {body_with(disc_shape(0.1), {1, 0})};
  JointDef spring = joint_between(JointKind::spring, BodyId::world, {0, 0}, BodyId{1}, {0, 0}, 0.5);
  spring.stiffness = 1e300;
  scene.joints = {spring};
  scene.method.precision = is_double ? Precision::float64 : Precision::float32;
  auto simulation = simulate(scene);
  run(*simulation, 1);
  REQUIRE(simulation->failure());
  CHECK(simulation->failure()->body == BodyId{1});
  CHECK(simulation->failure()->stage == "springs");
  const std::int64_t stopped = simulation->tick();
  simulation->step();
  CHECK(simulation->tick() == stopped);
}

TEST_CASE("Pairs found by the broad phase are all the shapes whose boxes overlap", "[world]") {
  Random random(21);
  Scene scene;
  scene.gravity = {0, 0};
  for (int i = 0; i < 80; ++i) {
    scene.bodies.push_back(
        body_with(disc_shape(random.between(0.1, 0.4)), {random.between(-4, 4), random.between(-4, 4)}));
    scene.bodies.back().sensor = true;  // keeps them where they are going
    scene.bodies.back().velocity = {random.between(-3, 3), random.between(-3, 3)};
  }
  auto simulation = simulate(scene);
  for (int tick = 0; tick < 120; ++tick) {
    Snapshot before;
    simulation->observe(before);
    simulation->step();
    int overlaps_found = 0;
    for (const ContactView& contact : simulation->contacts()) {
      for (int k = 0; k < contact.point_count; ++k) overlaps_found += contact.points[k].separation <= 0 ? 1 : 0;
    }
    int truth = 0;
    for (std::size_t i = 0; i < before.bodies.size(); ++i) {
      for (std::size_t j = i + 1; j < before.bodies.size(); ++j) {
        const double radii = scene.bodies[i].shapes[0].radius + scene.bodies[j].shapes[0].radius;
        truth += distance(before.bodies[i].pose.position, before.bodies[j].pose.position) <= radii ? 1 : 0;
      }
    }
    REQUIRE(std::abs(overlaps_found - truth) <= (is_double ? 0 : 1));
  }
}
