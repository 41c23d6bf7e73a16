#include <catch2/catch.hpp>
#include <cmath>

#include "tests/engine/scenes.h"

using namespace proofreel;
using namespace proofreel::test;

// Stops, motors, pulls and breaking.

namespace {

constexpr double g = 9.81;

/// A bar of 1 m on a hinge at its left end, horizontal.
Scene hinged_bar() {
  Scene scene;
  scene.bodies = {body_with(box_shape(1, 0.1), {0.5, 0})};
  scene.joints = {joint_between(JointKind::revolute, BodyId::world, {0, 0}, BodyId{1}, {-0.5, 0})};
  return scene;
}

/// A disc on a pin through its centre.
Scene wheel_on_pin() {
  Scene scene;
  scene.bodies = {body_with(disc_shape(0.5), {0, 0})};
  scene.bodies[0].mass = 2;
  scene.joints = {joint_between(JointKind::revolute, BodyId::world, {0, 0}, BodyId{1}, {0, 0})};
  return scene;
}

double energy_error(const Simulation& simulation, double start) {
  const Energy now = simulation.energy();
  return std::abs(now.total() - now.booked_work - start);
}

}  // namespace

TEST_CASE("A bar that falls onto its stop stays there and never goes beyond it", "[joint]") {
  const double lower = GENERATE(-0.7, -0.1, 0.0);
  Scene scene = hinged_bar();
  scene.joints[0].limits = LimitsDef{lower, 0.3};
  auto simulation = simulate(scene);
  double lowest = 0;
  for (int i = 0; i < 3 * 240; ++i) {
    simulation->step();
    lowest = std::min(lowest, simulation->body(BodyId{1}).angle);
  }
  CHECK(lowest > lower - pick(1e-9, 1e-5));
  CHECK(simulation->body(BodyId{1}).angle == Approx(lower).margin(pick(1e-9, 1e-5)));
  CHECK(std::abs(simulation->body(BodyId{1}).spin) < pick(1e-9, 1e-5));
  const double weight = simulation->body(BodyId{1}).mass * g;
  CHECK(simulation->joint(JointId{0}).torque == Approx(0.5 * std::cos(lower) * weight).epsilon(pick(1e-6, 1e-3)));
}

TEST_CASE("A stop reached at speed adds no energy", "[joint]") {
  Scene scene = hinged_bar();
  scene.bodies[0].spin = 9;
  scene.bodies[0].velocity = {0, 4.5};
  scene.joints[0].limits = LimitsDef{-0.5, 1};
  auto simulation = simulate(scene);
  double before = simulation->energy().total();
  double rises = 0;
  double highest = 0;
  double lowest = 0;
  for (int i = 0; i < 4 * 240; ++i) {
    simulation->step();
    const double now = simulation->energy().total();
    rises = std::max(rises, now - before);
    before = now;
    highest = std::max(highest, simulation->body(BodyId{1}).angle);
    lowest = std::min(lowest, simulation->body(BodyId{1}).angle);
  }
  CHECK(highest == Approx(1).margin(1e-4));
  CHECK(highest < 1 + pick(1e-9, 1e-5));
  CHECK(lowest > -0.5 - pick(1e-9, 1e-5));
  CHECK(rises < 1e-3);
}

TEST_CASE("A hinge whose limits are one angle is a weld", "[joint]") {
  Scene scene = hinged_bar();
  scene.joints[0].limits = LimitsDef{0, 0};
  auto simulation = simulate(scene);
  run(*simulation, 2);
  CHECK(simulation->body(BodyId{1}).angle == Approx(0).margin(pick(1e-12, 1e-5)));
}

TEST_CASE("A joint made outside its limits goes there gently", "[joint]") {
  Scene scene = hinged_bar();
  scene.gravity = {0, 0};
  scene.joints[0].limits = LimitsDef{0.5, 1};
  auto simulation = simulate(scene);
  run(*simulation, 1);
  CHECK(simulation->body(BodyId{1}).angle == Approx(0.5).margin(pick(1e-6, 1e-4)));
  CHECK(std::abs(simulation->body(BodyId{1}).spin) < 1e-3);
}

