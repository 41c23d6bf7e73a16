#include <catch2/catch.hpp>
#include <cmath>

#include "engine/sleep.h"
#include "tests/engine/sleepers.h"

using namespace proofreel;
using namespace proofreel::test;

// What must not fall asleep, and what may all the same.

namespace {

Scene lone(const ShapeDef& shape, Vec2d gravity) {
  Scene scene = allowing_sleep({});
  scene.bodies = {body_with(shape, {0, 0})};
  scene.gravity = gravity;
  EffectSet effects{Effect::gravity, Effect::contacts, Effect::joints, Effect::springs, Effect::sleeping};
  scene.effects = effects;
  return scene;
}

/// A bob of 0.1 m on a rod, let go at an angle.
Scene pendulum(double length, double angle) {
  Scene scene = lone(disc_shape(0.1), {0, -g});
  const Vec2d at{length * std::sin(angle), -length * std::cos(angle)};
  scene.bodies[0].position = at;
  scene.joints = {joint_between(JointKind::distance, BodyId::world, {0, 0}, BodyId{1}, {0, 0}, length)};
  return scene;
}

}  // namespace

TEST_CASE("Half a swing is half the period of a pendulum, of a mass on a spring, and half a second for a metre",
          "[sleep]") {
  CHECK(half_swing(1, real(g)) == Approx(1.0030).epsilon(1e-4));
  CHECK(half_swing_on_spring(4, 1) == Approx(6.2832).epsilon(1e-4));
  CHECK(standing_rest_time(real(std::sqrt(0.5)), real(g)) == Approx(0.5015).epsilon(1e-3));
  CHECK(standing_rest_time(1, 0) == Approx(0.5));
}

TEST_CASE("What drifts in space never sleeps, however slowly, and neither does what rests there", "[sleep]") {
  Scene scene = lone(disc_shape(1), {0, 0});
  scene.bodies[0].velocity = {GENERATE(0.0, 1e-6, 1e-3, 1.0), 0};
  CHECK_FALSE(falls_asleep(scene, BodyId{1}, 10));
}

TEST_CASE("A ball at its apex does not sleep", "[sleep]") {
  Scene scene = lone(disc_shape(1), {0, -1e-2});  // it takes its time
  scene.bodies[0].velocity = {0, 0.05};
  CHECK_FALSE(falls_asleep(scene, BodyId{1}, 10));
}

TEST_CASE("A pendulum does not sleep where it turns, and sleeps where it hangs", "[sleep]") {
  const double length = GENERATE(0.3, 1.0, 25.0);
  CHECK_FALSE(falls_asleep(pendulum(length, 0.02 / std::min(length, 1.0)), BodyId{1}, 20));
  CHECK(falls_asleep(pendulum(length, 0), BodyId{1}, 12));
}

TEST_CASE("A mass on a spring does not sleep where it turns, and sleeps in balance", "[sleep]") {
  const double stretch = GENERATE(0.1, 0.0);
  Scene scene = lone(disc_shape(0.5), {0, 0});
  scene.joints = {joint_between(JointKind::spring, BodyId::world, {0, 2}, BodyId{1}, {0, 0}, 1)};
  scene.joints[0].stiffness = 0.05;  // a swing of 25 s
  scene.bodies[0].position = {0, -stretch};
  scene.gravity = {0, -0.05 / 0.785398};  // holds it a metre below its length
  CHECK(falls_asleep(scene, BodyId{1}, 60) == (stretch == 0));
}

TEST_CASE("What rolls or glides slowly but steadily does not sleep", "[sleep]") {
  const bool rolls = GENERATE(true, false);
  Scene scene = allowing_sleep(with_floor(body_with(rolls ? disc_shape(0.5) : box_shape(1, 1), {0, 0.5})));
  scene.bodies[1].velocity = {0.005, 0};
  if (rolls) scene.bodies[1].spin = -0.01;
  if (!rolls) scene.bodies[0].shapes[0].friction = {0, 0};
  auto simulation = simulate(scene);
  CHECK_FALSE(tick_of_sleep(*simulation, BodyId{2}, 10));
  CHECK(simulation->body(BodyId{2}).position.x == Approx(0.05).epsilon(0.01));
}

