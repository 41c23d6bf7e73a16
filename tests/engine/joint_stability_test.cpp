// Joints where it is hard: light links that hold heavy bodies, chains that start torn, masses that have nothing in
// common.

#include <catch2/catch.hpp>
#include <cmath>

#include "tests/engine/scenes.h"

using namespace proofreel;
using namespace proofreel::test;
using Catch::Matchers::Contains;

namespace {

constexpr int rate = 60;

Scene empty_scene(int substeps) {
  Scene scene;
  scene.gravity = {0, -10};
  scene.rate = rate;
  scene.method.substeps = substeps;
  return scene;
}

/// Links of 1 m and 0.25 kg, level from the world, and at their end a disc of `ratio` times the mass of one.
Scene loaded_chain(int links, double ratio, int substeps = 4) {
  Scene scene = empty_scene(substeps);
  for (int i = 0; i <= links; ++i) {
    const bool is_load = i == links;
    const Vec2d left = is_load ? Vec2d{-2, 0} : Vec2d{-0.5, 0};
    scene.bodies.push_back(is_load ? body_with(disc_shape(2), {links + 2.0, 0})
                                   : body_with(box_shape(1, 0.25), {i + 0.5, 0}));
    scene.bodies.back().filter.group = -1;
    scene.joints.push_back(joint_between(JointKind::revolute, BodyId(i), {i == 0 ? 0.0 : 0.5, 0}, BodyId(i + 1), left));
  }
  scene.bodies.back().mass = 0.25 * ratio;
  return scene;
}

double widest_gap(const Simulation& simulation, const Scene& scene) {
  double widest = 0;
  for (std::uint32_t j = 0; j < scene.joints.size(); ++j) widest = std::max(widest, simulation.joint(JointId{j}).gap);
  return widest;
}

std::string told_of_joints(const Simulation& simulation) {
  for (const EffectDecision& decision : simulation.effects()) {
    if (decision.effect == Effect::joints) return decision.how;
  }
  return "";
}

/// The same links, every joint one link apart.
Scene torn_chain(int links) {
  Scene scene = loaded_chain(links, 1);
  scene.bodies.pop_back();
  scene.joints.pop_back();
  for (int i = 0; i < links; ++i) scene.bodies[static_cast<std::size_t>(i)].position = {2 * i + 1.0, 0};
  return scene;
}

}  // namespace

TEST_CASE("A chain that carries 1800 times a link's mass stays closed, and keeps its energy", "[joint]") {
  for (const int substeps : {1, 4}) {
    const Scene scene = loaded_chain(12, 1800, substeps);
    const auto simulation = simulate(scene);
    const double start = simulation->energy().total();
    const double turned_over = 1800 * 0.25 * 10 * 14;
    double widest = 0;
    double drift = 0;
    for (int i = 0; i < 4 * rate; ++i) {  // down and up again
      simulation->step();
      widest = std::max(widest, widest_gap(*simulation, scene));
      drift = std::max(drift, std::abs(simulation->energy().total() - start));
    }
    INFO(substeps);
    CHECK(widest < pick(1e-12, 1e-3));
    CHECK(drift < 1e-3 * turned_over);
  }
}

TEST_CASE("A light line of rods between beads holds five thousand times a bead", "[joint]") {
  Scene scene = empty_scene(4);
  for (int i = 0; i < 8; ++i) {
    scene.bodies.push_back(body_with(disc_shape(0.2), {i + 1.0, 0}));
    scene.bodies.back().mass = i == 7 ? 5000 : 1;
    scene.bodies.back().filter.group = -1;
    scene.joints.push_back(joint_between(JointKind::distance, BodyId(i), {0, 0}, BodyId(i + 1), {0, 0}, 1));
  }
  const auto simulation = simulate(scene);
  double widest = 0;
  for (int i = 0; i < 3 * rate; ++i) {
    simulation->step();
    widest = std::max(widest, widest_gap(*simulation, scene));
  }
  CHECK(widest < pick(1e-12, 1e-4));
  CHECK_THAT(told_of_joints(*simulation), Contains("too fast for 4 substeps"));
}

TEST_CASE("Only what swings too fast gets more substeps, and explain tells how many", "[joint]") {
  const auto after_a_swing = [](const Scene& scene) {
    const auto simulation = simulate(scene);
    for (int i = 0; i < 2 * rate; ++i) simulation->step();
    return told_of_joints(*simulation);
  };
  CHECK(after_a_swing(loaded_chain(4, 10)) == "");
  CHECK(after_a_swing(loaded_chain(4, 1800)) == "swings too fast for 4 substeps got up to 16");
  CHECK(after_a_swing(loaded_chain(4, 1800, 16)) == "");
}

