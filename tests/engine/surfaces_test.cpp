// Surfaces that resist rolling, and surfaces that move.

#include <catch2/catch.hpp>
#include <cmath>

#include "tests/engine/scenes.h"

using namespace proofreel;
using namespace proofreel::test;

namespace {

constexpr double g = 9.81;
constexpr double radius = 0.5;
constexpr double lever = 0.02;
constexpr BodyId subject{2};  ///< the floor is body 1

/// A disc that rolls along the floor to the right without slipping; the floor resists.
Scene rolling_disc(double speed) {
  Scene scene;
  scene.bodies = {floor_body(), body_with(disc_shape(radius), {0, radius})};
  scene.bodies[0].shapes[0].rolling_resistance = lever;
  scene.bodies[1].velocity = {speed, 0};
  scene.bodies[1].spin = -speed / radius;
  return scene;
}

/// The same at rest on a slope: gravity leans instead of the floor.
Scene disc_on_slope(double tangent) {
  Scene scene = rolling_disc(0);
  const double cosine = 1 / std::sqrt(1 + tangent * tangent);
  scene.gravity = {g * tangent * cosine, -g * cosine};
  return scene;
}

/// A body on a belt whose upper side moves with `speed` to the right; the coefficient of friction is 0.5.
Scene on_belt(const ShapeDef& shape, double height, double speed) {
  Scene scene;
  scene.bodies = {floor_body(), body_with(shape, {0, height})};
  scene.bodies[0].shapes[0].surface_speed = -speed;
  return scene;
}

BodyState after(const Scene& scene, double seconds) {
  const auto simulation = simulate(scene);
  run(*simulation, seconds, scene.rate);
  return simulation->body(subject);
}

}  // namespace

TEST_CASE("A rolling disc is slowed evenly, by g (r/R) / (1 + I/(m R^2))") {
  const double a = g * (lever / radius) / 1.5;
  const double seconds = GENERATE(0.5, 1.0, 3.0);
  const BodyState state = after(rolling_disc(3), seconds);
  CHECK(state.velocity.x == Approx(3 - a * seconds).epsilon(5e-4));
  CHECK(state.spin == Approx(-state.velocity.x / radius).epsilon(1e-3));
  CHECK(state.position.x == Approx(3 * seconds - a * seconds * seconds / 2).epsilon(2e-4));
}

TEST_CASE("A rolling disc stops where that law says, and stays") {
  const double a = g * (lever / radius) / 1.5;
  const auto simulation = simulate(rolling_disc(0.5));
  run(*simulation, 0.5 / a + 1);
  const BodyState stopped = simulation->body(subject);
  CHECK(stopped.position.x == Approx(0.25 / (2 * a)).epsilon(pick(2e-3, 1e-2)));
  CHECK(length(stopped.velocity) < pick(1e-9, 1e-6));
  run(*simulation, 10);
  CHECK(simulation->body(subject).position.x == Approx(stopped.position.x).margin(pick(1e-10, 1e-5)));
}

TEST_CASE("On a slope a disc stays while tan < r/R, and rolls above it at the rate the excess gives") {
  const double tangent = GENERATE(0.01, 0.035, 0.045, 0.2);
  const double limit = lever / radius;
  const BodyState state = after(disc_on_slope(tangent), 4);
  if (tangent < limit) {
    CHECK(std::abs(state.position.x) < 1e-4);
    CHECK(std::abs(state.velocity.x) < pick(1e-9, 1e-5));
  } else {
    const double cosine = 1 / std::sqrt(1 + tangent * tangent);
    CHECK(state.velocity.x == Approx(g * cosine * (tangent - limit) / 1.5 * 4).epsilon(5e-3));
  }
}

TEST_CASE("Of two rolling resistances the larger counts") {
  Scene scene = rolling_disc(3);
  const double slowed = after(scene, 1).velocity.x;
  scene.bodies[1].shapes[0].rolling_resistance = lever / 2;
  CHECK(after(scene, 1).velocity.x == slowed);
  scene.bodies[1].shapes[0].rolling_resistance = lever;
  scene.bodies[0].shapes[0].rolling_resistance = 0;
  CHECK(after(scene, 1).velocity.x == slowed);
}

TEST_CASE("Rolling resistance takes energy and gives none") {
  const auto simulation = simulate(rolling_disc(3));
  double last = simulation->energy().total();
  for (int i = 0; i < 1200; ++i) {
    simulation->step();
    REQUIRE(simulation->energy().total() <= last + 3e-4);
    last = simulation->energy().total();
  }
  CHECK(simulation->energy().booked_work == Approx(0).margin(pick(1e-12, 1e-5)));
}

TEST_CASE("A kinematic drum drives a disc by rolling resistance alone, and that is booked as work") {
  Scene scene;
  scene.gravity = {0, -g};
  BodyDef drum = body_with(disc_shape(1), {0, -1}, BodyType::kinematic);
  drum.spin = 2;
  drum.shapes[0].friction = {0, 0};
  drum.shapes[0].rolling_resistance = 0.01;
  BodyDef disc = body_with(disc_shape(0.5), {0, 0.5});
  disc.shapes[0].friction = {0, 0};
  scene.bodies = {disc, drum};
  const auto simulation = simulate(scene);
  const double before = simulation->energy().total();
  const BodyState start = simulation->body(BodyId{1});
  run(*simulation, 0.5);
  const double torque = 0.01 * start.mass * g;
  CHECK(simulation->body(BodyId{1}).spin == Approx(torque / start.inertia * 0.5).epsilon(pick(2e-3, 5e-3)));
  const Energy energy = simulation->energy();
  CHECK(energy.booked_work == Approx(torque * 2 * 0.5).epsilon(pick(2e-3, 5e-3)));
  CHECK(energy.total() - energy.booked_work < before);
}

