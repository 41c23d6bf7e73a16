#include <catch2/catch.hpp>
#include <cmath>

#include "tests/engine/scenes.h"

using namespace proofreel;
using namespace proofreel::test;

namespace {

constexpr Integrator all_integrators[] = {Integrator::symplectic_euler,  Integrator::verlet,
                                          Integrator::suzuki4,           Integrator::rk4,
                                          Integrator::implicit_midpoint, Integrator::gauss_legendre6};

int theoretical_order(Integrator integrator) {
  switch (integrator) {
    case Integrator::symplectic_euler:
      return 1;
    case Integrator::verlet:
    case Integrator::implicit_midpoint:
      return 2;
    case Integrator::suzuki4:
    case Integrator::rk4:
      return 4;
    case Integrator::gauss_legendre6:
      return 6;
  }
  return 0;
}

BodyDef point_mass(Vec2d position, Vec2d velocity) {
  BodyDef body;
  body.position = position;
  body.velocity = velocity;
  body.mass = 1;
  return body;
}

Scene weightless(Integrator integrator, int rate) {
  Scene scene;
  scene.gravity = {0, 0};
  scene.rate = rate;
  scene.method.substeps = 1;
  scene.method.integrator = integrator;
  return scene;
}

/// A mass of 1 kg on a spring of 100 N/m, 1 m from rest: x = cos(10 t).
Scene oscillator(Integrator integrator, int rate) {
  Scene scene = weightless(integrator, rate);
  scene.bodies = {point_mass({1, 0}, {0, 0})};
  JointDef spring;
  spring.kind = JointKind::spring;
  spring.b = BodyId{1};
  spring.anchor_a = {-5, 0};
  spring.length = 5;
  spring.stiffness = 100;
  scene.joints = {spring};
  return scene;
}

/// A planet on an ellipse of eccentricity 0.6 with semi-axis 1 and period 2 pi, from its pericentre.
Scene planet(Integrator integrator, int rate) {
  Scene scene = weightless(integrator, rate);
  scene.bodies = {point_mass({0.4, 0}, {0, 2})};
  scene.attractors = {{std::nullopt, {0, 0}, 1, AttractionLaw::inverse_square}};
  return scene;
}

Vec2d place_after(const Scene& scene, double seconds) {
  const auto simulation = simulate(scene);
  run(*simulation, seconds, scene.rate);
  return simulation->body(BodyId{1}).center;
}

double oscillator_error(Integrator integrator, int rate) {
  return length(place_after(oscillator(integrator, rate), 10) - Vec2d{0.862318872287683934, 0});
}

double planet_error(Integrator integrator, int rate) {
  return length(place_after(planet(integrator, rate), 10) - Vec2d{-1.53502359190981369, -0.283668406499780862});
}

/// How often per second to step so that errors lie between what the order describes and what rounding leaves.
int fine_rate(Integrator integrator) {
  switch (theoretical_order(integrator)) {
    case 1:
      return 64000;
    case 2:
      return 3200;
    case 4:
      return 1600;
    default:
      return 80;
  }
}

}  // namespace

TEST_CASE("Every integrator converges at its order on a spring and on an ellipse", "[integrator]") {
  if (sizeof(real) < sizeof(double)) return;  // single precision reaches its floor before the order shows
  for (const Integrator integrator : all_integrators) {
    const int order = theoretical_order(integrator);
    const int rate = order == 6 ? 40 : order == 4 ? 400 : fine_rate(integrator);
    CAPTURE(order, static_cast<int>(integrator));
    CHECK(std::log2(oscillator_error(integrator, rate) / oscillator_error(integrator, 2 * rate)) ==
          Approx(order).margin(0.15));
    const int finer = integrator == Integrator::suzuki4 ? 300 : fine_rate(integrator);
    CHECK(std::log2(planet_error(integrator, finer) / planet_error(integrator, 2 * finer)) ==
          Approx(order).margin(0.15));
  }
}

