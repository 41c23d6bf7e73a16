#include "lab/peers/peers.h"

#include "tests/lab/peer_scenes.h"

namespace proofreel {
namespace {

using namespace test;

TEST_CASE("A falling ball of a peer falls as its Euler steps add up", "[peers]") {
  const Peer peer = each_peer();
  const auto simulation = make_peer(peer, scene_of({body_with(disc_shape(0.5), {1, 20})}));
  run(*simulation, 1);
  // Box2D moves by the new velocity, Chipmunk by the old one.
  const double steps = peer == Peer::box2d ? 60 * 61 : 60 * 59;
  REQUIRE(simulation->body(first).position.y == Approx(20 - g / 3600 * steps / 2).margin(1e-4));
  REQUIRE(simulation->body(first).position.x == 1);
  REQUIRE(simulation->body(first).velocity.y == Approx(-g).epsilon(1e-5));
  REQUIRE(simulation->tick() == 60);
}

TEST_CASE("A box of a peer rests on the floor, which carries its weight", "[peers]") {
  const auto simulation = make_peer(each_peer(), scene_of({body_with(box_shape(1, 1), {0, 0.5}), floor_body()}));
  run(*simulation, 3);
  REQUIRE(simulation->body(first).position.y == Approx(0.5).margin(0.02));
  REQUIRE(length(simulation->body(first).velocity) < 1e-3);
  Snapshot snapshot;
  simulation->observe(snapshot);
  REQUIRE(snapshot.bodies.size() == 2);
  REQUIRE(snapshot.shapes.size() == 2);
  REQUIRE(snapshot.tree.empty());
  REQUIRE(snapshot.contacts.size() == 1);
  const ContactView& contact = snapshot.contacts[0];
  REQUIRE(contact.a == first);
  REQUIRE(contact.normal.y == Approx(-1));
  REQUIRE(contact.point_count == 2);
  REQUIRE(contact.points[0].normal_impulse + contact.points[1].normal_impulse == Approx(g / 60).epsilon(1e-3));
  REQUIRE(contact.points[0].point.y == Approx(0).margin(0.02));
}

TEST_CASE("A small pendulum of a peer swings with the period of its length", "[peers]") {
  Scene scene = scene_of({body_with(disc_shape(0.1), {0.05, -1})});
  scene.joints = {joint_of(JointKind::revolute, {0, 0}, {-0.05, 1})};
  const auto simulation = make_peer(each_peer(), scene);
  const double inertia = 0.5 * 0.01 + (1 + 0.05 * 0.05);  // of 1 kg
  const double omega = std::sqrt(g * std::sqrt(1.0025) / inertia);
  const double start = std::atan2(0.05, 1);
  for (const double time : {1.0, 2.0}) {
    run(*simulation, 1);
    const BodyState state = simulation->body(first);
    REQUIRE(std::atan2(state.position.x, -state.position.y) == Approx(start * std::cos(omega * time)).margin(0.004));
    REQUIRE(simulation->joint(JointId{}).gap < 2e-3);
  }
}

TEST_CASE("A box of a peer slides down a ramp with the friction sqrt(a b)", "[peers]") {
  const double slope = 0.5;
  BodyDef ramp = body_with(box_shape(100, 1), {0, 0}, BodyType::fixed);
  ramp.angle = slope;
  ramp.shapes[0].friction = {0.1, 0.1};
  const Vec2d up{-std::sin(slope), std::cos(slope)};
  BodyDef box = body_with(box_shape(1, 0.4), 0.71 * up);
  box.angle = slope;
  box.shapes[0].friction = {0.4, 0.4};
  const auto simulation = make_peer(each_peer(), scene_of({box, ramp}));
  run(*simulation, 0.5);
  const double before = length(simulation->body(first).velocity);
  run(*simulation, 1);
  const double gain = length(simulation->body(first).velocity) - before;
  REQUIRE(gain == Approx(g * (std::sin(slope) - 0.2 * std::cos(slope))).epsilon(0.01));
}

TEST_CASE("A ball of a peer bounces with the larger of the two restitutions", "[peers]") {
  BodyDef ball = body_with(disc_shape(0.2), {0, 2.2});
  ball.shapes[0].restitution = 0.8;
  const auto simulation = make_peer(each_peer(), scene_of({ball, floor_body()}));
  double top = 0;
  bool bounced = false;
  for (int i = 0; i < 90; ++i) {
    simulation->step();
    bounced |= simulation->body(first).velocity.y > 1;
    if (bounced) top = std::max(top, simulation->body(first).position.y - 0.2);
  }
  REQUIRE(top == Approx(2 * 0.64).epsilon(0.1));
}

TEST_CASE("Filters of a peer part what ours part", "[peers]") {
  const Peer peer = each_peer();
  const auto falls_through = [&](const FilterDef& floor_filter, const FilterDef& box_filter) {
    BodyDef floor = floor_body();
    floor.filter = floor_filter;
    BodyDef box = body_with(box_shape(1, 1), {0, 0.6});
    box.filter = box_filter;
    const auto simulation = make_peer(peer, scene_of({box, floor}));
    run(*simulation, 1);
    return simulation->body(first).position.y < -1;
  };
  const std::uint64_t high = std::uint64_t{1} << 20U;
  REQUIRE_FALSE(falls_through({}, {}));
  REQUIRE(falls_through({-3, 1, ~std::uint64_t{0}}, {-3, 1, ~std::uint64_t{0}}));
  REQUIRE_FALSE(falls_through({-3, 1, ~std::uint64_t{0}}, {-4, 1, ~std::uint64_t{0}}));
  REQUIRE(falls_through({0, high, ~std::uint64_t{0}}, {0, 1, ~high}));
  REQUIRE_FALSE(falls_through({0, high, ~std::uint64_t{0}}, {0, 1, high}));
}

TEST_CASE("A peer steps the same scene to the same bits twice", "[peers]") {
  const Peer peer = each_peer();
  Scene scene = scene_of({floor_body()});
  for (int i = 0; i < 40; ++i) {
    scene.bodies.push_back(body_with(i % 2 == 0 ? box_shape(0.5, 0.5) : disc_shape(0.3), {0.01 * i, 0.5 + 0.7 * i}));
  }
  std::uint64_t hashes[2];
  for (std::uint64_t& hash : hashes) {
    const auto simulation = make_peer(peer, scene);
    run(*simulation, 5);
    hash = simulation->state_hash();
  }
  REQUIRE(hashes[0] == hashes[1]);
  REQUIRE(make_peer(peer, scene)->state_hash() != hashes[0]);
}

TEST_CASE("A body of a peer is where its origin is and moves as its centre of mass does", "[peers]") {
  ShapeDef shape = box_shape(1, 1);
  for (Vec2d& p : shape.points) p += Vec2d{2, 0};
  BodyDef body = body_with(shape, {3, 4});
  body.angle = 0.5;
  body.velocity = {1, 0};
  body.spin = 2;
  Scene scene = scene_of({body});
  scene.gravity = {};
  const auto simulation = make_peer(each_peer(), scene);
  const Vec2d center = simulation->body(first).center;
  REQUIRE(center.x == Approx(3 + 2 * std::cos(0.5)));
  REQUIRE(simulation->body(first).position.x == Approx(3));
  run(*simulation, 1);
  const BodyState state = simulation->body(first);
  REQUIRE(state.center.x == Approx(center.x + 1).epsilon(1e-5));
  REQUIRE(state.center.y == Approx(center.y).epsilon(1e-5));
  REQUIRE(state.angle == Approx(2.5).epsilon(1e-5));
  REQUIRE(distance(state.position, state.center) == Approx(2).epsilon(1e-5));
  REQUIRE(simulation->energy().kinetic == Approx(0.5 + 0.5 / 6 * 4).epsilon(1e-5));
}

TEST_CASE("Bodies of many corners and capsules of a peer rest as high as they are", "[peers]") {
  const Peer peer = each_peer();
  ShapeDef wheel;
  for (int i = 0; i < 16; ++i) {
    const double angle = (i + 0.5) * 3.14159265358979 / 8;
    wheel.points.push_back({std::cos(angle), std::sin(angle)});
  }
  ShapeDef capsule;
  capsule.points = {{-1, 0}, {1, 0}};
  capsule.radius = 0.25;
  const auto simulation =
      make_peer(peer, scene_of({body_with(wheel, {0, 1}), body_with(capsule, {5, 0.3}), floor_body()}));
  run(*simulation, 3);
  REQUIRE(simulation->body(first).position.y == Approx(std::cos(3.14159265358979 / 16)).margin(0.02));
  REQUIRE(simulation->body(second).position.y == Approx(0.25).margin(0.02));
}

TEST_CASE("A belt of a peer carries what lies on it at its speed", "[peers]") {
  BodyDef belt = floor_body();
  belt.shapes[0].surface_speed = -1.5;  // its upper side goes right
  const auto simulation = make_peer(each_peer(), scene_of({body_with(box_shape(1, 1), {0, 0.5}), belt}));
  run(*simulation, 2);
  REQUIRE(simulation->body(first).velocity.x == Approx(1.5).epsilon(0.01));
}

TEST_CASE("A peer tells once that two bodies have met, and how hard", "[peers]") {
  const auto simulation = make_peer(each_peer(), scene_of({body_with(disc_shape(0.5), {0, 1.5}), floor_body()}));
  std::vector<ContactEvent> events;
  for (int i = 0; i < 90; ++i) {
    simulation->step();
    events.insert(events.end(), simulation->contact_events().begin(), simulation->contact_events().end());
  }
  REQUIRE(events.size() == 1);
  REQUIRE(events[0].a == first);
  REQUIRE(events[0].normal.y == Approx(-1));
  REQUIRE(events[0].speed == Approx(std::sqrt(2 * g)).margin(0.2));
  const double mass = simulation->body(first).mass;
  REQUIRE(events[0].impulse == Approx(mass * std::sqrt(2 * g)).epsilon(0.1));
}

TEST_CASE("A sensor of a peer tells of what it meets and lets it pass", "[peers]") {
  BodyDef gate = floor_body();
  gate.sensor = true;
  const auto simulation = make_peer(each_peer(), scene_of({body_with(disc_shape(0.5), {0, 1.5}), gate}));
  std::size_t entered = 0;
  std::size_t left = 0;
  for (int i = 0; i < 60; ++i) {
    simulation->step();
    entered += simulation->contact_events().size();
    left += simulation->separation_events().size();
  }
  REQUIRE(entered == 1);
  REQUIRE(left == 1);
  REQUIRE(simulation->body(first).velocity.y == Approx(-g).epsilon(1e-4));
}

TEST_CASE("Drag that a peer does not know brakes a fall to the speed at which it carries the weight", "[peers]") {
  Scene scene = scene_of({body_with(box_shape(1, 1), {0, 0}), body_with(box_shape(1, 1), {5, 0})});
  scene.drag = {2, 0, 0};
  scene.bodies[1].drag = DragDef{0, 0.5, 0};
  scene.wind = {1, 0};
  const auto simulation = make_peer(each_peer(), scene);
  run(*simulation, 10);
  REQUIRE(simulation->body(first).velocity.y == Approx(-g / 2).epsilon(1e-4));
  REQUIRE(simulation->body(first).velocity.x == Approx(1).epsilon(1e-4));
  REQUIRE(simulation->body(second).velocity.y == Approx(-std::sqrt(g / 0.5)).epsilon(0.01));
}

TEST_CASE("Bodies of a peer attract each other, and momentum stays", "[peers]") {
  Scene scene = scene_of({body_with(disc_shape(0.1), {0, 0}), body_with(disc_shape(0.1), {2, 0})});
  scene.gravity = {};
  scene.bodies[0].mass = 3;
  scene.bodies[1].mass = 1;
  scene.bodies[1].velocity = {0, 2};  // a circle
  const bool with_attractor = GENERATE(true, false);
  if (with_attractor) {
    scene.attractors = {{first, {}, 6, AttractionLaw::inverse_square}};
  } else {
    scene.gravitational_constant = 2;  // 2 * 3 kg pull as 6 does; both move
  }
  const auto simulation = make_peer(each_peer(), scene);
  const double before = simulation->energy().total();
  run(*simulation, 2);
  const Vec2d momentum = 3 * simulation->body(first).velocity + simulation->body(second).velocity;
  REQUIRE(length(momentum - Vec2d{0, 2}) < 1e-5);
  REQUIRE(before == Approx(-1));
  REQUIRE(simulation->energy().total() == Approx(before).epsilon(0.1));
  REQUIRE(distance(simulation->body(first).position, simulation->body(second).position) == Approx(2).epsilon(0.05));
}

TEST_CASE("A force field acts on the bodies of a peer", "[peers]") {
  Scene scene = scene_of({body_with(box_shape(1, 1), {0, 0})});
  scene.gravity = {};
  scene.fields.emplace_back([](Vec2d, Vec2d, double time) { return Vec2d{time < 0.5 ? 4.0 : 0.0, 0}; });
  const auto simulation = make_peer(each_peer(), scene);
  run(*simulation, 1);
  REQUIRE(simulation->body(first).velocity.x == Approx(2).epsilon(1e-5));
}

TEST_CASE("What a peer does not know is refused with a sentence", "[peers]") {
  const Peer peer = each_peer();
  const std::string name = name_of(peer);
  Scene scene = scene_of({body_with(disc_shape(0.5), {0, 0})});
  REQUIRE_FALSE(problem_for_peer(peer, scene));
  SECTION("rolling resistance") {
    scene.bodies[0].name = "ball";
    scene.bodies[0].shapes[0].rolling_resistance = 0.1;
    REQUIRE(*problem_for_peer(peer, scene) ==
            name + " cannot step body \"ball\": it has rolling resistance, which " + name + " does not know");
    REQUIRE_THROWS_AS(make_peer(peer, scene), UnknownToPeer);
  }
  SECTION("two coefficients of friction") {
    scene.bodies[0].shapes[0].friction = {0.6, 0.4};
    REQUIRE(problem_for_peer(peer, scene)->find("body 1") != std::string::npos);
  }
  SECTION("water and rockets") {
    scene.water = WaterDef{};
    REQUIRE(*problem_for_peer(peer, scene) == "The scene has water, which " + name + " does not know");
    scene.water.reset();
    scene.rockets.emplace_back();
    REQUIRE(problem_for_peer(peer, scene));
  }
  SECTION("joints") {
    scene.joints = {joint_of(JointKind::drag_to, {}, {})};
    REQUIRE(*problem_for_peer(peer, scene) ==
            name + " cannot step joint 0 (drag_to): it is a drag_to, which " + name + " does not know");
  }
  SECTION("effects left out") {
    scene.effects = EffectSet{Effect::contacts};
    REQUIRE(problem_for_peer(peer, scene)->find("leaves out gravity") != std::string::npos);
    scene.effects = EffectSet{Effect::gravity, Effect::sensors};
    REQUIRE_FALSE(problem_for_peer(peer, scene));
  }
}

TEST_CASE("What only one peer lacks is refused by that one", "[peers]") {
  Scene scene = scene_of({body_with(disc_shape(0.5), {0, 0})});
  const auto refused = [&scene](Peer peer) { return problem_for_peer(peer, scene).has_value(); };
  SECTION("Chipmunk: bullets") { scene.bodies[0].bullet = true; }
  SECTION("Chipmunk: categories beyond 32") { scene.bodies[0].filter.category = std::uint64_t{1} << 40U; }
  SECTION("Chipmunk: pulleys") { scene.joints = {joint_of(JointKind::pulley, {}, {})}; }
  SECTION("Chipmunk: motors that push") {
    scene.joints = {joint_of(JointKind::prismatic, {}, {})};
    scene.joints[0].motor = MotorDef{1, 1};
  }
  REQUIRE(refused(Peer::chipmunk) != refused(Peer::box2d));
}

TEST_CASE("Box2D refuses what would stop the program", "[peers]") {
  Scene scene = scene_of({body_with(box_shape(0.002, 1), {0, 0})});
  REQUIRE(problem_for_peer(Peer::box2d, scene)->find("2.5 mm") != std::string::npos);
  REQUIRE_FALSE(problem_for_peer(Peer::chipmunk, scene));
  scene.bodies[0].shapes[0] = box_shape(0.003, 0.003);
  REQUIRE_FALSE(problem_for_peer(Peer::box2d, scene));
  run(*make_peer(Peer::box2d, scene), 0.1);
  scene.bodies[0].shapes[0].points = {{-1, 0}, {1, 0}};
  scene.bodies[0].mass = 1;
  REQUIRE(problem_for_peer(Peer::box2d, scene)->find("segment") != std::string::npos);
}

}  // namespace
}  // namespace proofreel
