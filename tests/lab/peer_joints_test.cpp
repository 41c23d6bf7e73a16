#include "tests/lab/peer_scenes.h"

namespace proofreel {
namespace {

using namespace test;

constexpr JointId joint{};

/// A box of 1 kg at (1, 0), held by a joint to the world.
Scene held_box(const JointDef& held) {
  Scene scene = scene_of({body_with(box_shape(1, 1), {1, 0})});
  scene.joints = {held};
  return scene;
}

TEST_CASE("A joint of a peer keeps what ours of its kind keeps", "[peers]") {
  const Peer peer = each_peer();
  JointDef held = joint_of(GENERATE(JointKind::revolute, JointKind::weld, JointKind::distance, JointKind::rope,
                                    JointKind::prismatic, JointKind::wheel),
                           {0, 0}, {-1, 0});
  held.axis = {0.6, -0.8};
  held.stiffness = 1000;
  held.damping = 10;
  if (held.kind == JointKind::distance || held.kind == JointKind::rope) {
    held.anchor_b = {0, 0};
    held.length = 1;
  }
  const auto simulation = make_peer(peer, held_box(held));
  CAPTURE(static_cast<int>(held.kind), name_of(peer));
  for (int i = 0; i < 60; ++i) {
    simulation->step();
    REQUIRE(simulation->joint(joint).gap < 0.03);
  }
  const BodyState state = simulation->body(first);
  if (held.kind == JointKind::weld) REQUIRE(std::abs(state.angle) < 0.02);
  if (held.kind == JointKind::prismatic) {
    REQUIRE(std::abs(state.angle) < 0.02);
    REQUIRE(dot(state.velocity, held.axis) == Approx(0.8 * g).epsilon(0.01));
  } else if (held.kind != JointKind::weld) {
    REQUIRE(state.velocity.y != Approx(-g).epsilon(0.01));
  }
}

TEST_CASE("A pin of a peer tells the weight it carries", "[peers]") {
  const auto simulation = make_peer(each_peer(), held_box(joint_of(JointKind::revolute, {1, 0.5}, {0, 0.5})));
  run(*simulation, 1);
  REQUIRE(simulation->joint(joint).reaction.y == Approx(g).epsilon(0.01));
}

TEST_CASE("A spring of a peer hangs as long as its load stretches it", "[peers]") {
  JointDef spring = joint_of(JointKind::spring, {1, 1}, {0, 0});
  spring.length = 1;
  spring.stiffness = 100;
  spring.damping = 20;
  const auto simulation = make_peer(each_peer(), held_box(spring));
  run(*simulation, 5);
  REQUIRE(simulation->body(first).position.y == Approx(-g / 100).epsilon(0.01));
  REQUIRE(simulation->joint(joint).reaction.y == Approx(g).epsilon(0.01));
  REQUIRE(simulation->energy().potential == Approx(-g * g / 100 + 0.5 * g * g / 100).epsilon(0.02));
}

TEST_CASE("A motor of a peer turns at its speed, and at another when told", "[peers]") {
  JointDef motor = joint_of(JointKind::revolute, {1, 0}, {0, 0});
  motor.motor = MotorDef{2, 100};
  const auto simulation = make_peer(each_peer(), held_box(motor));
  run(*simulation, 1);
  REQUIRE(simulation->body(first).spin == Approx(2).epsilon(1e-3));
  ChangeJoint change;
  change.speed = -1;
  simulation->apply(change);
  run(*simulation, 1);
  REQUIRE(simulation->body(first).spin == Approx(-1).epsilon(1e-3));
}

TEST_CASE("Stops of a peer hold where ours do", "[peers]") {
  JointDef hinge = joint_of(JointKind::revolute, {0, 0}, {-1, 0});
  hinge.limits = LimitsDef{-0.5, 0.5};
  const auto hanging = make_peer(each_peer(), held_box(hinge));
  run(*hanging, 3);
  REQUIRE(hanging->body(first).angle == Approx(-0.5).margin(0.05));
  JointDef slider = joint_of(JointKind::prismatic, {1, 0}, {0, 0});
  slider.axis = {0, -1};
  slider.limits = LimitsDef{-0.1, 0.75};
  const auto sliding = make_peer(each_peer(), held_box(slider));
  run(*sliding, 3);
  REQUIRE(sliding->body(first).position.y == Approx(-0.75).margin(0.03));
}

TEST_CASE("A joint of a peer breaks under more than its force and says so", "[peers]") {
  JointDef pin = joint_of(JointKind::revolute, {1, 0.5}, {0, 0.5});
  pin.break_force = 0.9 * g;
  const auto simulation = make_peer(each_peer(), held_box(pin));
  int broken = 0;
  for (int i = 0; i < 30; ++i) {
    simulation->step();
    broken += static_cast<int>(simulation->break_events().size());
  }
  REQUIRE(broken == 1);
  REQUIRE_FALSE(simulation->exists(joint));
  REQUIRE(simulation->joint(joint).broken);
  REQUIRE(simulation->body(first).velocity.y < -1);
}

TEST_CASE("A joint between two fixed bodies does nothing until one of them is let go", "[peers]") {
  Scene scene = held_box(joint_of(JointKind::revolute, {1, 0.5}, {0, 0.5}));
  scene.bodies[0].type = BodyType::fixed;
  const auto simulation = make_peer(each_peer(), scene);
  run(*simulation, 0.1);
  ChangeBody change;
  change.body = first;
  change.type = BodyType::dynamic;
  simulation->apply(change);
  run(*simulation, 1);
  REQUIRE(simulation->joint(joint).gap < 1e-3);
  REQUIRE(simulation->body(first).position.y == Approx(0).margin(1e-3));
  change.type = BodyType::fixed;
  simulation->apply(change);
  run(*simulation, 0.1);
  simulation->apply(RemoveJoint{joint});
  run(*simulation, 0.1);
  REQUIRE_FALSE(simulation->exists(joint));
}

TEST_CASE("Bodies of a peer that share a pin do not collide, those on a rod do", "[peers]") {
  const Peer peer = each_peer();
  for (const JointKind kind : {JointKind::revolute, JointKind::distance}) {
    Scene scene = scene_of({body_with(box_shape(1, 1), {0, 0}), body_with(box_shape(1, 1), {0.9, 0})});
    scene.gravity = {};
    JointDef pin = joint_of(kind, {0.45, 0}, {-0.45, 0});
    pin.length = kind == JointKind::distance ? 1 : 0;
    pin.a = first;
    pin.b = second;
    if (kind == JointKind::distance) pin.anchor_a = {-0.55, 0};
    scene.joints = {pin};
    const auto simulation = make_peer(peer, scene);
    run(*simulation, 1);
    REQUIRE(simulation->contacts().empty() == (kind == JointKind::revolute));
  }
}

TEST_CASE("Gears and pulleys of Box2D couple what ours couple", "[peers]") {
  Scene scene = scene_of({body_with(disc_shape(0.5), {0, 0}), body_with(disc_shape(0.5), {3, 0})});
  scene.bodies[0].spin = 1;
  JointDef pin = joint_of(JointKind::revolute, {0, 0}, {0, 0});
  scene.joints.push_back(pin);
  pin.b = second;
  pin.anchor_a = {3, 0};
  scene.joints.push_back(pin);
  JointDef gear;
  gear.kind = JointKind::gear;
  gear.second = static_cast<JointId>(1);
  gear.ratio = 2;
  scene.joints.push_back(gear);
  const auto geared = make_peer(Peer::box2d, scene);
  run(*geared, 1);
  REQUIRE(geared->body(first).angle + 2 * geared->body(second).angle == Approx(0).margin(1e-3));
  REQUIRE(std::abs(geared->body(first).angle) > 0.1);
  RemoveJoint remove;
  geared->apply(remove);
  REQUIRE_FALSE(geared->exists(static_cast<JointId>(2)));
  run(*geared, 0.1);

  scene.bodies[0].spin = 0;
  JointDef pulley;
  pulley.kind = JointKind::pulley;
  pulley.a = first;
  pulley.b = second;
  pulley.pin_a = {0, 5};
  pulley.pin_b = {3, 5};
  scene.joints = {pulley};
  scene.bodies[0].mass = 3;
  scene.bodies[1].mass = 1;
  const auto roped = make_peer(Peer::box2d, scene);
  run(*roped, 0.5);
  REQUIRE(roped->body(first).velocity.y == Approx(-0.5 * g / 2).epsilon(0.02));
  REQUIRE(roped->body(second).velocity.y == Approx(0.5 * g / 2).epsilon(0.02));
}

}  // namespace
}  // namespace proofreel
