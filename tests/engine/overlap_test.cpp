// Bodies that were put inside each other part gently, whatever their size and however many there are.

#include <catch2/catch.hpp>
#include <cmath>

#include "tests/engine/scenes.h"

using namespace proofreel;
using namespace proofreel::test;

namespace {

BodyId nth(int i) { return BodyId(static_cast<std::uint32_t>(i + 2)); }  // behind the floor

Scene pile(const std::vector<Vec2d>& places, double size) {
  Scene scene;
  scene.rate = 60;
  scene.method.substeps = 4;
  scene.bodies = {floor_body()};
  for (const Vec2d place : places) scene.bodies.push_back(body_with(box_shape(size, size), place));
  return scene;
}

std::vector<Vec2d> overlapped_pyramid(int rows, double size) {
  std::vector<Vec2d> places;
  for (int row = 0; row < rows; ++row) {
    for (int i = 0; i < rows - row; ++i)
      places.push_back({(i - (rows - row - 1) / 2.0) * 0.75 * size, (0.5 + 0.75 * row) * size});
  }
  return places;
}

struct Seen {
  double fastest = 0;    ///< of velocities
  double farthest = 0;   ///< way of a tick times the rate
  double lowest = 1e9;   ///< centre
  double gained = -1e9;  ///< energy beyond the booked work
};

Seen watched(Simulation& simulation, int boxes, double seconds) {
  Seen seen;
  const double first = simulation.energy().total();
  std::vector<Vec2d> before;
  for (int i = 0; i < boxes; ++i) before.push_back(simulation.body(nth(i)).position);
  for (int tick = 0; tick < seconds * 60; ++tick) {
    simulation.step();
    for (int i = 0; i < boxes; ++i) {
      const BodyState b = simulation.body(nth(i));
      seen.fastest = std::max(seen.fastest, length(b.velocity));
      seen.farthest = std::max(seen.farthest, 60 * length(b.position - before[static_cast<std::size_t>(i)]));
      seen.lowest = std::min(seen.lowest, b.position.y);
      before[static_cast<std::size_t>(i)] = b.position;
    }
    const Energy e = simulation.energy();
    seen.gained = std::max(seen.gained, e.total() - e.booked_work - first);
  }
  return seen;
}

/// A shin of 0.4 m whose far end is `depth` inside the ground, and on its knee at the surface an upright thigh of
/// `load` times its mass.
Scene leg_in_ground(double depth, double load, Integrator integrator) {
  const double angle = std::asin(depth / 0.4);
  const Vec2d across = 0.05 * Vec2d{std::sin(angle), std::cos(angle)};
  BodyDef shin = body_with(box_shape(0.4, 0.1), across + 0.2 * Vec2d{std::cos(angle), -std::sin(angle)});
  shin.angle = -angle;
  BodyDef thigh = body_with(box_shape(0.1, 0.4), across + Vec2d{0, 0.2});
  thigh.mass = 0.04 * load;
  Scene scene;
  scene.rate = 60;
  scene.method.integrator = integrator;
  scene.method.contact_solver = ContactMethod::soft_step;
  scene.method.substeps = 4;
  scene.bodies = {floor_body(), shin, thigh};
  scene.joints = {joint_between(JointKind::revolute, nth(0), {-0.2, 0}, nth(1), {0, -0.2})};
  return scene;
}

double lowest_corner(const BodyState& shin) {
  const double drop = 0.2 * std::abs(std::sin(shin.angle)) + 0.05 * std::abs(std::cos(shin.angle));
  return shin.center.y - drop;
}

}  // namespace

TEST_CASE("Boxes that overlap by a quarter part at a bounded speed and stay a pyramid", "[overlap]") {
  const double size = GENERATE(0.01, 1.0);
  const int rows = GENERATE(2, 6);
  const int boxes = rows * (rows + 1) / 2;
  Scene scene = pile(overlapped_pyramid(rows, size), size);
  scene.gravity = {0, -10 * size};
  const auto simulation = simulate(scene);
  CHECK(simulation->is_settling() == false);  // nobody has looked yet
  simulation->step();
  CHECK(simulation->is_settling());
  const Seen seen = watched(*simulation, boxes, 6);
  INFO("size " << size << ", rows " << rows);
  CHECK_FALSE(simulation->is_settling());
  CHECK(seen.fastest < 3 * size);
  CHECK(seen.farthest < 5 * size);  // 3 for the push, the rest for falling
  CHECK(seen.lowest > 0.45 * size);
  CHECK(simulation->body(nth(boxes - 1)).position.y == Approx((rows - 0.5) * size).epsilon(0.01));
  CHECK(length(simulation->body(nth(boxes - 1)).velocity) < 0.005 * size);
}

TEST_CASE("Boxes at one and the same place part without being thrown or pushed into the ground", "[overlap]") {
  const int boxes = GENERATE(2, 5, 20);
  const auto simulation = simulate(pile(std::vector<Vec2d>(static_cast<std::size_t>(boxes), {0, 0.5}), 1));
  const Seen seen = watched(*simulation, boxes, 8);
  CHECK(seen.fastest < std::sqrt(2 * 9.81 * boxes));
  CHECK(seen.lowest > 0.4);
  for (const ContactView& c : simulation->contacts()) {
    for (int k = 0; k < c.point_count; ++k) CHECK(c.points[k].separation > -0.02);
  }
}

TEST_CASE("What parts bodies is booked as work, so that no energy comes from nowhere", "[overlap]") {
  const auto simulation = simulate(pile({{0, 0.4}, {0, 0.9}}, 1));
  const Seen seen = watched(*simulation, 2, 3);
  CHECK(simulation->energy().booked_work > 1);
  CHECK(seen.gained < 0.1);
}

// Joints that go on answering to a push which is over press a limb into the ground, the more the heavier its load is.
TEST_CASE("How fast a limb leaves the ground it is in depends neither on its load nor on the integrator", "[overlap]") {
  const Integrator integrator = GENERATE(Integrator::verlet, Integrator::symplectic_euler);
  const double load = GENERATE(1.0, 5.0, 20.0);
  CAPTURE(load);
  const auto simulation = simulate(leg_in_ground(0.15, load, integrator));
  CHECK(lowest_corner(simulation->body(nth(0))) == Approx(-0.15));
  run(*simulation, 0.5, 60);
  CHECK(lowest_corner(simulation->body(nth(0))) == Approx(-0.0185).margin(0.002));
  run(*simulation, 2, 60);
  CHECK(lowest_corner(simulation->body(nth(0))) > -0.002);
}