TEST_CASE("A pendulum on a rigid rod converges at order 2 under verlet and 4 under suzuki4", "[integrator]") {
  if (sizeof(real) < sizeof(double)) return;
  const auto place = [](Integrator integrator, int rate) {
    Scene scene = weightless(integrator, rate);
    scene.gravity = {0, -9.81};
    scene.bodies = {point_mass({std::sqrt(0.75), -0.5}, {0, 0})};  // 60 degrees from the vertical
    JointDef rod;
    rod.kind = JointKind::distance;
    rod.b = BodyId{1};
    rod.length = 1;
    scene.joints = {rod};
    return place_after(scene, 10);
  };
  for (const auto& [integrator, order] : {std::pair(Integrator::verlet, 2), std::pair(Integrator::suzuki4, 4)}) {
    const int rate = order == 2 ? 400 : 100;
    const Vec2d coarse = place(integrator, rate);
    const Vec2d middle = place(integrator, 2 * rate);
    const Vec2d fine = place(integrator, 4 * rate);
    CAPTURE(order, length(fine - middle));
    CHECK(std::log2(length(middle - coarse) / length(fine - middle)) == Approx(order).margin(0.15));
    CHECK(length(fine) == Approx(1).margin(1e-11));
  }
}

TEST_CASE("A charge in a magnetic field goes round in a circle under every integrator that takes fields",
          "[integrator]") {
  for (const Integrator integrator :
       {Integrator::verlet, Integrator::rk4, Integrator::implicit_midpoint, Integrator::gauss_legendre6}) {
    Scene scene = weightless(integrator, 480);
    scene.bodies = {point_mass({0, 0}, {1, 0})};
    scene.fields.emplace_back([](Vec2d, Vec2d v, double) { return Vec2d{2 * v.y, -2 * v.x}; });
    const Vec2d place = place_after(scene, 1);  // radius 1/2, angular speed 2, clockwise
    CHECK(place.x == Approx(0.5 * std::sin(2.0)).margin(pick(1e-5, 1e-4)));
    CHECK(place.y == Approx(0.5 * std::cos(2.0) - 0.5).margin(pick(1e-5, 1e-4)));
  }
}

TEST_CASE("A constant field's work is booked to the last digits by smooth integrators", "[integrator]") {
  Scene scene = weightless(Integrator::gauss_legendre6, 60);
  scene.bodies = {point_mass({0, 0}, {1, 0})};
  scene.fields.emplace_back([](Vec2d, Vec2d, double time) { return Vec2d{3 * time, 1}; });
  const auto simulation = simulate(scene);
  const double before = simulation->energy().total();
  run(*simulation, 2, 60);
  const Energy after = simulation->energy();
  CHECK(after.total() - after.booked_work == Approx(before).margin(pick(1e-10, 1e-3)));
  CHECK(simulation->body(BodyId{1}).velocity.x == Approx(7).margin(pick(1e-11, 1e-3)));
}

TEST_CASE("What floats, floats at its draught under rk4 as well", "[integrator]") {
  Scene scene = weightless(Integrator::rk4, 240);
  scene.gravity = {0, -9.81};
  scene.bodies = {body_with(box_shape(1, 1), {0, 0})};
  scene.bodies[0].shapes[0].density = 500;
  scene.water = WaterDef{0, 1000, 3000};
  CHECK(place_after(scene, 10).y == Approx(0).margin(pick(1e-9, 1e-4)));
}

TEST_CASE("All integrators find the oscillator where it is", "[integrator]") {
  for (const Integrator integrator : all_integrators)
    CHECK(oscillator_error(integrator, 2400) < (integrator == Integrator::symplectic_euler ? 2e-2 : 1e-3));
}

TEST_CASE("Symplectic integrators keep the energy of an ellipse over a hundred turns, rk4 loses some", "[integrator]") {
  const auto drift = [](Integrator integrator) {
    const auto simulation = simulate(planet(integrator, 100));
    const double before = simulation->energy().total();
    run(*simulation, 628, 100);
    return std::abs(simulation->energy().total() - before);
  };
  CHECK(drift(Integrator::gauss_legendre6) < pick(1e-9, 1e-2));
  CHECK(drift(Integrator::suzuki4) < pick(1e-4, 1e-2));
  if (sizeof(real) == sizeof(double)) CHECK(drift(Integrator::rk4) > 10 * drift(Integrator::suzuki4));
}

