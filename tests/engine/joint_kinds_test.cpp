#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>

#include "tests/engine/scenes.h"

using namespace proofreel;
using namespace proofreel::test;

// Laws of the kinds of joints that hold: each keeps its equation, and moves as its closed form says.

namespace {

constexpr double pi = 3.14159265358979323846;
constexpr double g = 9.81;

JointDef joint_at(JointKind kind, BodyId a, Vec2d anchor_a, BodyId b, Vec2d anchor_b) {
  return joint_between(kind, a, anchor_a, b, anchor_b);
}

/// Steps, and gives the widest gap of all joints at any tick.
double widest_gap(Simulation& simulation, double seconds, std::uint32_t joints) {
  double widest = 0;
  for (int i = 0; i < static_cast<int>(seconds * 240 + 0.5); ++i) {
    simulation.step();
    for (std::uint32_t j = 0; j < joints; ++j) widest = std::max(widest, simulation.joint(JointId{j}).gap);
  }
  return widest;
}

double energy_error(const Simulation& simulation, double start) {
  const Energy now = simulation.energy();
  return std::abs(now.total() - now.booked_work - start);
}

/// A unit disc of a given mass at a place.
BodyDef disc(Vec2d at, double mass, double radius = 0.1) {
  BodyDef body = body_with(disc_shape(radius), at);
  body.mass = mass;
  body.filter.group = -1;
  return body;
}

Scene slope(double theta) {
  Scene scene;
  scene.bodies = {body_with(box_shape(0.4, 0.2), {0, 0})};
  scene.bodies[0].angle = theta;
  scene.joints = {joint_at(JointKind::prismatic, BodyId::world, {0, 0}, BodyId{1}, {0, 0})};
  scene.joints[0].axis = {std::cos(theta), std::sin(theta)};
  return scene;
}

Scene hanging_weights(double mass_a, double mass_b, double ratio) {
  Scene scene;
  scene.bodies = {disc({-1, 0}, mass_a), disc({1, 0}, mass_b)};
  JointDef pulley = joint_at(JointKind::pulley, BodyId{1}, {0, 0}, BodyId{2}, {0, 0});
  pulley.pin_a = {-1, 3};
  pulley.pin_b = {1, 3};
  pulley.ratio = ratio;
  scene.joints = {pulley};
  return scene;
}

/// Two wheels on fixed pins, geared by `ratio`.
Scene two_wheels(double ratio) {
  Scene scene;
  scene.bodies = {disc({-1, 0}, 1, 0.5), disc({1, 0}, 3, 0.25)};
  scene.joints = {joint_at(JointKind::revolute, BodyId::world, {-1, 0}, BodyId{1}, {0, 0}),
                  joint_at(JointKind::revolute, BodyId::world, {1, 0}, BodyId{2}, {0, 0}),
                  joint_at(JointKind::gear, BodyId{1}, {0, 0}, BodyId{2}, {0, 0})};
  scene.joints[2].first = JointId{0};
  scene.joints[2].second = JointId{1};
  scene.joints[2].ratio = ratio;
  return scene;
}

}  // namespace

TEST_CASE("A slider on an inclined rail runs down at g sin(theta), on the rail and without turning", "[joint]") {
  const double theta = -0.5;
  Scene scene = slope(theta);
  scene.bodies[0].inertia = 0.01;
  auto simulation = simulate(scene);
  CHECK(widest_gap(*simulation, 2, 1) < pick(1e-12, 1e-4));
  const double way = dot(simulation->body(BodyId{1}).position, {std::cos(theta), std::sin(theta)});
  CHECK(way == Approx(0.5 * g * std::sin(-theta) * 4).epsilon(pick(1e-9, 1e-4)));
  CHECK(simulation->body(BodyId{1}).angle == Approx(theta).margin(pick(1e-12, 1e-5)));
}