TEST_CASE("A slider comes to rest at the end of its rail", "[joint]") {
  Scene scene;
  scene.bodies = {body_with(box_shape(0.2, 0.2), {0, 0})};
  scene.joints = {joint_between(JointKind::prismatic, BodyId::world, {0, 0}, BodyId{1}, {0, 0})};
  scene.joints[0].axis = {0, 1};
  scene.joints[0].limits = LimitsDef{-1, 1};
  auto simulation = simulate(scene);
  double lowest = 0;
  for (int i = 0; i < 480; ++i) {
    simulation->step();
    lowest = std::min(lowest, simulation->body(BodyId{1}).position.y);
  }
  CHECK(lowest == Approx(-1).margin(pick(1e-9, 1e-5)));
  CHECK(simulation->body(BodyId{1}).position.y == Approx(-1).margin(pick(1e-9, 1e-5)));
  CHECK(simulation->joint(JointId{0}).reaction.y ==
        Approx(simulation->body(BodyId{1}).mass * g).epsilon(pick(1e-6, 1e-3)));
}

TEST_CASE("Limits that are never reached change no bit of the motion", "[joint]") {
  Scene with = hinged_bar();
  with.joints[0].limits = LimitsDef{-10, 10};
  auto limited = simulate(with);
  auto free = simulate(hinged_bar());
  run(*limited, 5);
  run(*free, 5);
  CHECK(limited->state_hash() == free->state_hash());
}

TEST_CASE("A motor speeds a wheel up by torque / inertia, and then keeps its speed", "[joint]") {
  Scene scene = wheel_on_pin();
  scene.joints[0].motor = MotorDef{6, 0.5};
  auto simulation = simulate(scene);
  const double inertia = simulation->body(BodyId{1}).inertia;
  run(*simulation, 1);
  CHECK(simulation->body(BodyId{1}).spin == Approx(0.5 / inertia).epsilon(pick(3e-3, 3e-3)));
  CHECK(simulation->body(BodyId{1}).angle == Approx(0.25 / inertia).epsilon(1e-2));
  CHECK(simulation->joint(JointId{0}).torque == Approx(0.5).epsilon(1e-4));
  run(*simulation, 4);
  CHECK(simulation->body(BodyId{1}).spin == Approx(6).epsilon(pick(1e-5, 1e-4)));
  CHECK(std::abs(simulation->joint(JointId{0}).torque) < pick(1e-6, 1e-2));
  CHECK(simulation->energy().booked_work == Approx(0.5 * inertia * 36).epsilon(pick(1e-5, 1e-3)));
}

TEST_CASE("A motor holds what it is strong enough for, and stalls at its torque", "[joint]") {
  Scene scene = hinged_bar();
  const bool holds = GENERATE(true, false);
  const double torque = 0.1 * g * 0.5;  // of the bar's weight, 0.1 kg
  scene.joints[0].motor = MotorDef{0, (holds ? 1.01 : 0.6) * torque};
  auto simulation = simulate(scene);
  double strongest = 0;
  for (int i = 0; i < 480; ++i) {
    simulation->step();
    strongest = std::max(strongest, std::abs(simulation->joint(JointId{0}).torque));
  }
  CHECK(strongest <= scene.joints[0].motor->strongest * (1 + pick(1e-9, 1e-4)));
  if (holds) {
    CHECK(std::abs(simulation->body(BodyId{1}).angle) < pick(1e-4, 1e-3));
    CHECK(std::abs(simulation->body(BodyId{1}).spin) < pick(1e-9, 1e-4));
  } else {
    CHECK(simulation->body(BodyId{1}).angle < -0.5);
    CHECK(strongest == Approx(0.6 * torque).epsilon(1e-4));
  }
}