TEST_CASE("A moving kinematic body keeps awake what it touches and wakes what it comes to touch", "[sleep]") {
  Scene scene = allowing_sleep({});
  scene.bodies = {body_with(box_shape(10, 1), {0, -0.5}, BodyType::kinematic), body_with(box_shape(1, 1), {0, 0.5})};
  scene.bodies[0].velocity = {0, 1e-4};
  CHECK_FALSE(falls_asleep(scene, BodyId{2}, 3));
  scene.bodies[0].velocity = {};
  auto simulation = asleep(scene);
  REQUIRE(simulation->asleep(BodyId{2}));
  ChangeBody lifts;
  lifts.body = BodyId{1};
  lifts.velocity = Vec2d{0, 0.5};
  simulation->apply(lifts);
  CHECK_FALSE(simulation->asleep(BodyId{2}));
  run(*simulation, 1);
  CHECK(simulation->body(BodyId{2}).position.y == Approx(1).margin(0.01));

  auto other = asleep(resting_box());
  BodyDef ram = body_with(box_shape(1, 0.5), {-2, 0.5}, BodyType::kinematic);
  ram.velocity = {1, 0};
  other->apply(CreateBody{ram});
  run(*other, 0.9);
  CHECK(other->asleep(BodyId{2}));
  run(*other, 0.6);
  CHECK(other->body(BodyId{2}).position.x == Approx(0.5).margin(0.02));
}

TEST_CASE("A belt that runs keeps awake what it rubs, even what a wall holds", "[sleep]") {
  Scene scene = resting_box();
  scene.bodies[0].shapes[0].surface_speed = -0.5;
  scene.bodies.push_back(body_with(box_shape(1, 4), {1.01, 2}, BodyType::fixed));
  CHECK_FALSE(falls_asleep(scene, BodyId{2}, 4));
}

TEST_CASE("A running motor keeps awake, one that brakes does not", "[sleep]") {
  Scene scene = lone(box_shape(2, 0.2), {0, -g});
  scene.effects.reset();
  scene.bodies[0].position = {0.5, 0};
  scene.joints = {joint_between(JointKind::revolute, BodyId::world, {0, 0}, BodyId{1}, {-0.5, 0})};
  scene.joints[0].limits = LimitsDef{-0.1, 0.1};
  scene.joints[0].motor = MotorDef{1, 100};
  CHECK_FALSE(falls_asleep(scene, BodyId{1}, 4));
  scene.joints[0].motor = MotorDef{0, 100};
  auto simulation = asleep(scene, BodyId{1});
  REQUIRE(simulation->asleep(BodyId{1}));
  ChangeJoint starts;
  starts.joint = JointId{0};
  starts.speed = 1;
  simulation->apply(starts);
  run(*simulation, 0.05);
  CHECK(simulation->body(BodyId{1}).angle > 0.03);
}

TEST_CASE("A burning rocket that cannot lift off keeps awake until its fuel is gone", "[sleep]") {
  Scene scene = resting_box();
  scene.rockets = {{BodyId{2}, 5, 0.01, 0.02, {}}};  // 2 s
  const auto tick = tick_of_sleep(*simulate(scene), BodyId{2}, 5);
  REQUIRE(tick);
  CHECK(static_cast<double>(*tick) / 240 >= 2.0);
}

TEST_CASE("What bobs does not sleep, what lies on the bottom does", "[sleep]") {
  Scene scene = allowing_sleep(with_floor(body_with(box_shape(1, 0.5), {0, 3.05})));
  scene.water = WaterDef{3, 2, 0.05};
  CHECK_FALSE(falls_asleep(scene, BodyId{2}, 20));
  scene.bodies[1].shapes[0].density = 5;
  scene.bodies[1].position = {0, 0.25};
  auto simulation = asleep(scene);
  CHECK(simulation->asleep(BodyId{2}));
  run(*simulation, 1);
  CHECK(simulation->body(BodyId{2}).position.y == Approx(0.25).margin(0.01));
}

TEST_CASE("A force field that changes wakes whom it changes for", "[sleep]") {
  Scene scene = resting_box();
  scene.fields.emplace_back([](Vec2d, Vec2d, double time) { return Vec2d{time < 2 ? 1.0 : 20.0, 0}; });
  auto simulation = simulate(scene);
  const auto tick = tick_of_sleep(*simulation, BodyId{2}, 1.9);
  REQUIRE(tick);
  run(*simulation, 3.0 - static_cast<double>(*tick) / 240);
  // Friction gives half the weight: 20 N - 4.9 N on 1 kg for a second.
  CHECK(simulation->body(BodyId{2}).position.x == Approx(0.5 * (20 - 0.5 * g)).epsilon(0.02));
}

TEST_CASE("Where a force field changes all the time nobody sleeps", "[sleep]") {
  Scene scene = resting_box();
  scene.fields.emplace_back([](Vec2d, Vec2d, double time) { return Vec2d{0.1 * time, 0}; });
  CHECK_FALSE(falls_asleep(scene, BodyId{2}, 3));
}

