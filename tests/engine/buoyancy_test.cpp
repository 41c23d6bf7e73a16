#include "engine/buoyancy.h"

#include <catch2/catch.hpp>
#include <cmath>

#include "engine/elementary.h"
#include "tests/engine/scenes.h"

using namespace proofreel;
using namespace proofreel::test;

namespace {

constexpr double pi = 3.14159265358979323846;
constexpr double g = 9.81;

/// One body over water of 1 kg/m^2 whose level is y = 0.
Scene floating(const ShapeDef& shape, Vec2d position, double drag = 0) {
  Scene scene;
  scene.water = WaterDef{0, 1, drag};
  scene.bodies = {body_with(shape, position)};
  return scene;
}

ShapeDef of_density(ShapeDef shape, double density) {
  shape.density = density;
  return shape;
}

BodyState after(const Scene& scene, double seconds) {
  const auto simulation = simulate(scene);
  run(*simulation, seconds, scene.rate);
  return simulation->body(BodyId{1});
}

/// Half the time between the first two upward crossings of `rest`, doubled: the period of a heave.
double period_about(const Scene& scene, double rest) {
  const auto simulation = simulate(scene);
  std::vector<double> crossings;
  double last = simulation->body(BodyId{1}).center.y - rest;
  while (crossings.size() < 2) {
    simulation->step();
    const double now = simulation->body(BodyId{1}).center.y - rest;
    const double part = last / (last - now);
    if (last < 0 && now >= 0) crossings.push_back((static_cast<double>(simulation->tick() - 1) + part) / scene.rate);
    last = now;
  }
  return crossings[1] - crossings[0];
}

}  // namespace

TEST_CASE("A box of half the water's density comes to float half submerged (Archimedes)") {
  const Scene scene = floating(of_density(box_shape(2, 1), 0.5), {0, 0.3}, 6);
  CHECK(after(scene, 60).center.y == Approx(0).margin(pick(1e-9, 1e-5)));
}

TEST_CASE("A box floats with its density's share below water") {
  const double density = GENERATE(0.1, 0.37, 0.9);
  const Scene scene = floating(of_density(box_shape(3, 1), density), {0, 0}, 8);
  const double draught = 0.5 - after(scene, 80).center.y;
  CHECK(draught == Approx(density).margin(pick(1e-9, 1e-5)));
}

TEST_CASE("A floating box that starts at its draught stays to the last bit") {
  const Scene scene = floating(of_density(box_shape(2, 1), 0.5), {0, 0});
  const BodyState state = after(scene, 5);
  CHECK(state.center == Vec2d{0, 0});
  CHECK(state.velocity == Vec2d{0, 0});
  CHECK(state.spin == 0);
}

TEST_CASE("A submerged disc is pushed up by the weight of the water it displaces") {
  Scene scene = floating(of_density(disc_shape(0.5), 0.25), {0, -40});
  const double a = (1 / 0.25 - 1) * g;
  const BodyState state = after(scene, 1);
  CHECK(state.velocity.y == Approx(a).epsilon(pick(1e-12, 1e-4)));
  CHECK(state.center.y == Approx(-40 + a / 2).epsilon(pick(1e-12, 1e-4)));
  CHECK(state.spin == 0);
}

TEST_CASE("A floating box heaves with the period 2 pi sqrt(m / (rho g w))") {
  const Scene scene = floating(of_density(box_shape(4, 1), 0.5), {0, 0.1});
  const double mass = 0.5 * 4;
  CHECK(period_about(scene, 0) == Approx(2 * pi * std::sqrt(mass / (1 * g * 4))).epsilon(1e-5));
}

TEST_CASE("A wide box rights itself, and a tall narrow one turns over") {
  // With draught T and width w the metacentre lies w^2 / (12 T) above the centre of the wetted part (Bouguer 1746); the
  // centre of mass lies (H - T) / 2 above that.
  const auto [width, height, stable] = GENERATE(
      table<double, double, bool>({{2.0, 1.0, true}, {1.3, 1.0, true}, {1.15, 1.0, false}, {0.5, 2.0, false}}));
  const double draught = 0.5 * height;
  const double metacentric_height = width * width / (12 * draught) - (height - draught) / 2;
  CHECK((metacentric_height > 0) == stable);
  Scene scene = floating(of_density(box_shape(width, height), 0.5), {0, 0}, 2);
  scene.bodies[0].angle = 0.02;
  const double tilt = std::abs(after(scene, 30).angle);
  if (stable) CHECK(tilt < 1e-3);
  if (!stable) CHECK(tilt > 0.3);
}

TEST_CASE("A rolling ship swings with the period its metacentric height gives") {
  Scene scene = floating(of_density(box_shape(3, 1), 0.5), {0, 0});
  scene.bodies[0].angle = 0.01;
  const double mass = 0.5 * 3;
  const double inertia = mass * (9 + 1) / 12;
  const double metacentric_height = 9 / (12 * 0.5) - 0.25;
  const double period = 2 * pi * std::sqrt(inertia / (mass * g * metacentric_height));
  const auto simulation = simulate(scene);
  run(*simulation, period);
  CHECK(simulation->body(BodyId{1}).angle == Approx(0.01).epsilon(0.01));
}

TEST_CASE("Without drag water keeps the energy, that of the displaced water counted") {
  ShapeDef raft = of_density(box_shape(2, 0.6), 0.4);
  raft.radius = 0.15;
  Scene scene = floating(raft, {0, 0.4});
  scene.bodies[0].angle = 0.4;
  scene.bodies[0].velocity = {0.5, -1};
  const double scale = simulate(scene)->body(BodyId{1}).mass * g;
  CHECK(energy_drift(scene, 20) < pick(1e-4, 1e-3) * scale);
  Scene finer = scene;
  finer.rate = 960;
  if (is_double) CHECK(energy_drift(finer, 20) < 0.12 * energy_drift(scene, 20));
}

