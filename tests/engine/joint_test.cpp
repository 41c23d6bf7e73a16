#include <catch2/catch.hpp>
#include <cmath>

#include "tests/engine/scenes.h"

using namespace proofreel;
using namespace proofreel::test;

namespace {

constexpr double pi = 3.14159265358979323846;
constexpr double g = 9.81;

/// A point pendulum of 1 m, released at rest at `angle` from straight down.
Scene point_pendulum(double angle) {
  Scene scene;
  scene.bodies = {body_with(disc_shape(0.08), {std::sin(angle), -std::cos(angle)})};
  scene.joints = {joint_between(JointKind::distance, BodyId::world, {0, 0}, BodyId{1}, {0, 0}, 1)};
  return scene;
}

double angle_of(const Simulation& simulation) {
  const Vec2d p = simulation.body(BodyId{1}).position;
  return std::atan2(p.x, -p.y);
}

double pendulum_error(int substeps) {
  Scene scene = point_pendulum(pi / 3);
  scene.method.substeps = substeps;
  auto simulation = simulate(scene);
  run(*simulation, 10);
  return std::abs(angle_of(*simulation) - -0.651863046741975928);  // Jacobi's sn by the arithmetic-geometric mean
}

}  // namespace

TEST_CASE("The pendulum follows its closed form, and twice the substeps quarter the error", "[joint]") {
  const double coarse = pendulum_error(2);
  CHECK(coarse < 2e-4);
  if (!is_double) return;
  CHECK(coarse / pendulum_error(4) == Approx(4).epsilon(0.02));
}

TEST_CASE("The pendulum's rod keeps its length to the last digits", "[joint]") {
  auto simulation = simulate(point_pendulum(pi / 3));
  double widest = 0;
  for (int i = 0; i < 2400; ++i) {
    simulation->step();
    widest = std::max(widest, simulation->joint(JointId{0}).gap);
  }
  CHECK(widest < pick(1e-13, 1e-5));
}

TEST_CASE("The pendulum's energy does not drift", "[joint]") {
  auto simulation = simulate(point_pendulum(pi / 3));
  const double start = simulation->energy().total();
  const double scale = simulation->body(BodyId{1}).mass * g;
  double first = 0;
  double last = 0;
  for (int i = 0; i < 100 * 240; ++i) {
    simulation->step();
    const double error = std::abs(simulation->energy().total() - start) / scale;
    (i < 12000 ? first : last) = std::max(i < 12000 ? first : last, error);
  }
  CHECK(first < pick(2e-4, 1e-3));
  if (is_double) CHECK(last == Approx(first).epsilon(0.01));
}

TEST_CASE("A uniform rod on a hinge swings with its own period and pulls with 2.5 m g at the bottom", "[joint]") {
  // Released from the horizontal: T = 1.93333485437 s, omega at the bottom sqrt(3 g / L).
  Scene scene;
  scene.rate = 960;
  scene.bodies = {body_with(box_shape(1, 0.001), {0.5, 0})};
  scene.joints = {joint_between(JointKind::revolute, BodyId::world, {0, 0}, BodyId{1}, {-0.5, 0})};
  auto simulation = simulate(scene);
  const double mass = simulation->body(BodyId{1}).mass;
  double strongest = 0;
  double fastest = 0;
  for (int i = 0; i < 960 / 2; ++i) {
    simulation->step();
    strongest = std::max(strongest, length(simulation->joint(JointId{0}).reaction));
    fastest = std::max(fastest, std::abs(simulation->body(BodyId{1}).spin));
  }
  CHECK(strongest / (mass * g) == Approx(2.5).epsilon(pick(2e-4, 2e-3)));
  CHECK(fastest == Approx(std::sqrt(3 * g)).epsilon(2e-4));
  run(*simulation, 1.93333485437 - 0.5, 960);
  CHECK(simulation->body(BodyId{1}).angle == Approx(0).margin(2e-3));
}