TEST_CASE("A rail that is thrown about by the body it is fixed in keeps energy and gap", "[joint]") {
  Scene scene;
  scene.gravity = {0, 0};
  scene.bodies = {body_with(box_shape(2, 0.1), {0, 0}), body_with(disc_shape(0.2), {0.3, 0})};
  scene.bodies[0].spin = 3;
  scene.bodies[1].spin = 3;
  scene.bodies[1].velocity = {0, 0.9};
  scene.joints = {joint_at(JointKind::prismatic, BodyId{1}, {0.3, 0}, BodyId{2}, {0, 0})};
  auto simulation = simulate(scene);
  const double start = simulation->energy().total();
  const double angular = [&] {
    double l = 0;
    for (const BodyId id : {BodyId{1}, BodyId{2}}) {
      const BodyState s = simulation->body(id);
      l += s.inertia * s.spin + s.mass * cross(s.center, s.velocity);
    }
    return l;
  }();
  CHECK(widest_gap(*simulation, 10, 1) < pick(1e-9, 1e-3));
  CHECK(energy_error(*simulation, start) < pick(1e-4, 1e-2) * start);
  double now = 0;
  for (const BodyId id : {BodyId{1}, BodyId{2}}) {
    const BodyState s = simulation->body(id);
    now += s.inertia * s.spin + s.mass * cross(s.center, s.velocity);
  }
  CHECK(now == Approx(angular).epsilon(pick(1e-10, 1e-3)));
}

TEST_CASE("Two welded boxes move as one body of the same mass", "[joint]") {
  Scene welded;
  welded.bodies = {body_with(box_shape(1, 0.4), {-0.5, 0}), body_with(box_shape(0.6, 0.4), {0.3, 0})};
  welded.joints = {joint_at(JointKind::weld, BodyId{1}, {0.5, 0}, BodyId{2}, {-0.3, 0})};
  Scene whole;
  whole.bodies = {body_with(box_shape(1.6, 0.4), {-0.2, 0})};
  for (Scene* scene : {&welded, &whole}) {
    scene->method.substeps = 8;
    for (BodyDef& body : scene->bodies) {
      body.spin = 2;
      body.velocity = Vec2d{1, 4} + cross(2.0, body.position - Vec2d{-0.2, 0});
    }
  }
  auto pair = simulate(welded);
  auto one = simulate(whole);
  const double start = pair->energy().total();
  CHECK(widest_gap(*pair, 10, 1) < pick(1e-9, 1e-3));
  run(*one, 10);
  const BodyState a = pair->body(BodyId{1});
  const BodyState b = pair->body(BodyId{2});
  const Vec2d center = (1 / (a.mass + b.mass)) * (a.mass * a.center + b.mass * b.center);
  const BodyState together = one->body(BodyId{1});
  CHECK(a.mass + b.mass == Approx(together.mass));
  CHECK(distance(center, together.center) < pick(1e-6, 0.2));
  CHECK(a.angle == Approx(together.angle).epsilon(pick(1e-3, 1e-2)));
  CHECK(energy_error(*pair, start) < pick(1e-8, 1e-3) * pair->energy().kinetic);
}

TEST_CASE("Atwood's machine falls at g (m1 - m2) / (m1 + m2), and with a block and tackle at its own rate", "[joint]") {
  const auto [mass_a, mass_b, ratio] = GENERATE(table<double, double, double>({{3, 2, 1}, {2, 1, 1}, {1, 3, 2}}));
  auto simulation = simulate(hanging_weights(mass_a, mass_b, ratio));
  const double start = simulation->energy().total();
  CHECK(widest_gap(*simulation, 0.5, 1) < pick(1e-12, 1e-4));
  // b rises by 1 / ratio of what a falls: m_a a = m_a g - T, m_b a / ratio = ratio T - m_b g
  const double a = g * (mass_a - mass_b / ratio) / (mass_a + mass_b / (ratio * ratio));
  const double tension = mass_a * (g - a);
  CHECK(simulation->body(BodyId{1}).position.y == Approx(-0.5 * a * 0.25).epsilon(pick(1e-6, 1e-3)));
  CHECK(simulation->body(BodyId{2}).velocity.y == Approx(a * 0.5 / ratio).epsilon(pick(1e-6, 1e-3)));
  CHECK(simulation->joint(JointId{0}).reaction.y == Approx(ratio * tension).epsilon(pick(1e-6, 1e-2)));
  CHECK(energy_error(*simulation, start) < pick(1e-9, 1e-3));
}

