#include <catch2/catch.hpp>

#include "engine/elementary.h"
#include "tests/engine/scenes.h"

using namespace proofreel;
using namespace proofreel::test;

namespace {

/// A disc of 2 kg that nothing else acts on.
Scene one_disc(Vec2d velocity) {
  Scene scene;
  scene.gravity = {0, 0};
  BodyDef body = body_with(disc_shape(0.5), {0, 0});
  body.mass = 2;
  body.velocity = velocity;
  scene.bodies = {body};
  return scene;
}

BodyState after(const Scene& scene, double seconds) {
  const auto simulation = simulate(scene);
  run(*simulation, seconds, scene.rate);
  return simulation->body(BodyId{1});
}

Vec2d momentum(const Simulation& simulation, int bodies) {
  Vec2d sum;
  for (int i = 1; i <= bodies; ++i) {
    const BodyState state = simulation.body(static_cast<BodyId>(i));
    sum += state.mass * state.velocity;
  }
  return sum;
}

/// How much farther from the truth twice the step is, as a power of two.
template <typename ErrorAtRate>
double order(const ErrorAtRate& error) {
  return std::log2(std::abs(error(60)) / std::abs(error(120)));
}

}  // namespace

TEST_CASE("Linear drag alone slows a body exponentially, to rounding") {
  Scene scene = one_disc({3, -4});
  scene.drag.linear = 1.5;
  const BodyState state = after(scene, 2);
  const double left = elementary::exp(-1.5);
  CHECK(state.velocity.x == Approx(3 * left).epsilon(pick(1e-12, 1e-5)));
  CHECK(state.velocity.y == Approx(-4 * left).epsilon(pick(1e-12, 1e-5)));
}

TEST_CASE("Quadratic drag alone slows a body hyperbolically, to rounding") {
  Scene scene = one_disc({5, 0});
  scene.drag.quadratic = 0.8;
  CHECK(after(scene, 3).velocity.x == Approx(5 / (1 + 0.4 * 5 * 3)).epsilon(pick(1e-12, 1e-5)));
}

TEST_CASE("Both kinds of drag together solve the Bernoulli equation") {
  Scene scene = one_disc({5, 0});
  scene.drag = {0.6, 0.8, 0};
  const double e = elementary::exp(-0.3 * 2);
  CHECK(after(scene, 2).velocity.x == Approx(5 * e / (1 + 0.8 / 0.6 * 5 * (1 - e))).epsilon(pick(1e-12, 1e-5)));
}

TEST_CASE("A falling body reaches the speed at which drag carries its weight") {
  Scene scene = one_disc({0, 0});
  scene.gravity = {0, -10};
  scene.drag.quadratic = 0.2;
  CHECK(after(scene, 20).velocity.y == Approx(-10).epsilon(1e-4));
}

TEST_CASE("With drag and gravity together verlet stays second order") {
  const auto error = [](int rate) {
    Scene scene = one_disc({0, 0});
    scene.rate = rate;
    scene.method.substeps = 1;
    scene.gravity = {0, -10};
    scene.drag.linear = 2;
    const double truth = -10 * (1 - elementary::exp(-1.0));
    return after(scene, 1).velocity.y - truth;
  };
  if (is_double) CHECK(order(error) == Approx(2).margin(0.05));
}

TEST_CASE("No drag however strong turns a body round") {
  Scene scene = one_disc({1, 2});
  scene.drag = {1e6, 1e6, 1e6};
  scene.bodies[0].spin = 3;
  const BodyState state = after(scene, 1);
  CHECK(state.velocity.x >= 0);
  CHECK(state.velocity.y >= 0);
  CHECK(state.spin >= 0);
  CHECK(length(state.velocity) < 1e-6);
}

TEST_CASE("Wind carries along what drag holds to it") {
  Scene scene = one_disc({0, 0});
  scene.drag.linear = 4;
  scene.wind = {3, 1};
  const double gained = 1 - elementary::exp(-2.0);
  const BodyState state = after(scene, 1);
  CHECK(state.velocity.x == Approx(3 * gained).epsilon(pick(1e-12, 1e-5)));
  CHECK(state.velocity.y == Approx(gained).epsilon(pick(1e-12, 1e-5)));
}

TEST_CASE("A body's own drag counts instead of the scene's") {
  Scene scene = one_disc({1, 0});
  scene.drag.linear = 4;
  scene.bodies[0].drag = DragDef{};
  CHECK(after(scene, 1).velocity.x == 1);
}

TEST_CASE("Around an attractor a circular orbit comes back, and its energy stays") {
  Scene scene = one_disc({0, 2});
  scene.bodies[0].position = {1, 0};
  scene.attractors = {{std::nullopt, {0, 0}, 4, AttractionLaw::inverse_square}};
  const auto simulation = simulate(scene);
  CHECK(simulation->energy().potential == Approx(-8));
  run(*simulation, 3.14159265);
  const BodyState state = simulation->body(BodyId{1});
  CHECK(length(state.position - Vec2d{1, 0}) < 2e-2);
  CHECK(simulation->energy().total() == Approx(-4).epsilon(pick(1e-6, 1e-4)));
}