TEST_CASE("A chain of forty links holds a ball of hundreds of times their mass without opening", "[joint]") {
  Scene scene;
  ShapeDef link;
  link.points = {{-0.4, 0}, {0.4, 0}};
  link.radius = 0.125;
  for (int i = 1; i <= 40; ++i) {
    scene.bodies.push_back(body_with(link, {i - 0.5, 0}));
    scene.bodies.back().filter.group = -1;
    const Vec2d last_end = i == 1 ? Vec2d{0, 0} : Vec2d{0.5, 0};
    scene.joints.push_back(joint_between(JointKind::revolute, BodyId(i - 1), last_end, BodyId(i), {-0.5, 0}));
  }
  scene.bodies.push_back(body_with(disc_shape(8), {48, 0}));
  scene.bodies.back().filter.group = -1;
  scene.joints.push_back(joint_between(JointKind::revolute, BodyId{40}, {0.5, 0}, BodyId{41}, {-8, 0}));
  auto simulation = simulate(scene);
  const double start = simulation->energy().total();
  double widest = 0;
  for (int i = 0; i < 5 * 240; ++i) {
    simulation->step();
    for (std::uint32_t j = 0; j < 41; ++j) widest = std::max(widest, simulation->joint(JointId{j}).gap);
  }
  CHECK(widest < pick(1e-12, 1e-4));
  const double weight = simulation->body(BodyId{41}).mass * g;
  CHECK(std::abs(simulation->energy().total() - start) < pick(1e-4, 1e-2) * weight * 48);
}

TEST_CASE("A frame with more bars than it needs stays rigid", "[joint]") {
  // Four corners, four sides and both diagonals: one bar is redundant.
  Scene scene;
  const Vec2d corners[] = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  for (const Vec2d c : corners) scene.bodies.push_back(body_with(disc_shape(0.05), c + Vec2d{0, 5}));
  for (std::uint32_t i = 1; i <= 4; ++i) {
    for (std::uint32_t j = i + 1; j <= 4; ++j) {
      const double l = distance(corners[i - 1], corners[j - 1]);
      scene.joints.push_back(joint_between(JointKind::distance, BodyId{i}, {0, 0}, BodyId{j}, {0, 0}, l));
    }
  }
  scene.bodies[0].velocity = {3, 1};
  scene.bodies[2].velocity = {-2, 0};
  auto simulation = simulate(scene);
  double widest = 0;
  for (int i = 0; i < 480; ++i) {
    simulation->step();
    for (std::uint32_t j = 0; j < 6; ++j) widest = std::max(widest, simulation->joint(JointId{j}).gap);
  }
  CHECK(widest < pick(1e-9, 1e-3));
}

TEST_CASE("A chain pulled straight between two walls cannot sag, and stays finite", "[joint]") {
  // Twenty planks as long as the gap they span: no finite force could carry their weight, so the joints contradict each
  // other. The engine must neither throw them about nor let the hinges open visibly.
  Scene scene;
  for (int i = 1; i <= 20; ++i) {
    scene.bodies.push_back(body_with(box_shape(0.48, 0.12), {0.5 * i - 0.25, 0}));
    scene.bodies.back().filter.group = -1;
    const Vec2d left = i == 1 ? Vec2d{0, 0} : Vec2d{0.25, 0};
    scene.joints.push_back(joint_between(JointKind::revolute, BodyId(i - 1), left, BodyId(i), {-0.25, 0}));
  }
  scene.joints.push_back(joint_between(JointKind::revolute, BodyId{20}, {0.25, 0}, BodyId::world, {10, 0}));
  auto simulation = simulate(scene);
  double widest = 0;
  double fastest = 0;
  for (int i = 0; i < 5 * 240; ++i) {
    simulation->step();
    for (std::uint32_t j = 0; j < 21; ++j) widest = std::max(widest, simulation->joint(JointId{j}).gap);
    for (int k = 1; k <= 20; ++k) fastest = std::max(fastest, length(simulation->body(BodyId(k)).velocity));
  }
  CHECK(widest < 1e-3);
  CHECK(fastest < 3);
}