TEST_CASE("A motor whose load changes all the time keeps time over many turns, not only its speed", "[joint]") {
  Scene scene = hinged_bar();
  scene.joints[0].motor = MotorDef{5, 100};
  auto simulation = simulate(scene);
  run(*simulation, 1);
  const double begun = simulation->body(BodyId{1}).angle;
  run(*simulation, 20);
  CHECK(simulation->body(BodyId{1}).angle - begun == Approx(100).margin(pick(2e-3, 5e-3)));
  CHECK(simulation->body(BodyId{1}).spin == Approx(5).epsilon(2e-3));
}

TEST_CASE("A motor does not make up for the time in which it gave all it has", "[joint]") {
  Scene scene = wheel_on_pin();
  scene.joints[0].motor = MotorDef{6, 0.5};
  auto simulation = simulate(scene);
  double fastest = 0;
  for (int i = 0; i < 5 * 240; ++i) {
    simulation->step();
    fastest = std::max(fastest, simulation->body(BodyId{1}).spin);
  }
  CHECK(fastest < 6 * 1.006);
}

TEST_CASE("A motor holds under symplectic Euler as well", "[joint]") {
  Scene scene = hinged_bar();
  scene.method.integrator = Integrator::symplectic_euler;
  scene.joints[0].motor = MotorDef{0, 2};
  auto simulation = simulate(scene);
  run(*simulation, 2);
  CHECK(std::abs(simulation->body(BodyId{1}).angle) < pick(1e-4, 1e-3));
  CHECK(std::abs(simulation->body(BodyId{1}).spin) < pick(1e-9, 1e-4));
}

TEST_CASE("A motor's work is booked, whatever it drives", "[joint]") {
  Scene scene = hinged_bar();
  scene.joints[0].motor = MotorDef{3, 2};
  auto simulation = simulate(scene);
  const double start = simulation->energy().total();
  run(*simulation, 5);
  CHECK(simulation->energy().booked_work != 0);
  CHECK(energy_error(*simulation, start) < 2e-3);
}

TEST_CASE("A slider's motor lifts it at its speed with as much force as it weighs", "[joint]") {
  Scene scene;
  scene.bodies = {body_with(box_shape(0.2, 0.2), {0, 0})};
  scene.bodies[0].mass = 3;
  scene.joints = {joint_between(JointKind::prismatic, BodyId::world, {0, 0}, BodyId{1}, {0, 0})};
  scene.joints[0].axis = {0, 1};
  scene.joints[0].motor = MotorDef{0.5, 100};
  auto simulation = simulate(scene);
  run(*simulation, 2);
  CHECK(simulation->body(BodyId{1}).velocity.y == Approx(0.5).epsilon(pick(1e-5, 1e-3)));
  CHECK(simulation->body(BodyId{1}).position.y == Approx(1).epsilon(1e-2));
  CHECK(simulation->joint(JointId{0}).reaction.y == Approx(3 * g).epsilon(pick(1e-5, 1e-3)));
}

TEST_CASE("A motor against a stop pushes with all it has and moves nothing", "[joint]") {
  Scene scene = wheel_on_pin();
  scene.joints[0].limits = LimitsDef{-1, 1};
  scene.joints[0].motor = MotorDef{5, 1};
  auto simulation = simulate(scene);
  run(*simulation, 3);
  CHECK(simulation->body(BodyId{1}).angle == Approx(1).margin(pick(1e-6, 1e-4)));
  CHECK(simulation->body(BodyId{1}).spin == Approx(0).margin(pick(1e-6, 1e-4)));
}