TEST_CASE("Geared wheels keep angle1 + ratio * angle2, and the energy", "[joint]") {
  Scene scene = two_wheels(2.5);
  scene.bodies[0].spin = 10;
  scene.bodies[1].spin = -4;
  auto simulation = simulate(scene);
  const double start = simulation->energy().total();
  double worst = 0;
  for (int i = 0; i < 2400; ++i) {
    simulation->step();
    const double sum = simulation->body(BodyId{1}).angle + 2.5 * simulation->body(BodyId{2}).angle;
    worst = std::max(worst, std::abs(sum));
  }
  CHECK(worst < pick(1e-12, 1e-3));
  CHECK(simulation->body(BodyId{1}).angle == Approx(100).epsilon(pick(1e-9, 1e-3)));
  CHECK(energy_error(*simulation, start) < pick(1e-9, 1e-3) * start);
}

TEST_CASE("A weight on a geared drum falls with the inertia of both wheels", "[joint]") {
  // A rack of mass m on a vertical rail, a pinion of radius r: a = g m / (m + I / r^2).
  Scene scene;
  scene.bodies = {disc({0, 0}, 2), disc({1, 0}, 3, 0.5)};
  scene.joints = {joint_at(JointKind::prismatic, BodyId::world, {0, 0}, BodyId{1}, {0, 0}),
                  joint_at(JointKind::revolute, BodyId::world, {1, 0}, BodyId{2}, {0, 0}),
                  joint_at(JointKind::gear, BodyId{1}, {0, 0}, BodyId{2}, {0, 0})};
  scene.joints[0].axis = {0, 1};
  scene.joints[2].first = JointId{0};
  scene.joints[2].second = JointId{1};
  scene.joints[2].ratio = 0.5;
  auto simulation = simulate(scene);
  run(*simulation, 1);
  const double inertia = simulation->body(BodyId{2}).inertia;
  const double a = g * 2 / (2 + inertia / 0.25);
  CHECK(simulation->body(BodyId{1}).velocity.y == Approx(-a).epsilon(pick(1e-6, 1e-3)));
  CHECK(simulation->body(BodyId{2}).spin == Approx(a / 0.5).epsilon(pick(1e-6, 1e-3)));
}

TEST_CASE("A gear goes with either of its joints", "[joint]") {
  auto simulation = simulate(two_wheels(1));
  simulation->apply(RemoveJoint{JointId{1}});
  CHECK_FALSE(simulation->exists(JointId{2}));
  CHECK(simulation->exists(JointId{0}));
  auto other = simulate(two_wheels(1));
  other->apply(RemoveBody{BodyId{1}});
  CHECK_FALSE(other->exists(JointId{2}));
  run(*other, 0.1);
  CHECK_FALSE(other->failure());
}

TEST_CASE("A slack rope is not there, a taut one is a rod", "[joint]") {
  Scene slack;
  slack.bodies = {disc({0.5, 0}, 1)};
  JointDef rope = joint_at(JointKind::rope, BodyId::world, {0, 0}, BodyId{1}, {0, 0});
  rope.length = 1;
  slack.joints = {rope};
  Scene free = slack;
  free.joints.clear();
  auto held = simulate(slack);
  auto falling = simulate(free);
  run(*held, 0.4);
  run(*falling, 0.4);
  CHECK(held->state_hash() == falling->state_hash());

  Scene taut = slack;
  taut.bodies[0].position = {std::sin(1.0), -std::cos(1.0)};
  Scene rod = taut;
  rod.joints[0].kind = JointKind::distance;
  auto on_rope = simulate(taut);
  auto on_rod = simulate(rod);
  const double start = on_rope->energy().total();
  CHECK(widest_gap(*on_rope, 10, 1) < pick(1e-9, 1e-4));
  run(*on_rod, 10);
  CHECK(distance(on_rope->body(BodyId{1}).position, on_rod->body(BodyId{1}).position) < pick(1e-9, 1e-2));
  CHECK(energy_error(*on_rope, start) < pick(1e-3, 1e-2));
}

