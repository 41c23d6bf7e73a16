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