TEST_CASE("Free fall is exact by every integrator of second order and more", "[integrator]") {
  for (const Integrator integrator : all_integrators) {
    if (integrator == Integrator::symplectic_euler) continue;
    Scene scene = weightless(integrator, 240);
    scene.gravity = {0, -9.81};
    scene.bodies = {point_mass({0, 10}, {3, 5})};
    const Vec2d place = place_after(scene, 1);
    CHECK(place.x == Approx(3).margin(pick(1e-12, 1e-4)));
    CHECK(place.y == Approx(10.095).margin(pick(1e-12, 1e-4)));
  }
}

TEST_CASE("Drag in still air brakes by the exponential law under every integrator that takes it", "[integrator]") {
  for (const Integrator integrator :
       {Integrator::verlet, Integrator::rk4, Integrator::implicit_midpoint, Integrator::gauss_legendre6}) {
    Scene scene = weightless(integrator, 240);
    scene.bodies = {point_mass({0, 0}, {2, 0})};
    scene.drag.linear = 1;
    CHECK(place_after(scene, 1).x == Approx(2 * (1 - std::exp(-1))).margin(pick(1e-5, 1e-4)));
  }
}

TEST_CASE("A force and a torque for one tick act alike under every integrator", "[integrator]") {
  for (const Integrator integrator : all_integrators) {
    Scene scene = weightless(integrator, 240);
    scene.bodies = {body_with(disc_shape(1), {0, 0})};
    const auto simulation = simulate(scene);
    const BodyState before = simulation->body(BodyId{1});
    simulation->apply(ApplyForce{BodyId{1}, {24, 0}, Vec2d{0, 1}});
    simulation->step();
    simulation->step();
    const BodyState after = simulation->body(BodyId{1});
    CHECK(after.velocity.x == Approx(0.1 / before.mass).epsilon(1e-5));
    CHECK(after.spin == Approx(-0.1 / before.inertia).epsilon(1e-5));
  }
}

TEST_CASE("Implicit integrators step a light body on a stiff spring, whose rounding no iteration takes away",
          "[integrator]") {
  const auto integrator = GENERATE(Integrator::implicit_midpoint, Integrator::gauss_legendre6);
  Scene scene = oscillator(integrator, 60);
  scene.gravity = {0, -9.81};
  scene.joints[0].stiffness = 1000 * scene.bodies[0].mass.value_or(1);
  const auto simulation = simulate(scene);
  for (int tick = 0; tick < 600; ++tick) simulation->step();
  CHECK_FALSE(simulation->failure());
}

TEST_CASE("An implicit integrator whose equations have no solution at this step says so", "[integrator]") {
  Scene scene = oscillator(Integrator::implicit_midpoint, 1);
  const auto simulation = simulate(scene);
  simulation->step();
  REQUIRE(simulation->failure());
  CHECK(simulation->failure()->what == "cannot be found: its equations do not converge");
}

TEST_CASE("What does not go together is refused with the reason and the remedy", "[integrator]") {
  Scene colliding;
  colliding.method.integrator = Integrator::rk4;
  colliding.bodies = {body_with(disc_shape(1), {0, 0}), body_with(disc_shape(1), {5, 0})};
  CHECK(problem_with_method(colliding).value_or("").find("may meet") != std::string::npos);
  colliding.method.integrator = Integrator::verlet;
  CHECK_FALSE(problem_with_method(colliding));
  Scene hanging = oscillator(Integrator::gauss_legendre6, 240);
  CHECK_FALSE(problem_with_method(hanging));
  hanging.joints[0].kind = JointKind::distance;
  CHECK(problem_with_method(hanging).value_or("").find("joints other than springs") != std::string::npos);
  hanging.method.integrator = Integrator::suzuki4;
  CHECK_FALSE(problem_with_method(hanging));
  hanging.drag.linear = 1;
  CHECK(problem_with_method(hanging).value_or("").find("backwards") != std::string::npos);
  Scene damped = oscillator(Integrator::suzuki4, 240);
  damped.joints[0].damping = 1;
  CHECK(problem_with_method(damped).value_or("").find("backwards") != std::string::npos);
}