TEST_CASE("A rope that is pulled taut takes the speed along it and gives none back", "[joint]") {
  Scene scene;
  scene.bodies = {disc({0, 0}, 1)};
  JointDef rope = joint_at(JointKind::rope, BodyId::world, {0, 0}, BodyId{1}, {0, 0});
  rope.length = 1;
  scene.joints = {rope};
  scene.bodies[0].velocity = {0.5, 0};
  auto simulation = simulate(scene);
  double before = simulation->energy().total();
  double rises = 0;
  double longest = 0;
  for (int i = 0; i < 2400; ++i) {
    simulation->step();
    const double now = simulation->energy().total();
    rises = std::max(rises, now - before);
    before = now;
    longest = std::max(longest, length(simulation->body(BodyId{1}).position));
  }
  CHECK(longest < 1 + pick(1e-9, 1e-5));
  CHECK(rises < 1e-3);
}

TEST_CASE("A wheel's suspension sags by m g / k, and swings with sqrt(k / m)", "[joint]") {
  const double k = 400;
  Scene scene;
  scene.bodies = {body_with(box_shape(1, 0.4), {0, 1})};
  scene.bodies[0].mass = 4;
  scene.bodies[0].fixed_rotation = true;
  // The wheel is the world here: the chassis rides on it.
  JointDef wheel = joint_at(JointKind::wheel, BodyId{1}, {0, -1}, BodyId::world, {0, 0});
  wheel.axis = {0, 1};
  wheel.stiffness = k;
  scene.joints = {wheel};
  auto swinging = simulate(scene);
  const double period = 2 * pi * std::sqrt(4 / k);
  double lowest = 1;
  for (int i = 0; i < 240; ++i) {
    swinging->step();
    lowest = std::min(lowest, swinging->body(BodyId{1}).position.y);
  }
  CHECK(1 - lowest == Approx(2 * 4 * g / k).epsilon(1e-3));
  const double phase = 2 * pi * 1.0 / period;
  CHECK(swinging->body(BodyId{1}).position.y == Approx(1 - 4 * g / k * (1 - std::cos(phase))).margin(2e-3));

  scene.joints[0].damping = 2 * std::sqrt(k * 4);
  auto resting = simulate(scene);
  run(*resting, 4);
  CHECK(1 - resting->body(BodyId{1}).position.y == Approx(4 * g / k).epsilon(pick(1e-9, 1e-4)));
  CHECK(std::abs(resting->body(BodyId{1}).velocity.y) < pick(1e-12, 1e-4));
}

TEST_CASE("A four-bar linkage closes, and its crank comes round", "[joint]") {
  // Ground 2, crank 0.5, coupler 1.8, rocker 1.2: shortest + longest < the other two (Grashof), so the crank turns
  // round.
  Scene scene;
  scene.gravity = {0, 0};
  const Vec2d crank_end{0, 0.5};
  const double d = distance(crank_end, {2, 0});
  const double along = (d * d + 1.8 * 1.8 - 1.2 * 1.2) / (2 * d);
  const Vec2d to_ground = normalized(Vec2d{2, 0} - crank_end);
  const Vec2d top = crank_end + along * to_ground + std::sqrt(1.8 * 1.8 - along * along) * perp(to_ground);
  const Vec2d ends[] = {{0, 0}, crank_end, top, {2, 0}};
  for (int i = 0; i < 3; ++i) {
    const Vec2d way = ends[i + 1] - ends[i];
    scene.bodies.push_back(body_with(box_shape(length(way), 0.05), 0.5 * (ends[i] + ends[i + 1])));
    scene.bodies.back().angle = std::atan2(way.y, way.x);
    scene.bodies.back().filter.group = -1;
  }
  for (std::uint32_t i = 0; i <= 3; ++i) {
    const auto anchor = [&](std::uint32_t body, bool at_end) -> Vec2d {
      if (body == 0 || body == 4) return ends[i];
      return {(at_end ? 0.5 : -0.5) * distance(ends[body], ends[body - 1]), 0};
    };
    scene.joints.push_back(joint_at(JointKind::revolute, BodyId{i}, anchor(i, true), BodyId{(i + 1) % 4},
                                    i == 3 ? ends[3] : anchor(i + 1, false)));
  }
  scene.joints[0].motor = MotorDef{4, 50};
  auto simulation = simulate(scene);
  const double start = simulation->energy().total();
  CHECK(widest_gap(*simulation, 10, 4) < pick(1e-9, 1e-3));
  CHECK(simulation->body(BodyId{1}).spin == Approx(4).epsilon(pick(1e-4, 1e-2)));
  CHECK(simulation->body(BodyId{1}).angle > 38);
  CHECK(energy_error(*simulation, start) < pick(2e-2, 5e-2) * simulation->energy().total());
}