TEST_CASE("A torn joint closes gently instead of within one step", "[joint]") {
  Scene scene;
  scene.gravity = {0, 0};
  scene.bodies = {body_with(box_shape(1, 1), {3, 0})};
  scene.joints = {joint_between(JointKind::revolute, BodyId::world, {0, 0}, BodyId{1}, {-0.5, 0})};
  auto simulation = simulate(scene);
  double fastest = 0;
  for (int i = 0; i < 3 * 240; ++i) {
    simulation->step();
    fastest = std::max(fastest, length(simulation->body(BodyId{1}).velocity));
  }
  CHECK(simulation->joint(JointId{0}).gap < pick(1e-9, 1e-4));
  CHECK(fastest < 10);
}

TEST_CASE("A mass on a spring swings with sqrt(k / m), to second order", "[joint]") {
  const auto error = [](int substeps) {
    Scene scene;
    scene.gravity = {0, 0};
    scene.method.substeps = substeps;
    scene.bodies = {body_with(disc_shape(0.1), {3, 0})};
    scene.bodies[0].mass = 1;
    JointDef spring = joint_between(JointKind::spring, BodyId::world, {0, 0}, BodyId{1}, {0, 0}, 2);
    spring.stiffness = 100;
    scene.joints = {spring};
    auto simulation = simulate(scene);
    run(*simulation, 10);
    return std::abs(simulation->body(BodyId{1}).position.x - (2 + 0.862318872287683934));  // 2 + cos(100)
  };
  CHECK(error(4) < pick(4e-4, 2e-3));
  if (is_double) CHECK(error(4) / error(8) == Approx(4).epsilon(0.02));
}

TEST_CASE("A damped spring loses energy at the rate the damper takes it", "[joint]") {
  Scene scene;
  scene.gravity = {0, 0};
  scene.bodies = {body_with(disc_shape(0.1), {2, 0})};
  scene.bodies[0].mass = 1;
  JointDef spring = joint_between(JointKind::spring, BodyId::world, {0, 0}, BodyId{1}, {0, 0}, 1);
  spring.stiffness = 100;
  spring.damping = 1;
  scene.joints = {spring};
  auto simulation = simulate(scene);
  run(*simulation, 4);
  // x = 1 + exp(-t / 2) (cos w t + sin(w t) / (2 w)), w^2 = 100 - 1/4
  const double w = std::sqrt(99.75);
  const double x = 1 + std::exp(-2.0) * (std::cos(4 * w) + std::sin(4 * w) / (2 * w));
  CHECK(simulation->body(BodyId{1}).position.x == Approx(x).margin(5e-4));
}

TEST_CASE("What hangs at rest on a damped spring hangs where its weight says", "[joint]") {
  Scene scene;
  scene.bodies = {body_with(disc_shape(0.1), {0, -1})};
  scene.bodies[0].mass = 2;
  JointDef spring = joint_between(JointKind::spring, BodyId::world, {0, 0}, BodyId{1}, {0, 0}, 1);
  spring.stiffness = 200;
  spring.damping = 40;
  scene.joints = {spring};
  auto simulation = simulate(scene);
  run(*simulation, 5);
  CHECK(simulation->body(BodyId{1}).position.y == Approx(-1 - 2 * g / 200).epsilon(pick(1e-9, 1e-5)));
  CHECK(simulation->joint(JointId{0}).reaction.y == Approx(2 * g).epsilon(pick(1e-9, 1e-4)));
}

TEST_CASE("A removed joint lets go", "[joint]") {
  auto simulation = simulate(point_pendulum(pi / 2));
  simulation->apply(RemoveJoint{JointId{0}});
  CHECK_FALSE(simulation->exists(JointId{0}));
  run(*simulation, 1);
  CHECK(simulation->body(BodyId{1}).position.y == Approx(-g / 2).epsilon(1e-4));
}

TEST_CASE("Bodies that share a hinge may overlap there", "[joint]") {
  Scene scene;
  scene.gravity = {0, 0};
  scene.bodies = {body_with(box_shape(1, 0.2), {0, 0}), body_with(box_shape(1, 0.2), {0.9, 0})};
  scene.joints = {joint_between(JointKind::revolute, BodyId{1}, {0.45, 0}, BodyId{2}, {-0.45, 0})};
  auto simulation = simulate(scene);
  run(*simulation, 1);
  CHECK(simulation->contacts().empty());
  CHECK(length(simulation->body(BodyId{1}).velocity) == 0);
}
