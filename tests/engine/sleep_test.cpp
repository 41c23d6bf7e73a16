#include "engine/sleep.h"

#include <catch2/catch.hpp>
#include <cmath>

#include "tests/engine/sleepers.h"

using namespace proofreel;
using namespace proofreel::test;

// How bodies fall asleep, and how they wake.

namespace {

BodyId id(int i) { return static_cast<BodyId>(i); }

/// Squares of half a metre fall onto each other between two walls: bodies 4, 5, ...
Scene pile(int boxes) {
  Scene scene = allowing_sleep({});
  scene.bodies = {floor_body(), body_with(box_shape(1, 20), {-2.5, 10}, BodyType::fixed),
                  body_with(box_shape(1, 20), {2.5, 10}, BodyType::fixed)};
  for (int i = 0; i < boxes; ++i)
    scene.bodies.push_back(body_with(box_shape(0.5, 0.5), {-1.5 + 0.75 * (i % 5), 0.26 + 0.52 * (i / 5)}));
  return scene;
}

/// A bar hung from the world by a chain of links, all at rest: bodies 1, 2, ...
Scene hanging_chain(int links) {
  Scene scene = allowing_sleep({});
  for (int i = 0; i < links; ++i) {
    scene.bodies.push_back(body_with(box_shape(0.1, 0.4), {0, -0.25 - 0.5 * i}));
    scene.joints.push_back(joint_between(JointKind::revolute, id(i), {0, i == 0 ? 0 : -0.25}, id(i + 1), {0, 0.25}));
  }
  return scene;
}

/// A row of boxes on the floor, each an island: bodies 2, 3, ...
Scene row(int boxes) {
  Scene scene = resting_box();
  scene.bodies[0] = body_with(box_shape(4.0 * boxes, 1), {0, -0.5}, BodyType::fixed);
  for (int i = 1; i < boxes; ++i) scene.bodies.push_back(body_with(box_shape(1, 1), {1.25 * i, 0.5}));
  return scene;
}

}  // namespace

TEST_CASE("A square of a metre sleeps after half a second at rest, and then it does not move at all", "[sleep]") {
  auto simulation = simulate(resting_box());
  const auto tick = tick_of_sleep(*simulation, BodyId{2}, 2);
  REQUIRE(tick);
  CHECK(*tick == Approx(0.5 * 240).margin(3));
  const std::uint64_t hash = simulation->state_hash();
  CHECK(simulation->body(BodyId{2}).velocity == Vec2d{0, 0});
  CHECK(simulation->body(BodyId{2}).spin == 0);
  run(*simulation, 1);
  CHECK(simulation->state_hash() == hash);
  CHECK(simulation->asleep(BodyId{2}));
}

TEST_CASE("Where nobody asks for it nothing sleeps", "[sleep]") {
  Scene scene = resting_box();
  scene.sleeping = false;
  CHECK_FALSE(falls_asleep(scene, BodyId{2}, 3));
  auto simulation = simulate(scene);
  simulation->apply(AllowSleep{});
  CHECK(tick_of_sleep(*simulation, BodyId{2}, 2));
}

TEST_CASE("A scene scaled in length and time falls asleep at the same tick", "[sleep]") {
  Scene scene = resting_box();
  scene.bodies[1] = body_with(box_shape(1, 0.5), {0, 0.75});
  scene.bodies[1].angle = 0.25;
  const auto tick = tick_of_sleep(*simulate(scene), BodyId{2}, 6);
  REQUIRE(tick);
  const double scale = 1.0 / 1024;  // a power of two changes no digit
  Scene small = scene;
  small.rate *= 1024;
  small.gravity = (1 / scale) * scene.gravity;
  for (BodyDef& body : small.bodies) {
    body.position = scale * body.position;
    for (Vec2d& point : body.shapes[0].points) point = scale * point;
  }
  CHECK(tick_of_sleep(*simulate(small), BodyId{2}, 6 * scale, small.rate) == tick);
}

TEST_CASE("Everything of an island falls asleep in the same tick", "[sleep]") {
  auto simulation = asleep(stack(4));
  for (int i = 2; i <= 5; ++i) CHECK(simulation->asleep(id(i)));
  const std::vector<SleepEvent> all{{id(2), true}, {id(3), true}, {id(4), true}, {id(5), true}};
  CHECK(simulation->sleep_events() == all);
  simulation->step();
  CHECK(simulation->sleep_events().empty());
}