TEST_CASE("What one group of joints cannot do disturbs no other", "[joint]") {
  Scene calm;
  calm.bodies = {disc({std::sin(1.0), -std::cos(1.0)}, 1)};
  calm.joints = {joint_between(JointKind::distance, BodyId::world, {0, 0}, BodyId{1}, {0, 0}, 1)};
  Scene torn = calm;
  torn.bodies.push_back(disc({10, 0}, 1));
  torn.joints.push_back(joint_at(JointKind::revolute, BodyId::world, {9, 0}, BodyId{2}, {-0.5, 0}));
  torn.joints.push_back(joint_at(JointKind::revolute, BodyId::world, {12, 0}, BodyId{2}, {0.5, 0}));
  auto alone = simulate(calm);
  auto beside = simulate(torn);
  for (int i = 0; i < 240; ++i) {
    alone->step();
    beside->step();
    REQUIRE(alone->body(BodyId{1}).position == beside->body(BodyId{1}).position);
  }
}

TEST_CASE("A chain that a kinematic body pulls farther than it reaches opens, and is not hurled about", "[joint]") {
  Scene scene;
  const int links = 6;
  for (int i = 1; i <= links; ++i) {
    scene.bodies.push_back(body_with(box_shape(0.48, 0.12), {0.5 * i - 0.25, 0}));
    scene.bodies.back().filter.group = -1;
    const Vec2d left = i == 1 ? Vec2d{0, 0} : Vec2d{0.25, 0};
    scene.joints.push_back(joint_at(JointKind::revolute, BodyId(i - 1), left, BodyId(i), {-0.25, 0}));
  }
  BodyDef mover = body_with(box_shape(0.2, 0.2), {0.5 * links, 0}, BodyType::kinematic);
  mover.velocity = {0.2, 0};
  mover.filter.group = -1;
  scene.bodies.push_back(mover);
  scene.joints.push_back(joint_at(JointKind::revolute, BodyId(links), {0.25, 0}, BodyId(links + 1), {0, 0}));
  auto simulation = simulate(scene);
  double fastest = 0;
  for (int i = 0; i < 3 * 240; ++i) {
    simulation->step();
    for (int k = 1; k <= links; ++k) fastest = std::max(fastest, length(simulation->body(BodyId(k)).velocity));
  }
  CHECK(fastest < 1.5);
  CHECK(simulation->joint(JointId{0}).gap < 0.1);
}

TEST_CASE("Three boxes welded in a ring turn as one body, and no weld pulls against another", "[joint]") {
  Scene scene;
  scene.gravity = {0, 0};
  for (int i = 0; i < 3; ++i) {
    BodyDef box = body_with(box_shape(1, 1), {static_cast<double>(i), 0});
    box.spin = 1;
    box.velocity = {0, i - 1.0};
    scene.bodies.push_back(box);
  }
  const auto weld = [&](unsigned a, unsigned b, Vec2d from_a, Vec2d from_b) {
    JointDef& joint = scene.joints.emplace_back();
    joint.kind = JointKind::weld;
    joint.a = static_cast<BodyId>(a);
    joint.b = static_cast<BodyId>(b);
    joint.anchor_a = from_a;
    joint.anchor_b = from_b;
  };
  weld(1, 2, {0.5, 0}, {-0.5, 0});
  weld(2, 3, {0.5, 0}, {-0.5, 0});
  weld(3, 1, {-1, 0}, {1, 0});
  const auto simulation = simulate(scene);
  const double energy = simulation->energy().total();
  double strongest = 0;
  for (int i = 0; i < 5 * 240; ++i) {
    simulation->step();
    for (unsigned j = 0; j < 3; ++j) strongest = std::max(strongest, length(simulation->joint(JointId{j}).reaction));
  }
  CHECK(strongest < pick(2, 30));  // 1 N holds an outer box on its circle
  CHECK(simulation->energy().total() == Approx(energy).margin(pick(1e-9, 1e-3)));
}