TEST_CASE("A box on a belt gains mu g until it has the belt's speed, and then rides along") {
  const Scene scene = on_belt(box_shape(1, 0.5), 0.25, 2);
  CHECK(after(scene, 0.25).velocity.x == Approx(0.5 * g * 0.25).epsilon(pick(1e-5, 1e-4)));
  const BodyState riding = after(scene, 2);
  CHECK(riding.velocity.x == Approx(2).epsilon(pick(1e-9, 1e-4)));
  CHECK(riding.position.x == Approx(2 * 2 - 2 * 2 / (2 * 0.5 * g)).epsilon(2e-3));
  CHECK(riding.spin == Approx(0).margin(pick(1e-9, 1e-4)));
}

TEST_CASE("A disc on a belt spins up until it rolls, at a third of the belt's speed") {
  const BodyState state = after(on_belt(disc_shape(0.5), 0.5, 3), 2);
  CHECK(state.velocity.x == Approx(1).epsilon(2e-4));
  CHECK(state.spin == Approx(2 / 0.5).epsilon(2e-4));
}

TEST_CASE("A positive surface speed goes round its body counter-clockwise, whichever of the two it is") {
  Scene scene = on_belt(box_shape(1, 0.5), 0.25, 0);
  scene.bodies[0].shapes[0].surface_speed = 2;
  CHECK(after(scene, 1).velocity.x == Approx(-2));  // the upper side goes left
  scene.bodies[0].shapes[0].surface_speed = 0;
  scene.bodies[1].shapes[0].surface_speed = 2;
  CHECK(after(scene, 1).velocity.x == Approx(-2));  // its own lower side goes right, as a tank's tracks do
  std::swap(scene.bodies[0], scene.bodies[1]);
  const auto simulation = simulate(scene);
  run(*simulation, 1);
  CHECK(simulation->body(BodyId{1}).velocity.x == Approx(-2));
}

TEST_CASE("Surface speeds of two shapes add up") {
  Scene scene = on_belt(box_shape(1, 0.5), 0.25, 1);
  scene.bodies[1].shapes[0].surface_speed = -1.5;
  CHECK(after(scene, 2).velocity.x == Approx(2.5));
}

TEST_CASE("A belt's motor gives twice the energy the box gains; friction eats the other half") {
  const auto simulation = simulate(on_belt(box_shape(1, 0.5), 0.25, 2));
  const double mass = simulation->body(subject).mass;
  run(*simulation, 2);
  const Energy energy = simulation->energy();
  CHECK(energy.booked_work == Approx(mass * 4).epsilon(1e-4));
  CHECK(energy.kinetic == Approx(mass * 2).epsilon(pick(1e-9, 1e-4)));
}

TEST_CASE("A ball that bounces on a belt does what one thrown over still ground does, seen from the belt") {
  Scene belt = on_belt(disc_shape(0.5), 2, 3);
  belt.bodies[1].shapes[0].restitution = 0.8;
  Scene still = on_belt(disc_shape(0.5), 2, 0);
  still.bodies[1].shapes[0].restitution = 0.8;
  still.bodies[1].velocity = {-3, 0};
  const BodyState on = after(belt, 1.2);
  const BodyState over = after(still, 1.2);
  CHECK(over.velocity.x > -2.1);  // it has bounced, and been braked
  CHECK(on.velocity.x == Approx(over.velocity.x + 3).epsilon(pick(1e-9, 1e-4)));
  CHECK(on.spin == Approx(over.spin).epsilon(pick(1e-9, 1e-4)));
}

TEST_CASE("Without friction no belt moves anything") {
  Scene scene = on_belt(box_shape(1, 0.5), 0.25, 2);
  scene.bodies[0].shapes[0].friction = scene.bodies[1].shapes[0].friction = {0, 0};
  CHECK_FALSE(effects_of(scene).has(Effect::surface_speed));
  CHECK(after(scene, 1).velocity.x == Approx(0).margin(pick(1e-12, 1e-6)));
}

TEST_CASE("Surfaces that neither move nor resist change no bit when their effects are on") {
  Scene scene = rolling_disc(2);
  scene.bodies[0].shapes[0].rolling_resistance = 0;
  const auto plain = simulate(scene);
  scene.effects = effects_of(scene);
  scene.effects->add(Effect::rolling_resistance);
  scene.effects->add(Effect::surface_speed);
  const auto all = simulate(scene);
  for (int i = 0; i < 240; ++i) {
    plain->step();
    all->step();
    REQUIRE(plain->state_hash() == all->state_hash());
  }
}

TEST_CASE("What a surface does can be changed while it runs") {
  const auto simulation = simulate(on_belt(box_shape(1, 0.5), 0.25, 2));
  run(*simulation, 1);
  ChangeBody change;
  change.body = BodyId{1};
  change.surface_speed = 1;
  simulation->apply(change);
  run(*simulation, 2);
  CHECK(simulation->body(subject).velocity.x == Approx(-1));
  ChangeBody stop;
  stop.body = BodyId{1};
  stop.surface_speed = 0;
  simulation->apply(stop);
  run(*simulation, 1);
  CHECK(simulation->body(subject).velocity.x == Approx(0).margin(1e-6));
}
