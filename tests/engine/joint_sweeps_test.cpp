// The iterative joint solver, as taught, beside the direct one.

#include <catch2/catch.hpp>
#include <cmath>

#include "engine/elementary.h"
#include "tests/engine/scenes.h"

using namespace proofreel;
using namespace proofreel::test;

namespace {

/// A chain that hangs level from the world, with a weight at its end.
Scene chain(int links, double weight, JointMethod method, std::optional<int> sweeps = {}) {
  Scene scene;
  scene.method.joint_solver = method;
  scene.method.iterations = sweeps;
  for (int i = 0; i < links; ++i) {
    scene.bodies.push_back(body_with(box_shape(1, 0.2), {i + 0.5, 0}));
    const auto id = [](int n) { return static_cast<BodyId>(n); };
    scene.joints.push_back(joint_between(JointKind::revolute, id(i), {i == 0 ? 0.0 : 0.5, 0}, id(i + 1), {-0.5, 0}));
  }
  scene.bodies.back().mass = weight;
  for (BodyDef& body : scene.bodies) body.filter.group = -1;
  return scene;
}

double widest_gap(const Scene& scene, double seconds) {
  const auto simulation = simulate(scene);
  double widest = 0;
  for (int i = 0; i < static_cast<int>(seconds * 240); ++i) {
    simulation->step();
    for (std::uint32_t j = 0; j < scene.joints.size(); ++j)
      widest = std::max(widest, simulation->joint(JointId(j)).gap);
  }
  return widest;
}

}  // namespace

TEST_CASE("A pendulum on an iterated hinge swings with the period of one on a rigid hinge", "[joint sweeps]") {
  const auto angle = [](JointMethod method) {
    const auto simulation = simulate(chain(1, 1, method));
    run(*simulation, 2);
    return simulation->body(BodyId(1)).angle;
  };
  CHECK(angle(JointMethod::iterative) == Approx(angle(JointMethod::direct)).margin(5e-3));
}

TEST_CASE("Sweep by sweep joints come nearer to what the direct solver does at once", "[joint sweeps]") {
  const double few = widest_gap(chain(8, 5, JointMethod::iterative, 4), 1);
  const double many = widest_gap(chain(8, 5, JointMethod::iterative, 64), 1);
  CHECK(many < few);
  CHECK(widest_gap(chain(8, 5, JointMethod::direct), 1) < pick(1e-11, 1e-4));
  CHECK(many > pick(1e-9, 1e-4));
}

TEST_CASE("A heavy weight at the end of a light chain is what iterating is bad at", "[joint sweeps]") {
  CHECK(widest_gap(chain(10, 100, JointMethod::iterative), 1) > 1e-3);
  CHECK(widest_gap(chain(10, 100, JointMethod::direct), 1) < pick(1e-10, 1e-3));
}

TEST_CASE("Both equations of a pin are solved at once: after a single sweep its points do not part", "[joint sweeps]") {
  Scene scene = chain(1, 1, JointMethod::iterative, 1);
  const Vec2d anchor{-0.5, 0.3};
  scene.joints[0].anchor_b = anchor;
  scene.bodies[0].position = {0.5, -0.3};
  const auto simulation = simulate(scene);
  for (int tick = 0; tick < 30; ++tick) {
    simulation->step();
    const BodyState body = simulation->body(BodyId(1));
    const double cosine = std::cos(body.angle);
    const double sine = std::sin(body.angle);
    const Vec2d arm{cosine * anchor.x - sine * anchor.y, sine * anchor.x + cosine * anchor.y};
    CHECK(length(body.velocity + cross(body.spin, arm)) < pick(1e-14, 1e-6));
  }
}

TEST_CASE("A kinematic body that pulls at a swept pin does the work that the pulled one gains", "[joint sweeps]") {
  Scene scene = chain(1, 1, JointMethod::iterative);
  scene.gravity = {0, 0};
  BodyDef& puller = scene.bodies.emplace_back();
  puller.type = BodyType::kinematic;
  puller.velocity = {1, 2};
  scene.bodies[0].velocity = {1, 2.5};  // so that it turns about the pin
  scene.bodies[0].spin = 1;
  scene.joints[0] = joint_between(JointKind::revolute, BodyId(2), {0, 0}, BodyId(1), {-0.5, 0});
  const auto simulation = simulate(scene);
  const Energy before = simulation->energy();
  run(*simulation, 0.5);
  const Energy after = simulation->energy();
  CHECK(std::abs(after.total() - before.total()) > 0.1);
  CHECK(after.booked_work == Approx(after.total() - before.total()).epsilon(0.03));
}