TEST_CASE("What rests beside a chain keeps its impulse while the substeps change", "[joint]") {
  Scene scene = loaded_chain(4, 1800);
  scene.bodies.push_back(body_with(box_shape(20, 1), {0, -30.5}, BodyType::fixed));
  scene.bodies.push_back(body_with(box_shape(1, 1), {0, -29.5}));
  const auto simulation = simulate(scene);
  for (int i = 0; i < 3 * rate; ++i) {
    simulation->step();
    if (i < rate / 2) continue;
    double impulse = 0;
    for (const ContactView& contact : simulation->contacts()) {
      for (int k = 0; k < contact.point_count; ++k) impulse += contact.points[k].normal_impulse;
    }
    REQUIRE(impulse == Approx(10.0 / rate).epsilon(pick(5e-3, 2e-2)));
  }
  CHECK_THAT(told_of_joints(*simulation), Contains("got up to 16"));
}

TEST_CASE("Fields are asked at the right times however many substeps a tick has", "[joint]") {
  Scene scene = loaded_chain(4, 1800);
  double last = 0;
  bool in_order = true;
  scene.fields = {[&](Vec2d, Vec2d, double t) {
    in_order &= t >= last;
    last = t;
    return Vec2d{};
  }};
  const auto simulation = simulate(scene);
  for (int i = 1; i <= 3 * rate; ++i) {
    simulation->step();
    REQUIRE(last == Approx(double(i) / rate).epsilon(1e-12));
  }
  CHECK(in_order);
  CHECK_THAT(told_of_joints(*simulation), Contains("got up to 16"));
}

TEST_CASE("A simulation saved while it takes more substeps goes on as if it had never stopped", "[joint][save]") {
  const Scene scene = loaded_chain(4, 1800);
  const auto unbroken = simulate(scene);
  for (int i = 0; i < rate; ++i) unbroken->step();
  REQUIRE_THAT(told_of_joints(*unbroken), Contains("got up to"));
  const auto resumed = simulate(scene);
  REQUIRE_FALSE(resumed->restore(unbroken->save()));
  CHECK(told_of_joints(*resumed) == told_of_joints(*unbroken));
  for (int i = 0; i < rate; ++i) {
    unbroken->step();
    resumed->step();
    REQUIRE(unbroken->state_hash() == resumed->state_hash());
  }
}

TEST_CASE("A chain that starts torn closes within half a second and is not thrown", "[joint]") {
  const Scene scene = torn_chain(20);
  const auto simulation = simulate(scene);
  const double start = simulation->energy().total();
  REQUIRE(widest_gap(*simulation, scene) == Approx(1));
  double fastest = 0;
  double gained = 0;
  for (int i = 1; i <= rate; ++i) {
    simulation->step();
    for (std::uint32_t b = 1; b <= 20; ++b) fastest = std::max(fastest, length(simulation->body(BodyId(b)).velocity));
    const Energy energy = simulation->energy();
    gained = std::max(gained, energy.total() - energy.booked_work - start);
    if (i == rate / 2) CHECK(widest_gap(*simulation, scene) < pick(1e-12, 1e-4));
    if (i == rate / 2) CHECK(fastest < 2.5 * 10 * 0.5);  // no more than a level rod's free end
  }
  CHECK(gained < 0.01);
  CHECK(simulation->energy().booked_work > 0.1);  // falling links are lifted when their chain closes
}

TEST_CASE("A torn chain that cannot close does not move the wall it hangs on, nor itself out of sight", "[joint]") {
  Scene scene = torn_chain(3);
  scene.bodies.push_back(body_with(box_shape(1, 1), {9.5, 0}, BodyType::fixed));
  scene.joints.push_back(joint_between(JointKind::revolute, BodyId{3}, {0.5, 0}, BodyId{4}, {-0.5, 0}));
  const auto simulation = simulate(scene);
  for (int i = 0; i < 2 * rate; ++i) {
    simulation->step();
    for (std::uint32_t b = 1; b <= 3; ++b) REQUIRE(length(simulation->body(BodyId{b}).position) < 10);
  }
  CHECK(simulation->body(BodyId{4}).position == Vec2d{9.5, 0});
}

TEST_CASE("Rails keep a tiny disc between two of 160000 times its inertia", "[joint]") {
  Scene scene = empty_scene(4);
  scene.bodies = {body_with(box_shape(20, 1), {0, -0.5}, BodyType::fixed), body_with(disc_shape(0.1), {0, 2.2}),
                  body_with(disc_shape(2), {-3.5, 2.2}), body_with(disc_shape(2), {3.5, 2.2})};
  for (const std::uint32_t side : {3U, 4U}) {
    JointDef rail = joint_between(JointKind::prismatic, BodyId{2}, {0, 0}, BodyId{side}, {side == 3 ? 3.5 : -3.5, 0});
    rail.axis = {1, 0};
    scene.joints.push_back(rail);
  }
  const auto simulation = simulate(scene);
  double widest = 0;
  for (int i = 0; i < 2 * rate; ++i) {
    simulation->step();
    widest = std::max(widest, widest_gap(*simulation, scene));
  }
  CHECK(widest < pick(1e-12, 5e-3));
}