TEST_CASE("Whatever moves a kinematic body that attracts does the work of it") {
  const Integrator integrator = GENERATE(Integrator::verlet, Integrator::rk4);
  Scene scene;
  scene.gravity = {0, 0};
  scene.method.integrator = integrator;
  scene.bodies = {body_with(disc_shape(0.1), {0, 0}, BodyType::kinematic), body_with(disc_shape(0.1), {2, 0})};
  for (BodyDef& body : scene.bodies) body.filter.group = -1;
  scene.bodies[0].velocity = {-1, 0};
  scene.attractors = {{BodyId{1}, {}, 9, AttractionLaw::linear}};
  const auto simulation = simulate(scene);
  const double before = simulation->energy().total();
  run(*simulation, 1.3);
  const Energy after = simulation->energy();
  CHECK(std::abs(after.booked_work) > 1e-3);
  CHECK(after.total() - after.booked_work == Approx(before).epsilon(pick(2e-4, 1e-3)));
}

TEST_CASE("A linear attractor swings a body like a spring") {
  Scene scene = one_disc({0, 0});
  scene.bodies[0].position = {2, 0};
  scene.attractors = {{std::nullopt, {0, 0}, 9, AttractionLaw::linear}};
  CHECK(after(scene, 1).position.x == Approx(2 * elementary::cos(3.0)).epsilon(1e-3));
  CHECK(simulate(scene)->energy().potential == Approx(0.5 * 2 * 9 * 4));
}

TEST_CASE("A body that attracts is attracted, so that momentum stays") {
  Scene scene = one_disc({0, 1});
  scene.bodies[0].position = {2, 0};
  BodyDef heavy = body_with(disc_shape(0.5), {0, 0});
  heavy.mass = 5;
  scene.bodies.push_back(heavy);
  scene.attractors = {{BodyId{2}, {}, 3, AttractionLaw::inverse_square}};
  const auto simulation = simulate(scene);
  const Vec2d before = momentum(*simulation, 2);
  const double energy = simulation->energy().total();
  run(*simulation, 1);
  CHECK(length(momentum(*simulation, 2) - before) < pick(1e-12, 1e-5));
  CHECK(simulation->energy().total() == Approx(energy).epsilon(1e-4));
  CHECK(simulation->body(BodyId{2}).velocity.x > 0);
}

TEST_CASE("Bodies that attract each other keep momentum, angular momentum and energy") {
  Scene scene;
  scene.gravity = {0, 0};
  const Vec2d places[] = {{-2, 0}, {2, 0.5}, {0, 3}};
  const Vec2d velocities[] = {{0, 0.5}, {0.3, -0.5}, {-0.4, 0}};
  for (int i = 0; i < 3; ++i) {
    BodyDef body = body_with(disc_shape(0.1), places[i]);
    body.mass = 1 + i;
    body.velocity = velocities[i];
    scene.bodies.push_back(body);
  }
  scene.gravitational_constant = 1;
  const auto simulation = simulate(scene);
  const auto angular = [&] {
    double sum = 0;
    for (int i = 1; i <= 3; ++i) {
      const BodyState s = simulation->body(static_cast<BodyId>(i));
      sum += s.mass * cross(s.position, s.velocity);
    }
    return sum;
  };
  const Vec2d momentum_before = momentum(*simulation, 3);
  const double angular_before = angular();
  const double energy_before = simulation->energy().total();
  run(*simulation, 2);
  CHECK(length(momentum(*simulation, 3) - momentum_before) < pick(1e-12, 1e-5));
  CHECK(angular() == Approx(angular_before).epsilon(pick(1e-10, 1e-4)));
  CHECK(simulation->energy().total() == Approx(energy_before).epsilon(1e-4));
}

TEST_CASE("A rocket in free space obeys Tsiolkovsky's equation to rounding") {
  Scene scene = one_disc({0, 0});
  scene.bodies[0].mass = 400;
  scene.rockets = {{BodyId{1}, 1500, 60, 300, {0, 0}}};
  const BodyState burning = after(scene, 2);
  CHECK(burning.velocity.y == Approx(25 * elementary::log(400.0 / 280)).epsilon(pick(1e-12, 1e-4)));
  CHECK(burning.mass == Approx(280));
  const BodyState burnt_out = after(scene, 6);
  CHECK(burnt_out.velocity.y == Approx(25 * elementary::log(4.0)).epsilon(pick(1e-12, 1e-4)));
  CHECK(burnt_out.mass == Approx(100));
}

TEST_CASE("What a rocket does is booked as work") {
  Scene scene = one_disc({1, 0});
  scene.gravity = {0, -3};
  scene.bodies[0].mass = 10;
  scene.rockets = {{BodyId{1}, 50, 2, 6, {0.2, -0.5}}};
  const auto simulation = simulate(scene);
  const double before = simulation->energy().total();
  run(*simulation, 2);
  const Energy energy = simulation->energy();
  CHECK(energy.total() - energy.booked_work == Approx(before).margin(pick(1e-9, 1e-2)));
  CHECK(simulation->body(BodyId{1}).spin > 0);
}

TEST_CASE("Forces that are on with nothing to act on change no bit") {
  Scene scene = one_disc({1, 2});
  scene.gravity = {0, -9.81};
  const auto plain = simulate(scene);
  scene.effects = EffectSet{};
  for (const Effect effect : {Effect::gravity, Effect::drag, Effect::wind, Effect::attractor, Effect::nbody,
                              Effect::rocket, Effect::springs}) {
    scene.effects->add(effect);
  }
  const auto all = simulate(scene);
  for (int i = 0; i < 240; ++i) {
    plain->step();
    all->step();
    REQUIRE(plain->state_hash() == all->state_hash());
  }
}