TEST_CASE("A pile that sleeps lies where one lies that never does", "[sleep]") {
  Scene scene = pile(40);
  auto sleeping = simulate(scene);
  scene.sleeping = false;
  auto waking = simulate(scene);
  run(*sleeping, 8);
  run(*waking, 8);
  for (int i = 4; i < 44; ++i) {
    INFO("body " << i);
    CHECK(sleeping->asleep(id(i)));
    CHECK(distance_to(*sleeping, *waking, id(i)) < 5e-3);  // a hundredth of a box: they tremble
  }
}

TEST_CASE("A stack wakes without a jump", "[sleep]") {
  const Scene scene = stack(6);
  auto simulation = asleep(scene);
  run(*simulation, 1);
  const BodyState before = simulation->body(BodyId{7});
  simulation->apply(WakeBody{BodyId{4}});
  CHECK_FALSE(simulation->asleep(BodyId{7}));
  double farthest = 0;
  double fastest = 0;
  for (int i = 0; i < 60; ++i) {
    simulation->step();
    farthest = std::max(farthest, length(simulation->body(BodyId{7}).center - before.center));
    fastest = std::max(fastest, std::abs(simulation->body(BodyId{7}).velocity.y));
  }
  // It goes on swaying as it did when it fell asleep, and nothing is pushed up or sinks in.
  CHECK(farthest < 3e-4);
  CHECK(fastest < pick(2e-4, 1e-3));
}

TEST_CASE("Sleepers keep their contacts, their impulses and the reactions of their joints", "[sleep]") {
  auto simulation = asleep(resting_box());
  const double weight = simulation->body(BodyId{2}).mass * g;
  run(*simulation, 0.5);
  REQUIRE(simulation->contacts().size() == 1);
  const ContactView contact = simulation->contacts()[0];
  CHECK(240 * (contact.points[0].normal_impulse + contact.points[1].normal_impulse) == Approx(weight).epsilon(1e-3));

  auto chain = asleep(hanging_chain(3), BodyId{3});
  REQUIRE(chain->asleep(BodyId{1}));
  run(*chain, 0.5);
  CHECK(chain->joint(JointId{0}).reaction.y == Approx(3 * 0.04 * g).epsilon(1e-3));
  CHECK(chain->joint(JointId{2}).reaction.y == Approx(0.04 * g).epsilon(1e-3));
}

TEST_CASE("A chain sleeps and wakes as one", "[sleep]") {
  auto simulation = simulate(hanging_chain(5));
  const auto first = tick_of_sleep(*simulation, BodyId{1}, 5);
  REQUIRE(first);
  for (int i = 1; i <= 5; ++i) CHECK(simulation->asleep(id(i)));
  run(*simulation, 0.1);
  simulation->apply(ApplyImpulse{BodyId{5}, {0.02, 0}, std::nullopt});
  for (int i = 1; i <= 5; ++i) CHECK_FALSE(simulation->asleep(id(i)));
  run(*simulation, 0.2);
  CHECK(simulation->body(BodyId{1}).position.x != 0);
  CHECK(simulation->joint(JointId{2}).gap < pick(1e-9, 1e-5));
}

TEST_CASE("A bullet wakes the island it hits and no other one of a thousand", "[sleep]") {
  auto simulation = asleep(row(1000));
  BodyDef bullet = body_with(disc_shape(0.1), {1.25 * 400, 3});
  bullet.velocity = {0, -60};
  bullet.bullet = true;
  simulation->apply(CreateBody{bullet});
  std::vector<SleepEvent> all;
  for (int i = 0; i < 24; ++i) {
    simulation->step();
    all.insert(all.end(), simulation->sleep_events().begin(), simulation->sleep_events().end());
  }
  CHECK(all == std::vector<SleepEvent>{{id(402), false}});
  int awake = 0;
  for (int i = 2; i < 1002; ++i) awake += simulation->asleep(id(i)) ? 0 : 1;
  CHECK(awake == 1);
}

TEST_CASE("What hits a sleeper meets it in the same tick, as if it had never slept", "[sleep]") {
  Scene scene = stack(3);
  const auto hit = [&](bool may_sleep) {
    scene.sleeping = may_sleep;
    auto simulation = simulate(scene);
    run(*simulation, 1);
    BodyDef ball = body_with(disc_shape(0.3), {-3, 2});
    ball.velocity = {6, 2};
    simulation->apply(CreateBody{ball});
    run(*simulation, 0.6);
    return simulation;
  };
  const auto slept = hit(true);
  const auto never = hit(false);
  for (int i = 2; i <= 5; ++i) CHECK(distance_to(*slept, *never, id(i)) < 5e-3);
  CHECK(slept->body(BodyId{4}).position.x > 0.05);
}