TEST_CASE("Sleepers wake when what pulls them goes away", "[sleep]") {
  Scene scene = resting_box();
  scene.bodies.push_back(body_with(disc_shape(0.5), {0, 50}, BodyType::fixed));
  scene.attractors = {{BodyId{3}, {}, 10, AttractionLaw::inverse_square}};
  auto simulation = asleep(scene);
  REQUIRE(simulation->asleep(BodyId{2}));
  simulation->apply(RemoveBody{BodyId{3}});
  CHECK_FALSE(simulation->asleep(BodyId{2}));
}

TEST_CASE("Bodies pulled by what moves do not sleep, those pulled by what stands still do", "[sleep]") {
  Scene scene = resting_box();
  scene.bodies.push_back(body_with(disc_shape(0.5), {0, 50}, GENERATE(BodyType::kinematic, BodyType::fixed)));
  scene.attractors = {{BodyId{3}, {}, 10, AttractionLaw::inverse_square}};
  CHECK(falls_asleep(scene, BodyId{2}, 3) == (scene.bodies[2].type == BodyType::fixed));
  scene.attractors.clear();
  scene.gravitational_constant = 1e-9;
  CHECK_FALSE(falls_asleep(scene, BodyId{2}, 3));
}

TEST_CASE("Constant wind blows over sleepers", "[sleep]") {
  Scene scene = resting_box();
  scene.drag = {1, 0, 0};
  scene.wind = {2, 0};
  auto simulation = asleep(scene);
  REQUIRE(simulation->asleep(BodyId{2}));
  const Vec2d before = simulation->body(BodyId{2}).center;
  run(*simulation, 1);
  CHECK(simulation->body(BodyId{2}).center == before);
}

TEST_CASE("What swings on a resting body keeps all of its island awake", "[sleep]") {
  Scene scene = resting_box();
  scene.bodies.push_back(body_with(disc_shape(0.1), {0.2, 0.6}));
  scene.joints = {joint_between(JointKind::revolute, BodyId{2}, {0, 0.3}, BodyId{3}, {-0.2, 0.2})};
  CHECK_FALSE(falls_asleep(scene, BodyId{2}, 5));
  scene.bodies[2].position = {0, 0.6};
  scene.joints[0].anchor_b = {0, 0.2};
  CHECK(falls_asleep(scene, BodyId{2}, 5));
}

TEST_CASE("Sleep with nothing to act on changes no bit", "[sleep]") {
  Scene scene;
  for (int i = 0; i < 10; ++i) scene.bodies.push_back(body_with(box_shape(0.5, 0.4), {0.3 * i, 1.0 + i}));
  scene.bodies.push_back(floor_body());
  auto plain = simulate(scene);
  auto watched = simulate(allowing_sleep(scene));
  for (int i = 0; i < 180; ++i) {
    plain->step();
    watched->step();
    REQUIRE(watched->sleep_events().empty());
    REQUIRE(plain->state_hash() == watched->state_hash());
  }
}

TEST_CASE("To fall asleep costs next to no energy", "[sleep]") {
  auto simulation = simulate(stack(5));
  double before = 0;
  while (!simulation->asleep(BodyId{2}) && simulation->tick() < 5 * 240) {
    before = simulation->energy().total();
    simulation->step();
  }
  CHECK(simulation->energy().total() == Approx(before).epsilon(pick(1e-6, 1e-5)));
  CHECK(simulation->energy().kinetic == 0);
}

TEST_CASE("Integrators that take all bodies together refuse to let some sleep", "[sleep]") {
  Scene scene = pendulum(1, 0);
  scene.joints[0].kind = JointKind::spring;
  scene.effects = EffectSet{Effect::gravity, Effect::springs, Effect::sleeping};
  scene.method.integrator = GENERATE(Integrator::rk4, Integrator::suzuki4, Integrator::gauss_legendre6);
  const auto problem = problem_with_method(scene);
  REQUIRE(problem);
  CHECK_THAT(*problem, Catch::Contains("cannot leave out bodies that sleep"));
}

TEST_CASE("The decision on sleep tells its reason", "[sleep]") {
  const auto why = [](const Scene& scene) { return simulate(scene)->effects().back().why; };
  Scene scene = resting_box();
  CHECK(why(scene) == "on_sleep is used");
  scene.effects = EffectSet{Effect::gravity, Effect::contacts};
  CHECK(why(scene) == "the list of effects omits it, though on_sleep is used");
  scene.sleeping = false;
  CHECK(why(scene) == "no on_sleep is used, and no list of effects names it");
  scene.effects = EffectSet{Effect::gravity, Effect::contacts, Effect::sleeping};
  CHECK(why(scene) == "the list of effects names it");
}
