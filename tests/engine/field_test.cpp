#include <catch2/catch.hpp>
#include <cmath>

#include "engine/elementary.h"
#include "tests/engine/scenes.h"

using namespace proofreel;
using namespace proofreel::test;

namespace {

/// A disc of 2 kg on which only the field acts.
Scene in_field(const ForceField& field, Vec2d velocity = {}) {
  Scene scene;
  scene.gravity = {0, 0};
  BodyDef body = body_with(disc_shape(0.5), {0, 0});
  body.mass = 2;
  body.velocity = velocity;
  scene.bodies = {body};
  scene.fields = {field};
  return scene;
}

}  // namespace

TEST_CASE("A constant field accelerates every dynamic body by force over mass") {
  Scene scene = in_field([](Vec2d, Vec2d, double) { return Vec2d{3, -1}; });
  scene.bodies.push_back(body_with(disc_shape(0.5), {10, 0}, BodyType::kinematic));
  const auto simulation = simulate(scene);
  run(*simulation, 2);
  CHECK(simulation->body(BodyId{1}).velocity.x == Approx(3).epsilon(pick(1e-12, 1e-4)));
  CHECK(simulation->body(BodyId{1}).position.y == Approx(-1).epsilon(pick(1e-12, 1e-4)));
  CHECK(simulation->body(BodyId{2}).velocity == Vec2d{0, 0});
}

TEST_CASE("Several fields add up") {
  Scene scene = in_field([](Vec2d, Vec2d, double) { return Vec2d{3, 0}; });
  scene.fields.push_back([](Vec2d, Vec2d, double) { return Vec2d{-1, 4}; });
  const auto simulation = simulate(scene);
  run(*simulation, 1);
  CHECK(length(simulation->body(BodyId{1}).velocity - Vec2d{1, 2}) < pick(1e-12, 1e-4));
}

TEST_CASE("A field is asked twice in a substep of verlet, and once in one of symplectic Euler") {
  int calls = 0;
  Scene scene = in_field([&calls](Vec2d, Vec2d, double) {
    ++calls;
    return Vec2d{};
  });
  scene.method.substeps = 3;
  simulate(scene)->step();
  CHECK(calls == 6);
  scene.method.integrator = Integrator::symplectic_euler;
  calls = 0;
  simulate(scene)->step();
  CHECK(calls == 3);
}

TEST_CASE("A field is told where the centre of mass is, how fast it moves, and the time at both ends of a substep") {
  std::vector<double> times;
  std::vector<Vec2d> places;
  std::vector<Vec2d> velocities;
  Scene scene = in_field(
      [&](Vec2d at, Vec2d velocity, double time) {
        times.push_back(time);
        places.push_back(at);
        velocities.push_back(velocity);
        return Vec2d{};
      },
      {8, 0});
  scene.rate = 4;
  const auto simulation = simulate(scene);
  simulation->step();
  simulation->step();
  CHECK(times == std::vector<double>{0, 0.125, 0.125, 0.25, 0.25, 0.375, 0.375, 0.5});
  CHECK(places[1] == Vec2d{1, 0});
  CHECK(places.back() == Vec2d{4, 0});
  CHECK(velocities.back() == Vec2d{8, 0});
}

TEST_CASE("A field that changes with time gives the momentum of its integral") {
  const Scene scene = in_field([](Vec2d, Vec2d, double t) { return Vec2d{6 * t * t, 0}; });
  const auto simulation = simulate(scene);
  run(*simulation, 2);
  CHECK(simulation->body(BodyId{1}).velocity.x == Approx(8).epsilon(1e-4));
}

TEST_CASE("What a constant field does is booked as work, to rounding") {
  const Scene scene = in_field([](Vec2d, Vec2d, double) { return Vec2d{3, -1}; }, {0, 2});
  CHECK(energy_drift(scene, 3) < pick(1e-11, 1e-3));
  const auto simulation = simulate(scene);
  run(*simulation, 2);
  const Vec2d way = simulation->body(BodyId{1}).position;
  CHECK(simulation->energy().booked_work == Approx(3 * way.x - way.y).epsilon(pick(1e-11, 1e-4)));
}

TEST_CASE("What a whirl does, which has no potential, is booked as work") {
  const auto whirl = [](Vec2d at, Vec2d, double) { return Vec2d{-8 * at.x - at.y, -8 * at.y + at.x}; };
  Scene scene = in_field(whirl);
  scene.bodies[0].position = {1, 0};
  const auto simulation = simulate(scene);
  run(*simulation, 4);
  CHECK(simulation->energy().kinetic > 4);
  CHECK(energy_drift(scene, 4) < 1e-3);
  Scene finer = scene;
  finer.rate = 480;
  if (is_double) CHECK(energy_drift(finer, 4) < 0.27 * energy_drift(scene, 4));
}

TEST_CASE("A field that pushes a body against the floor does no work") {
  Scene scene = in_field([](Vec2d, Vec2d, double) { return Vec2d{0, -50}; });
  scene.gravity = {0, -9.81};
  scene.bodies[0].position = {0, 0.5};
  scene.bodies.push_back(floor_body());
  const auto simulation = simulate(scene);
  run(*simulation, 10);
  CHECK(simulation->energy().booked_work == Approx(0).margin(1e-2));
  const double settled = simulation->energy().booked_work;
  run(*simulation, 10);
  CHECK(simulation->energy().booked_work == Approx(settled).margin(pick(1e-9, 1e-2)));
}

TEST_CASE("A magnetic field, always across the motion, leads round a circle and does no work") {
  const Scene scene = in_field([](Vec2d, Vec2d v, double) { return Vec2d{4 * v.y, -4 * v.x}; }, {1, 0});
  const auto simulation = simulate(scene);
  run(*simulation, 3.14159265358979);  // one turn: 2 pi m / 4
  CHECK(length(simulation->body(BodyId{1}).position) < 2e-3);
  CHECK(simulation->energy().kinetic == Approx(1).epsilon(pick(1e-6, 1e-4)));
}

TEST_CASE("With forces from velocities verlet stays second order, gravity beside them") {
  const auto error = [](int rate) {
    Scene scene = in_field([](Vec2d, Vec2d v, double) { return -4.0 * v; }, {3, 0});
    scene.rate = rate;
    scene.method.substeps = 1;
    scene.gravity = {0, -10};
    const auto simulation = simulate(scene);
    run(*simulation, 1, rate);
    const double left = elementary::exp(-2.0);
    return length(simulation->body(BodyId{1}).velocity - Vec2d{3 * left, -5 * (1 - left)});
  };
  if (is_double) CHECK(std::log2(error(60) / error(120)) == Approx(2).margin(0.05));
  if (!is_double) CHECK(error(120) < 1e-3);
}

TEST_CASE("Fields that are on with nothing given change no bit") {
  Scene scene = in_field({});
  scene.fields.clear();
  scene.bodies[0].velocity = {1, 2};
  const auto plain = simulate(scene);
  scene.effects = EffectSet{};
  scene.effects->add(Effect::field);
  scene.effects->add(Effect::buoyancy);
  const auto all = simulate(scene);
  for (int i = 0; i < 240; ++i) {
    plain->step();
    all->step();
    REQUIRE(plain->state_hash() == all->state_hash());
  }
}
