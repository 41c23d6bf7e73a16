// What is struck within a tick by something fast was slow when the pairs were looked for, and still meets what lies in
// its way.

#include <catch2/catch.hpp>

#include "tests/engine/scenes.h"

using namespace proofreel;
using namespace proofreel::test;

namespace {

constexpr BodyId wall{1};
constexpr BodyId striker{2};

/// A fast disc flies at resting ones before a wall of 2 cm, whose near face is x = 0; bodies 3 and on, from the wall.
Scene blow(double speed, int resting, double gap, double restitution, ContactMethod method) {
  Scene scene;
  scene.rate = 30;
  scene.gravity = {0, 0};
  scene.method.substeps = 4;
  scene.method.contact_solver = method;
  scene.bodies = {body_with(box_shape(0.02, 5), {0.01, 0}, BodyType::fixed), body_with(disc_shape(0.2), {-4, 0})};
  scene.bodies[1].velocity = {speed, 0};
  scene.bodies[1].bullet = true;
  for (int i = 0; i < resting; ++i) scene.bodies.push_back(body_with(disc_shape(0.1), {-0.1 - gap - i * 0.25, 0}));
  for (BodyDef& body : scene.bodies) body.shapes[0].restitution = restitution;
  return scene;
}

double kinetic(const Simulation& simulation) { return simulation.energy().kinetic; }

}  // namespace

TEST_CASE("What is struck within a tick does not get through a thin wall", "[ccd]") {
  const double speed = GENERATE(60.0, 100.0, 200.0, 400.0);
  const int resting = GENERATE(1, 2, 3);
  const double gap = GENERATE(0, 0.05, 0.4);
  const double restitution = GENERATE(0.0, 0.6);
  const ContactMethod method = GENERATE(ContactMethod::soft_step, ContactMethod::exact);
  INFO(speed << " m/s, " << resting << " discs, gap " << gap << ", e " << restitution << ", solver "
             << static_cast<int>(method));
  const auto simulation = simulate(blow(speed, resting, gap, restitution, method));
  const double before = kinetic(*simulation);
  for (int tick = 0; tick < 20; ++tick) {
    simulation->step();
    REQUIRE_FALSE(simulation->failure());
    for (int i = 0; i <= resting; ++i)
      REQUIRE(simulation->body(BodyId(static_cast<std::uint32_t>(i + 2))).position.x < 0);
    REQUIRE(kinetic(*simulation) <= before * (1 + pick(1e-9, 1e-4)));
  }
}

TEST_CASE("Without a wall what is struck flies off as momentum has it", "[ccd]") {
  Scene scene = blow(100, 1, 0.4, 0, ContactMethod::soft_step);
  scene.bodies[0].position.x = 1000;
  const auto simulation = simulate(scene);
  run(*simulation, 0.2, 30);
  const BodyState a = simulation->body(striker);
  const BodyState b = simulation->body(BodyId(3));
  CHECK(a.velocity.x == Approx(100 * a.mass / (a.mass + b.mass)).epsilon(1e-3));
  CHECK(b.velocity.x == Approx(100 * a.mass / (a.mass + b.mass)).epsilon(1e-3));
  CHECK(b.position.x > 10);
}

TEST_CASE("A body that a spring throws meets the wall too", "[ccd]") {
  Scene scene;
  scene.rate = 30;
  scene.gravity = {0, 0};
  scene.method.substeps = 4;
  scene.bodies = {body_with(box_shape(0.02, 5), {0.01, 0}, BodyType::fixed), body_with(disc_shape(0.1), {-0.5, 0})};
  scene.joints = {joint_between(JointKind::spring, wall, {3, 0}, BodyId(2), {}, 0)};
  scene.joints[0].stiffness = 2000;
  const auto simulation = simulate(scene);
  for (int tick = 0; tick < 30; ++tick) {
    simulation->step();
    REQUIRE(simulation->body(BodyId(2)).position.x < 0);
  }
}
