/// What a simulation tells of contacts that begin and end.

#include <catch2/catch.hpp>
#include <map>
#include <utility>

#include "tests/engine/random.h"
#include "tests/engine/scenes.h"

using namespace proofreel;
using namespace proofreel::test;

namespace {

constexpr BodyId floor_id{1};
constexpr BodyId thrown{2};
constexpr double g = 9.81;

/// The speed told when the body first touches something.
double told_speed(Simulation& simulation) {
  for (int tick = 0; tick < 1000; ++tick) {
    simulation.step();
    if (!simulation.contact_events().empty()) return simulation.contact_events()[0].speed;
  }
  return -1;
}

Scene bouncing_disc(double restitution) {
  BodyDef disc = body_with(disc_shape(0.5), {0, 2.5});
  disc.shapes[0].restitution = restitution;
  return with_floor(disc);
}

}  // namespace

TEST_CASE("What falls two metres is told to hit with sqrt(2 g h)") {
  Scene scene = bouncing_disc(0.5);
  const double truth = std::sqrt(2 * g * 2);
  CHECK(told_speed(*simulate(scene)) == Approx(truth).margin(g / scene.rate));
  scene.method.contact_solver = ContactMethod::event;
  CHECK(told_speed(*simulate(scene)) == Approx(truth).epsilon(pick(1e-9, 1e-4)));
}

TEST_CASE("What begins to touch without moving hits with no speed") {
  const auto simulation = simulate(with_floor(body_with(box_shape(1, 1), {0, 0.5})));
  CHECK(told_speed(*simulation) == Approx(0).margin(0.01));
}

TEST_CASE("A ball that bounces touches and parts in turns") {
  const auto simulation = simulate(bouncing_disc(1));
  bool touches = false;
  int bounces = 0;
  for (int tick = 0; tick < 1200; ++tick) {
    simulation->step();
    for (const ContactEvent& event : simulation->contact_events()) {
      CHECK_FALSE(touches);
      CHECK(event.a == floor_id);
      touches = true;
    }
    for (const SeparationEvent& event : simulation->separation_events()) {
      CHECK(touches);
      CHECK(event == SeparationEvent{floor_id, thrown});
      touches = false;
      ++bounces;
    }
  }
  CHECK(bounces >= 3);
}

TEST_CASE("A body that is removed parts from all it touched, once") {
  const auto simulation = simulate(with_floor(body_with(box_shape(1, 1), {0, 0.5})));
  run(*simulation, 0.1);
  simulation->apply(RemoveBody{thrown});
  simulation->step();
  REQUIRE(simulation->separation_events().size() == 1);
  CHECK(simulation->separation_events()[0] == SeparationEvent{floor_id, thrown});
  simulation->step();
  CHECK(simulation->separation_events().empty());
}

TEST_CASE("A body that is carried off parts from what it stood on") {
  const auto simulation = simulate(with_floor(body_with(box_shape(1, 1), {0, 0.5})));
  run(*simulation, 0.1);
  ChangeBody away;
  away.body = thrown;
  away.position = Vec2d{0, 40};
  simulation->apply(away);
  simulation->step();
  CHECK(simulation->separation_events().size() == 1);
}

TEST_CASE("What passes through a sensor enters it and leaves it") {
  BodyDef gate = body_with(box_shape(2, 0.5), {0, 1}, BodyType::fixed);
  gate.sensor = true;
  Scene scene;
  scene.bodies = {gate, body_with(disc_shape(0.2), {0, 3})};
  const auto simulation = simulate(scene);
  std::vector<std::int64_t> entered, left;
  for (int tick = 0; tick < 300; ++tick) {
    simulation->step();
    if (!simulation->contact_events().empty()) entered.push_back(simulation->tick());
    if (!simulation->separation_events().empty()) left.push_back(simulation->tick());
  }
  REQUIRE(entered.size() == 1);
  REQUIRE(left.size() == 1);
  CHECK(static_cast<double>(left[0]) / scene.rate == Approx(std::sqrt(2 * 2.45 / g)).margin(0.01));
  CHECK(entered[0] < left[0]);
}

TEST_CASE("In a crowd every pair begins and ends in turns, and what has not ended touches") {
  const auto method = GENERATE(ContactMethod::soft_step, ContactMethod::ngs);
  Scene scene;
  scene.method.contact_solver = method;
  scene.bodies = {floor_body(), body_with(box_shape(1, 20), {-4, 10}, BodyType::fixed),
                  body_with(box_shape(1, 20), {4, 10}, BodyType::fixed)};
  Random random(7);
  for (int i = 0; i < 40; ++i) {
    const ShapeDef shape = i % 2 == 0 ? disc_shape(0.3) : box_shape(0.6, 0.4);
    BodyDef& body = scene.bodies.emplace_back(body_with(shape, {random.between(-3, 3), random.between(0.5, 12)}));
    for (ShapeDef& s : body.shapes) s.restitution = 0.7;
  }
  const auto simulation = simulate(scene);
  std::map<std::pair<BodyId, BodyId>, bool> touches;
  for (int tick = 0; tick < 480; ++tick) {
    if (tick % 100 == 50) simulation->apply(RemoveBody{static_cast<BodyId>(10 + tick / 100)});
    simulation->step();
    for (const SeparationEvent& e : simulation->separation_events()) {
      REQUIRE(touches[{e.a, e.b}]);
      touches[{e.a, e.b}] = false;
    }
    for (const ContactEvent& e : simulation->contact_events()) {
      REQUIRE_FALSE(touches[{e.a, e.b}]);
      touches[{e.a, e.b}] = true;
    }
  }
  std::map<std::pair<BodyId, BodyId>, bool> seen;
  for (const ContactView& c : simulation->contacts()) {
    for (int k = 0; k < c.point_count; ++k) {
      if (c.points[k].touching()) seen[{c.a, c.b}] = true;
    }
  }
  std::erase_if(touches, [](const auto& pair) { return !pair.second; });
  CHECK(touches == seen);
  CHECK(seen.size() > 30);
}
