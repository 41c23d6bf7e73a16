// What lies a hair's breadth above another thing does not begin to fall: what gravity adds within a tick is foreseen.

#include <catch2/catch.hpp>
#include <cmath>

#include "tests/engine/scenes.h"

using namespace proofreel;
using namespace proofreel::test;

namespace {

constexpr double fall_of_a_tick = 0.5 * 9.81 / 3600;  // m at 60 Hz, if nothing holds

/// Boxes of edge `size` one above the other, with a gap under each, at 60 Hz.
Scene tower_with_gaps(double size, double gap, int boxes, ContactMethod method) {
  Scene scene;
  scene.rate = 60;
  scene.method.substeps = 4;
  scene.method.contact_solver = method;
  scene.bodies = {floor_body()};
  for (int i = 0; i < boxes; ++i)
    scene.bodies.push_back(body_with(box_shape(size, size), {0, size / 2 + gap + i * (size + gap)}));
  return scene;
}

double sunk_after(Simulation& simulation, int ticks, BodyId body) {
  const double before = simulation.body(body).position.y;
  for (int i = 0; i < ticks; ++i) simulation.step();
  return before - simulation.body(body).position.y;
}

}  // namespace

TEST_CASE("A box that starts a hair's breadth above the floor falls no farther than to it", "[ccd]") {
  const double gap = GENERATE(0, 1e-16, 1e-12, 1e-6, 1e-3);
  const ContactMethod method = GENERATE(ContactMethod::soft_step, ContactMethod::exact, ContactMethod::event);
  const double size = GENERATE(1e-4, 1e-2, 1.0);
  INFO("gap " << gap << ", solver " << static_cast<int>(method) << ", size " << size);
  const auto simulation = simulate(tower_with_gaps(size, gap, 1, method));
  const double sunk = sunk_after(*simulation, 1, BodyId(2));
  CHECK(sunk < gap + 0.2 * fall_of_a_tick);
  CHECK(sunk > 0.9 * gap - pick(1e-12, 1e-7));
  CHECK(std::abs(simulation->body(BodyId(2)).velocity.y) < 0.02);
}

TEST_CASE("Boxes with hair's breadths between them settle from the first tick on", "[ccd]") {
  const double gap = GENERATE(0, 1e-16, 1e-12, 1e-6, 1e-3);
  INFO("gap " << gap);
  const auto simulation = simulate(tower_with_gaps(1, gap, 3, ContactMethod::soft_step));
  for (std::uint32_t i = 0; i < 3; ++i) {
    const auto one = simulate(tower_with_gaps(1, gap, 3, ContactMethod::soft_step));
    CHECK(sunk_after(*one, 1, BodyId(i + 2)) < (i + 1) * gap + 0.7 * fall_of_a_tick);
  }
}

TEST_CASE("A thing pulled to the side is held by a wall a hair's breadth off", "[ccd]") {
  Scene scene;
  scene.rate = 60;
  scene.gravity = {0, 0};
  scene.bodies = {body_with(box_shape(1, 10), {1.0 + 1e-4, 0}, BodyType::fixed), body_with(box_shape(1, 1), {0, 0})};
  const auto simulation = simulate(scene);
  const double mass = simulation->body(BodyId(2)).mass;
  simulation->apply(ApplyForce{BodyId(2), {20 * mass, 0}, {}});
  simulation->step();
  CHECK(simulation->body(BodyId(2)).position.x < 1e-4 + 0.2 * 20 / 7200);
}

TEST_CASE("A falling ball is not stopped before it touches", "[ccd]") {
  const double height = GENERATE(0.0015, 0.002, 0.01);
  Scene scene = with_floor(body_with(disc_shape(0.001), {0, 0.001 + height}));
  scene.rate = 60;
  const auto simulation = simulate(scene);
  simulation->step();
  CHECK(simulation->body(BodyId(2)).position.y == Approx(0.001 + height - fall_of_a_tick).epsilon(1e-5));
}

TEST_CASE("Small discs that fall past each other do not feel it", "[ccd]") {
  Scene scene;
  scene.rate = 60;
  scene.bodies = {body_with(disc_shape(0.01), {0, 0}), body_with(disc_shape(0.01), {-0.04, 0.0215})};
  scene.bodies[1].velocity = {3, 0};
  const auto simulation = simulate(scene);
  for (int i = 0; i < 3; ++i) simulation->step();
  CHECK(simulation->body(BodyId(2)).velocity.x == Approx(3));
  CHECK(simulation->body(BodyId(1)).velocity.x == Approx(0).margin(1e-12));
}