TEST_CASE("A motor between two free bodies keeps their momentum and angular momentum", "[joint]") {
  Scene scene;
  scene.gravity = {0, 0};
  scene.bodies = {body_with(box_shape(1, 0.4), {-1, 0}), body_with(disc_shape(0.3), {1, 0.5})};
  JointDef motor = joint_between(JointKind::motor, BodyId{1}, {0, 0}, BodyId{2}, {0, 0});
  motor.motor = MotorDef{4, 0.3};
  motor.velocity = {0.4, 0.2};
  motor.max_force = 0.5;
  scene.joints = {motor};
  auto simulation = simulate(scene);
  const double start = simulation->energy().total();
  run(*simulation, 3);
  Vec2d momentum;
  double angular = 0;
  for (const BodyId id : {BodyId{1}, BodyId{2}}) {
    const BodyState s = simulation->body(id);
    momentum += s.mass * s.velocity;
    angular += s.inertia * s.spin + s.mass * cross(s.center, s.velocity);
  }
  CHECK(length(momentum) < pick(1e-12, 1e-5));
  CHECK(std::abs(angular) < pick(1e-12, 1e-5));
  CHECK(simulation->body(BodyId{2}).spin - simulation->body(BodyId{1}).spin == Approx(4).epsilon(pick(1e-4, 1e-3)));
  CHECK(energy_error(*simulation, start) < pick(1e-12, 1e-5));
}

TEST_CASE("A motor's speed can be changed on the way", "[joint]") {
  Scene scene = wheel_on_pin();
  scene.joints[0].motor = MotorDef{6, 5};
  auto simulation = simulate(scene);
  run(*simulation, 1);
  ChangeJoint change;
  change.joint = JointId{0};
  change.speed = -2;
  simulation->apply(change);
  run(*simulation, 1);
  CHECK(simulation->body(BodyId{1}).spin == Approx(-2).epsilon(pick(1e-5, 1e-3)));
}

TEST_CASE("A pull follows its target, and never pulls harder than it may", "[joint]") {
  Scene scene;
  scene.bodies = {body_with(box_shape(0.4, 0.4), {0, 0})};
  scene.bodies[0].mass = 2;
  JointDef pull = joint_between(JointKind::drag_to, BodyId::world, {0, 0}, BodyId{1}, {0, 0});
  pull.target = {3, 1};
  pull.max_force = 60;
  scene.joints = {pull};
  auto simulation = simulate(scene);
  const double start = simulation->energy().total();
  double strongest = 0;
  for (int i = 0; i < 5 * 240; ++i) {
    simulation->step();
    strongest = std::max(strongest, length(simulation->joint(JointId{0}).reaction));
  }
  CHECK(strongest <= 60 * (1 + pick(1e-9, 1e-5)));
  CHECK(strongest > 59);
  const JointView view = simulation->joint(JointId{0});
  CHECK(distance(view.anchor_b, {3, 1}) < 0.05);
  CHECK(view.reaction.y == Approx(2 * g).epsilon(0.05));
  CHECK(energy_error(*simulation, start) < 0.05);
  ChangeJoint change;
  change.joint = JointId{0};
  change.target = Vec2d{-1, 0};
  simulation->apply(change);
  run(*simulation, 5);
  CHECK(distance(simulation->joint(JointId{0}).anchor_b, {-1, 0}) < 0.05);
}

TEST_CASE("A joint holds a load just below what it can bear, and breaks just above", "[joint]") {
  Scene scene;
  scene.bodies = {body_with(disc_shape(0.1), {0, -1})};
  scene.bodies[0].mass = 5;
  const JointKind kind = GENERATE(JointKind::distance, JointKind::weld, JointKind::revolute, JointKind::rope);
  const Vec2d hook = kind == JointKind::distance || kind == JointKind::rope ? Vec2d{0, 0} : Vec2d{0, -1};
  scene.joints = {joint_between(kind, BodyId::world, hook, BodyId{1}, {0, 0}, 1)};
  scene.joints[0].break_force = 5 * g * 1.001;
  auto holding = simulate(scene);
  run(*holding, 2);
  CHECK(holding->exists(JointId{0}));
  scene.joints[0].break_force = 5 * g * 0.999;
  auto breaking = simulate(scene);
  breaking->step();
  REQUIRE(breaking->break_events().size() == 1);
  CHECK(breaking->break_events()[0].reaction.y == Approx(5 * g).epsilon(pick(1e-6, 1e-3)));
  CHECK_FALSE(breaking->exists(JointId{0}));
  CHECK(breaking->joint(JointId{0}).broken);
  breaking->step();
  CHECK(breaking->break_events().empty());
  run(*breaking, 1);
  CHECK(breaking->body(BodyId{1}).velocity.y == Approx(-g * 241 / 240).epsilon(1e-2));
}