TEST_CASE("Momentum passes through sleepers that are hit within one tick", "[sleep]") {
  Scene scene = allowing_sleep({});
  scene.bodies = {floor_body()};
  for (int i = 0; i < 3; ++i) scene.bodies.push_back(body_with(disc_shape(0.5), {1.00001 * i, 0.5}));
  for (BodyDef& body : scene.bodies) {
    body.shapes[0].friction = {0, 0};
    body.shapes[0].restitution = 1;
  }
  auto simulation = asleep(scene);
  REQUIRE(simulation->asleep(BodyId{4}));
  BodyDef ball = scene.bodies[1];
  ball.position = {-2, 0.5};
  ball.velocity = {2, 0};
  simulation->apply(CreateBody{ball});
  run(*simulation, 1);
  CHECK(simulation->body(BodyId{5}).velocity.x == Approx(0).margin(1e-3));
  CHECK(simulation->body(BodyId{3}).velocity.x == Approx(0).margin(1e-3));
  CHECK(simulation->body(BodyId{4}).velocity.x == Approx(2).epsilon(1e-3));
}

TEST_CASE("What trembles beside a sleeper leaves it lie, to the last bit", "[sleep]") {
  auto simulation = asleep(resting_box());
  REQUIRE(simulation->asleep(BodyId{2}));
  BodyDef ball = body_with(disc_shape(0.3), {0.806, 0.3});  // 6 mm apart
  ball.spin = 0.01;
  simulation->apply(CreateBody{ball});
  const Vec2d before = simulation->body(BodyId{2}).center;
  for (int i = 0; i < 60; ++i) {
    simulation->step();
    CHECK(simulation->asleep(BodyId{2}));
    CHECK(simulation->body(BodyId{2}).velocity == Vec2d{0, 0});
  }
  CHECK(simulation->body(BodyId{2}).center == before);
}

TEST_CASE("Without the ground everything on it wakes and falls", "[sleep]") {
  auto simulation = asleep(row(50));
  REQUIRE(simulation->asleep(BodyId{30}));
  simulation->apply(RemoveBody{BodyId{1}});
  run(*simulation, 0.5);
  for (int i = 2; i < 52; ++i) CHECK(simulation->body(id(i)).position.y < -0.7);
}

TEST_CASE("Every command that changes a sleeper or what holds it wakes it", "[sleep]") {
  Scene scene = stack(2);
  scene.bodies.push_back(body_with(box_shape(1, 1), {5, 0.5}));  // an island by itself: body 4
  auto simulation = asleep(scene);
  REQUIRE(simulation->asleep(BodyId{4}));
  ChangeBody heavier;
  heavier.body = BodyId{3};
  heavier.mass = 2;
  ChangeBody smoother;
  smoother.body = BodyId{1};
  smoother.friction = FrictionDef{0.2, 0.1};
  const Command command = GENERATE_COPY(
      Command{ApplyImpulse{BodyId{3}, {0.1, 0}, std::nullopt}}, Command{ApplyForce{BodyId{3}, {1, 0}, std::nullopt}},
      Command{ApplyTorque{BodyId{3}, 1}}, Command{WakeBody{BodyId{3}}}, Command{RemoveBody{BodyId{3}}},
      Command{RemoveBody{BodyId{1}}}, Command{heavier}, Command{smoother},
      Command{CreateJoint{joint_between(JointKind::rope, BodyId::world, {0, 3}, BodyId{3}, {0, 0}, 5)}});
  const bool on_ground =
      std::holds_alternative<RemoveBody>(command)
          ? std::get<RemoveBody>(command).body == BodyId{1}
          : std::holds_alternative<ChangeBody>(command) && std::get<ChangeBody>(command).body == BodyId{1};
  INFO("command " << command.index());
  simulation->apply(command);
  CHECK_FALSE(simulation->asleep(BodyId{2}));
  CHECK(simulation->asleep(BodyId{4}) == !on_ground);
  simulation->step();
  REQUIRE_FALSE(simulation->sleep_events().empty());
  CHECK(simulation->sleep_events()[0] == SleepEvent{BodyId{2}, false});
}