TEST_CASE("The drag of water only ever takes energy") {
  Scene scene = floating(of_density(box_shape(2, 0.6), 0.4), {0, 0.8}, 3);
  scene.bodies[0].angle = 0.9;
  scene.bodies[0].spin = 2;
  const auto simulation = simulate(scene);
  double last = simulation->energy().total();
  const double noise = pick(1e-5, 1e-4);
  for (int i = 0; i < 2400; ++i) {
    simulation->step();
    const double now = simulation->energy().total();
    REQUIRE(now < last + noise);
    last = now;
  }
}

TEST_CASE("Drag alone slows a submerged disc exponentially, and its spin by its own law") {
  Scene scene = floating(disc_shape(0.5), {0, -9}, 0.7);
  scene.gravity = {0, 0};
  scene.bodies[0].velocity = {3, -1};
  scene.bodies[0].spin = 4;
  // Every element has the same ratio of drag to mass, so everything decays alike.
  const double left = elementary::exp(-0.7 * 2);
  const BodyState state = after(scene, 2);
  CHECK(state.velocity.x == Approx(3 * left).epsilon(pick(1e-12, 1e-4)));
  CHECK(state.velocity.y == Approx(-left).epsilon(pick(1e-12, 1e-4)));
  CHECK(state.spin == Approx(4 * left).epsilon(pick(1e-12, 1e-4)));
}

TEST_CASE("Drag on a half wetted body couples its motion with its spin as the equations say") {
  const WaterDef water{0, 1, 5};
  const Wetted wetted{0.3, {0.02, -0.08}, 0.05};
  Motion motion;
  motion.inv_mass = real(1 / 0.6);
  motion.inv_inertia = real(1 / 0.07);
  motion.velocity = {1, -2};
  motion.spin = 3;
  // The same equations in a million small explicit steps.
  Vec2d v{1, -2};
  double w = 3;
  const int steps = 1'000'000;
  for (int i = 0; i < steps; ++i) {
    const double dt = 0.05 / steps;
    const Vec2d force = -5 * (0.3 * v + cross(w, wetted.first));
    const double torque = -5 * (cross(wetted.first, v) + 0.05 * w);
    v += dt / 0.6 * force;
    w += dt / 0.07 * torque;
  }
  resist(motion, water, wetted, real(0.05));
  CHECK(static_cast<double>(motion.velocity.x) == Approx(v.x).margin(1e-5));
  CHECK(static_cast<double>(motion.velocity.y) == Approx(v.y).margin(1e-5));
  CHECK(static_cast<double>(motion.spin) == Approx(w).margin(1e-5));
}

TEST_CASE("No drag of the water however strong turns a body round") {
  Scene scene = floating(of_density(box_shape(1, 1), 0.5), {0, 0}, 1e9);
  scene.bodies[0].velocity = {3, -2};
  scene.bodies[0].spin = 5;
  const BodyState state = after(scene, 1);
  CHECK(length(state.velocity) < 1e-5);
  CHECK(std::abs(state.spin) < 1e-5);
  CHECK(length(state.center) < 1e-2);
}

TEST_CASE("A thousand kilometres away everything floats the same") {
  const auto settled = [](double x) {
    Scene scene = floating(of_density(box_shape(2, 1), 0.3), {x, 0.2}, 1);
    scene.bodies[0].angle = 0.3;
    const auto simulation = simulate(scene);
    run(*simulation, 5);
    return simulation->body(BodyId{1});
  };
  const BodyState here = settled(0);
  const BodyState there = settled(pick(1048576, 128));
  CHECK(there.center.y == Approx(here.center.y).margin(pick(1e-9, 1e-3)));
  CHECK(there.angle == Approx(here.angle).margin(pick(1e-8, 1e-3)));
}

TEST_CASE("A body's gravity_scale changes its weight and not the water's") {
  Scene scene = floating(of_density(box_shape(3, 1), 0.8), {0, 0}, 8);
  scene.bodies[0].gravity_scale = 0.5;
  CHECK(0.5 - after(scene, 60).center.y == Approx(0.4).margin(pick(1e-9, 1e-5)));
}

TEST_CASE("All shapes of a body carry") {
  Scene scene = floating(box_shape(1, 1), {0, 0}, 8);
  ShapeDef left = of_density(box_shape(1, 1), 0.5);
  ShapeDef right = left;
  for (Vec2d& p : left.points) p += Vec2d{-1, 0};
  for (Vec2d& p : right.points) p += Vec2d{1, 0};
  scene.bodies[0].shapes = {left, right};
  const BodyState state = after(scene, 60);
  CHECK(state.center.y == Approx(0).margin(pick(1e-9, 1e-5)));
  CHECK(state.angle == Approx(0).margin(pick(1e-9, 1e-5)));
}

TEST_CASE("Without gravity water carries nothing") {
  Scene scene = floating(disc_shape(0.5), {0, -3});
  scene.gravity = {0, 0};
  CHECK(after(scene, 1).center == Vec2d{0, -3});
}

TEST_CASE("The snapshot tells the level of water that acts") {
  Scene scene = floating(disc_shape(0.5), {0, -3});
  Snapshot snapshot;
  simulate(scene)->observe(snapshot);
  CHECK(snapshot.water_level == 0.0);
  scene.effects = EffectSet{};
  simulate(scene)->observe(snapshot);
  CHECK_FALSE(snapshot.water_level.has_value());
}
