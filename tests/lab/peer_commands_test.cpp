#include "tests/lab/peer_scenes.h"

namespace proofreel {
namespace {

using namespace test;

/// One box of 1 kg in empty space.
Scene free_box() {
  Scene scene = scene_of({body_with(box_shape(1, 1), {0, 0})});
  scene.gravity = {};
  return scene;
}

TEST_CASE("Bodies come to a peer and go, and their joints with them", "[peers]") {
  const auto simulation = make_peer(each_peer(), scene_of({floor_body()}));
  simulation->apply(CreateBody{body_with(box_shape(1, 1), {0, 0.5})});
  simulation->apply(CreateBody{body_with(box_shape(1, 1), {0, 1.5})});
  JointDef pin = joint_of(JointKind::weld, {0, 0.5}, {0, -0.5});
  pin.a = second;
  pin.b = static_cast<BodyId>(3);
  simulation->apply(CreateJoint{pin});
  run(*simulation, 1);
  REQUIRE(simulation->body(pin.b).position.y == Approx(1.5).margin(0.03));
  simulation->apply(RemoveBody{second});
  REQUIRE_FALSE(simulation->exists(second));
  REQUIRE_FALSE(simulation->exists(JointId{}));
  REQUIRE(simulation->joint(JointId{}).reaction == Vec2d{});  // may still be asked for
  run(*simulation, 2);
  REQUIRE(simulation->body(pin.b).position.y == Approx(0.5).margin(0.03));
  Snapshot snapshot;
  simulation->observe(snapshot);
  REQUIRE(snapshot.bodies.size() == 2);
  REQUIRE(snapshot.joints.empty());
}

TEST_CASE("Impulses, forces and torques move a peer's body as Newton says", "[peers]") {
  const auto simulation = make_peer(each_peer(), free_box());
  simulation->apply(ApplyImpulse{first, {1, 0}, Vec2d{0, 0.5}});
  REQUIRE(simulation->body(first).velocity.x == Approx(1));
  REQUIRE(simulation->body(first).spin == Approx(-3));  // 0.5 N m s over 1/6 kg m^2
  REQUIRE(simulation->energy().booked_work == Approx(0.5 + 0.75));
  simulation->apply(ApplyForce{first, {0, 6}, Vec2d{0.5, 0}});
  simulation->apply(ApplyTorque{first, 15});
  simulation->step();
  REQUIRE(simulation->body(first).velocity.y == Approx(0.1));
  REQUIRE(simulation->body(first).spin == Approx(-3 + 6 * (3 + 15) / 60.0));
  simulation->step();
  REQUIRE(simulation->body(first).velocity.y == Approx(0.1));
}

TEST_CASE("A peer's body changes as told and keeps the rest", "[peers]") {
  Scene scene = free_box();
  scene.gravity = {0, -g};
  scene.bodies[0].velocity = {1, 0};
  const auto simulation = make_peer(each_peer(), scene);
  ChangeBody change;
  change.body = first;
  change.position = Vec2d{5, 6};
  change.gravity_scale = -1;
  change.mass = 4;
  simulation->apply(change);
  run(*simulation, 1);
  REQUIRE(simulation->body(first).position.x == Approx(6).epsilon(1e-4));
  REQUIRE(simulation->body(first).velocity.y == Approx(g).epsilon(1e-4));
  REQUIRE(simulation->body(first).mass == 4);
  ChangeBody fix;
  fix.body = first;
  fix.type = BodyType::fixed;
  simulation->apply(fix);
  const Vec2d place = simulation->body(first).position;
  run(*simulation, 1);
  REQUIRE(simulation->body(first).position == place);
  ChangeBody drive;
  drive.body = first;
  drive.type = BodyType::kinematic;
  drive.velocity = Vec2d{0, 2};
  simulation->apply(drive);
  run(*simulation, 1);
  REQUIRE(simulation->body(first).position.y == Approx(place.y + 2).epsilon(1e-4));
}

TEST_CASE("A peer's body that gets another shape turns about its new centre of mass", "[peers]") {
  Scene scene = free_box();
  scene.bodies[0].spin = 2;
  const auto simulation = make_peer(each_peer(), scene);
  ShapeDef shifted = box_shape(1, 1);
  for (Vec2d& p : shifted.points) p += Vec2d{1, 0};
  ChangeBody change;
  change.body = first;
  change.shapes = std::vector<ShapeDef>{shifted};
  simulation->apply(change);
  REQUIRE(simulation->body(first).position.x == Approx(0).margin(1e-6));
  REQUIRE(simulation->body(first).center.x == Approx(1));
  REQUIRE(simulation->body(first).velocity.y == Approx(2));
  run(*simulation, 1);
  REQUIRE(simulation->body(first).center.y == Approx(2).epsilon(1e-4));
}

TEST_CASE("A command for what a peer lacks is refused with a sentence and changes nothing", "[peers]") {
  const Peer peer = each_peer();
  const auto simulation = make_peer(peer, free_box());
  const std::uint64_t before = simulation->state_hash();
  BodyDef rolling = body_with(disc_shape(1), {0, 0});
  rolling.shapes[0].rolling_resistance = 1;
  REQUIRE_THROWS_WITH(simulation->apply(CreateBody{rolling}), Catch::Contains("cannot step body 2"));
  ChangeBody change;
  change.body = first;
  change.rolling_resistance = 1;
  REQUIRE_THROWS_AS(simulation->apply(change), UnknownToPeer);
  REQUIRE_THROWS_AS(simulation->apply(CreateJoint{joint_of(JointKind::motor, {}, {})}), UnknownToPeer);
  REQUIRE(simulation->state_hash() == before);
  REQUIRE_FALSE(simulation->exists(second));
}

TEST_CASE("A number that is none stops a peer with tick and body", "[peers]") {
  const auto simulation = make_peer(Peer::chipmunk, free_box());
  simulation->step();
  simulation->apply(ApplyImpulse{first, {1e308, 0}, {}});
  simulation->apply(ApplyImpulse{first, {1e308, 0}, {}});
  run(*simulation, 1);
  REQUIRE(simulation->failure());
  REQUIRE(simulation->failure()->body == first);
  REQUIRE(simulation->failure()->tick == 2);
  REQUIRE(simulation->tick() == 2);
}

TEST_CASE("A peer keeps the forces on its bodies when asked", "[peers]") {
  const auto simulation = make_peer(each_peer(), scene_of({body_with(box_shape(1, 2), {0, 9})}));
  simulation->keep_forces();
  simulation->step();
  Snapshot snapshot;
  simulation->observe(snapshot);
  REQUIRE(snapshot.bodies[0].force.y == Approx(-2 * g).epsilon(1e-4));
}

}  // namespace
}  // namespace proofreel