TEST_CASE("A new colour, and a joint between others, wake nobody", "[sleep]") {
  Scene scene = resting_box();
  scene.bodies.push_back(body_with(disc_shape(0.2), {3, 5}));
  auto simulation = asleep(scene);
  ChangeBody recoloured;
  recoloured.body = BodyId{1};
  recoloured.color = 0x123456;
  simulation->apply(recoloured);
  simulation->apply(CreateJoint{joint_between(JointKind::revolute, BodyId::world, {3, 5}, BodyId{3}, {0, 0})});
  run(*simulation, 0.1);
  CHECK(simulation->asleep(BodyId{2}));
}

TEST_CASE("A body made inside a sleeper wakes it", "[sleep]") {
  auto simulation = asleep(resting_box());
  simulation->apply(CreateBody{body_with(disc_shape(0.2), {0.2, 0.6})});
  simulation->step();
  CHECK_FALSE(simulation->asleep(BodyId{2}));
  auto with_fixed = asleep(resting_box());
  with_fixed->apply(CreateBody{body_with(disc_shape(0.2), {0.5, 0.9}, BodyType::fixed)});
  with_fixed->step();
  CHECK_FALSE(with_fixed->asleep(BodyId{2}));
}

TEST_CASE("A removed or changed joint wakes what it held", "[sleep]") {
  auto simulation = asleep(hanging_chain(3), BodyId{3});
  REQUIRE(simulation->asleep(BodyId{3}));
  simulation->apply(RemoveJoint{JointId{1}});
  CHECK_FALSE(simulation->asleep(BodyId{1}));
  run(*simulation, 0.5);
  CHECK(simulation->body(BodyId{2}).position.y < -1.5);
  CHECK(simulation->body(BodyId{1}).position.y == Approx(-0.25).margin(pick(1e-6, 1e-3)));
}

TEST_CASE("The events of two equal runs are equal, in order of what happened and then of ids", "[sleep]") {
  const auto history = [] {
    std::vector<std::pair<std::int64_t, SleepEvent>> all;
    auto simulation = simulate(pile(30));
    for (int i = 0; i < 6 * 240; ++i) {
      if (i == 4 * 240) simulation->apply(CreateBody{body_with(disc_shape(0.2), {0, 6})});
      simulation->step();
      for (const SleepEvent& event : simulation->sleep_events()) all.emplace_back(simulation->tick(), event);
    }
    return all;
  };
  const auto all = history();
  CHECK(all == history());
  CHECK(all.size() > 30);
  for (std::size_t i = 1; i < all.size(); ++i) {
    const bool same_moment = all[i].first == all[i - 1].first && all[i].second.asleep == all[i - 1].second.asleep;
    if (same_moment && all[i].second.asleep) CHECK(all[i].second.body > all[i - 1].second.body);
  }
}

TEST_CASE("Snapshots tell who sleeps, and number the islands where somebody asks", "[sleep]") {
  Scene scene = stack(2);
  scene.bodies.push_back(body_with(box_shape(1, 1), {5, 0.5}));
  BodyDef sensor = body_with(box_shape(8, 0.2), {2, 0.8}, BodyType::fixed);
  sensor.sensor = true;
  scene.bodies.push_back(sensor);
  auto simulation = asleep(scene);
  Snapshot snapshot;
  simulation->observe(snapshot);
  CHECK(snapshot.bodies[1].asleep);
  CHECK_FALSE(snapshot.bodies[0].asleep);
  CHECK(snapshot.bodies[1].island == 0);
  simulation->keep_islands();
  const auto check_islands = [&] {
    simulation->observe(snapshot);
    CHECK(snapshot.bodies[0].island == 0);
    CHECK(snapshot.bodies[1].island == 1);
    CHECK(snapshot.bodies[2].island == 1);
    CHECK(snapshot.bodies[3].island == 2);  // the sensor, which overlaps both, joins nothing
    CHECK(snapshot.bodies[4].island == 0);
  };
  check_islands();
  simulation->apply(WakeBody{BodyId{2}});
  simulation->step();
  check_islands();
}

TEST_CASE("A sensor that passes over a sleeper tells of it and does not wake it", "[sleep]") {
  auto simulation = asleep(resting_box());
  BodyDef sensor = body_with(disc_shape(0.3), {-2, 0.8}, BodyType::kinematic);
  sensor.sensor = true;
  sensor.velocity = {4, 0};
  simulation->apply(CreateBody{sensor});
  bool told = false;
  for (int i = 0; i < 240; ++i) {
    simulation->step();
    told |= !simulation->contact_events().empty();
  }
  CHECK(told);
  CHECK(simulation->asleep(BodyId{2}));
}