TEST_CASE("A broken joint takes its gears along", "[joint]") {
  Scene scene;
  scene.bodies = {body_with(disc_shape(0.2), {0, 0}), body_with(disc_shape(0.2), {1, 0})};
  for (BodyDef& body : scene.bodies) body.mass = 1;
  scene.joints = {joint_between(JointKind::revolute, BodyId::world, {0, 0}, BodyId{1}, {0, 0}),
                  joint_between(JointKind::revolute, BodyId::world, {1, 0}, BodyId{2}, {0, 0}),
                  joint_between(JointKind::gear, BodyId{1}, {0, 0}, BodyId{2}, {0, 0})};
  scene.joints[2].second = JointId{1};
  scene.joints[0].break_force = 1;
  auto simulation = simulate(scene);
  run(*simulation, 0.1);
  CHECK_FALSE(simulation->exists(JointId{2}));
  CHECK(simulation->exists(JointId{1}));
}

TEST_CASE("Joint effects are inferred, and a list without them leaves them out", "[joint]") {
  Scene scene = hinged_bar();
  scene.joints[0].limits = LimitsDef{-0.2, 0.2};
  const EffectSet inferred = effects_of(scene);
  CHECK(inferred.has(Effect::limits));
  CHECK_FALSE(inferred.has(Effect::motors));
  CHECK_FALSE(inferred.has(Effect::breakage));
  scene.effects = EffectSet{};
  scene.effects->add(Effect::gravity);
  scene.effects->add(Effect::joints);
  auto unlimited = simulate(scene);
  auto free = simulate(hinged_bar());
  run(*unlimited, 1);
  run(*free, 1);
  CHECK(unlimited->state_hash() == free->state_hash());
}

TEST_CASE("A kinematic body's push through a rail is booked as work", "[joint]") {
  Scene scene;
  scene.bodies = {body_with(box_shape(1, 0.2), {0, 0}, BodyType::kinematic), body_with(box_shape(0.2, 0.2), {0.2, 0})};
  scene.bodies[0].spin = 2;
  scene.bodies[1].spin = 2;
  scene.bodies[1].velocity = {0, 0.4};
  scene.bodies[1].mass = 1;
  scene.joints = {joint_between(JointKind::prismatic, BodyId{1}, {0.2, 0}, BodyId{2}, {0, 0})};
  auto simulation = simulate(scene);
  const double start = simulation->energy().total();
  run(*simulation, 1);
  CHECK(simulation->energy().booked_work > 1);
  CHECK(energy_error(*simulation, start) < 0.02 * simulation->energy().total());
}

TEST_CASE("A platform held by a motor alone carries a box ten times as heavy", "[joint]") {
  Scene scene;
  scene.bodies = {body_with(box_shape(2, 0.2), {0, 0}), body_with(box_shape(1, 1), {0, 0.6})};
  scene.bodies[0].mass = 1;
  scene.bodies[1].mass = 10;
  JointDef lift;
  lift.kind = JointKind::prismatic;
  lift.b = BodyId{1};
  lift.axis = {0, 1};
  lift.motor = MotorDef{0, 5000};
  scene.joints = {lift};
  const auto simulation = simulate(scene);
  run(*simulation, 6);
  CHECK(simulation->body(BodyId{1}).position.y == Approx(0).margin(2e-3));
  CHECK(simulation->joint(JointId{0}).reaction.y == Approx(11 * 9.81).epsilon(pick(1e-6, 1e-3)));
}