TEST_CASE("Impulses of iterated joints are mutual: momentum stays", "[joint sweeps]") {
  Scene scene = chain(4, 3, JointMethod::iterative);
  scene.gravity = {0, 0};
  scene.joints.erase(scene.joints.begin());
  scene.bodies[0].velocity = {1, 2};
  scene.bodies[3].spin = 3;
  const auto simulation = simulate(scene);
  const auto momentum = [&] {
    Vec2d sum;
    for (std::uint32_t i = 1; i <= 4; ++i)
      sum += simulation->body(BodyId(i)).mass * simulation->body(BodyId(i)).velocity;
    return sum;
  };
  const Vec2d before = momentum();
  run(*simulation, 2);
  CHECK(length(momentum() - before) < pick(1e-12, 1e-5));
}

TEST_CASE("Iterated limits stop, and iterated motors run at their speed with no more than they have",
          "[joint sweeps]") {
  Scene scene = chain(1, 1, JointMethod::iterative);
  scene.joints[0].limits = LimitsDef{-0.5, 0.5};
  const auto stopped = simulate(scene);
  run(*stopped, 2);
  CHECK(stopped->body(BodyId(1)).angle == Approx(-0.5).margin(1e-2));
  CHECK(std::abs(stopped->body(BodyId(1)).spin) < 1e-3);

  scene.joints[0].limits.reset();
  scene.gravity = {0, 0};
  scene.joints[0].motor = MotorDef{3, 2};
  const auto driven = simulate(scene);
  const double inertia = driven->body(BodyId(1)).inertia + 0.25;
  run(*driven, 0.1);
  CHECK(driven->body(BodyId(1)).spin == Approx(0.1 * 2 / inertia).epsilon(0.02));
  run(*driven, 2);
  CHECK(driven->body(BodyId(1)).spin == Approx(3).epsilon(1e-3));
  const Energy energy = driven->energy();
  CHECK(energy.booked_work == Approx(energy.total()).epsilon(0.03));
}

TEST_CASE("A composed integrator is refused with joints that are only iterated", "[joint sweeps]") {
  Scene scene = chain(1, 1, JointMethod::iterative);
  scene.method.integrator = Integrator::suzuki4;
  CHECK(problem_with_method(scene).value_or("").find("joint_solver \"direct\"") != std::string::npos);
  scene.method.joint_solver = JointMethod::direct;
  CHECK_FALSE(problem_with_method(scene));
}

TEST_CASE("A chain is solved at once however long it is, a large net row by row, and explain says so",
          "[joint sweeps]") {
  const auto net = [](int side) {
    Scene scene;
    const auto id = [side](int x, int y) { return static_cast<BodyId>(1 + y * side + x); };
    for (int y = 0; y < side; ++y) {
      for (int x = 0; x < side; ++x) {
        scene.bodies.push_back(body_with(disc_shape(0.4), {1.0 * x, -1.0 * y}));
        scene.bodies.back().filter.group = -1;
        if (y == 0) scene.bodies.back().type = BodyType::fixed;
        if (x > 0 && y > 0)
          scene.joints.push_back(joint_between(JointKind::revolute, id(x - 1, y), {0.5, 0}, id(x, y), {-0.5, 0}));
        if (y > 0)
          scene.joints.push_back(joint_between(JointKind::revolute, id(x, y - 1), {0, -0.5}, id(x, y), {0, 0.5}));
      }
    }
    return scene;
  };
  const auto told = [](const Scene& scene) {
    for (const EffectDecision& decision : simulate(scene)->effects()) {
      if (decision.effect == Effect::joints) return decision.how;
    }
    return std::string();
  };
  CHECK(told(chain(2000, 1, JointMethod::direct)).find("one by one") == std::string::npos);
  CHECK(told(net(8)).find("one by one") == std::string::npos);
  CHECK(told(net(27)).find("one by one") == std::string::npos);  // numbered row by row it would take too much
  const Scene large = net(36);
  CHECK(told(large).find("one by one") != std::string::npos);
  CHECK(widest_gap(large, 0.5) < 0.01);  // and it holds: by a hundredth of a disc, over 35 rows
}
