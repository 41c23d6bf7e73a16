// Lecture films on masses, friction and the contact solver, held against answers found another way.

#include <algorithm>
#include <catch2/catch.hpp>
#include <numbers>

#include "engine/mass.h"
#include "engine/simulation.h"
#include "film_marks.h"
#include "scenarios/demonstrations/stack.h"

using namespace proofreel;
using namespace proofreel::films;

namespace {

constexpr double pi = std::numbers::pi;

const std::vector<DemonstrationShape> tower{box_at({0, 0.4}, 1.4, 0.8), box_at({0, 1.2}, 1.2, 0.8),
                                            box_at({0, 2}, 1, 0.8)};

}  // namespace

TEST_CASE("The beam balances where both masses pull alike, all the while one of them grows") {
  const Story story = told(Algorithm::center_of_mass, parts);
  int seen = 0;
  for (const Step& step : story.steps) {
    const StoryMark* balance = mark_called(step, MarkKind::region, "wedge");
    const StoryMark* left = mark_called(step, MarkKind::shape, "m_{1}");
    const StoryMark* right = mark_called(step, MarkKind::shape, "m_{2}");
    if (balance == nullptr) continue;
    ++seen;
    REQUIRE(left != nullptr);
    REQUIRE(right != nullptr);
    // Masses go by the areas of the discs.
    const auto moment = [&](const StoryMark& disc) {
      return disc.radius * disc.radius * (disc.points[0].x - balance->points[0].x);
    };
    CHECK(moment(*left) + moment(*right) == Approx(0).margin(1e-12));
  }
  CHECK(seen > 60);
}

TEST_CASE("The centre of the body drawn at the end is that of the whole body") {
  const Story story = told(Algorithm::center_of_mass, parts);
  const StoryMark* center = mark_called(story.steps.back(), MarkKind::dot, "balance");
  REQUIRE(center != nullptr);
  // By hand: areas 2.08, 2.56 and 0.49 pi at the centres of the shapes.
  const double disc = 0.49 * pi, all = 2.08 + 2.56 + disc;
  const Vec2d expected{(2.08 * -1.6 + 2.56 * 0.4 + disc * 2.4) / all, (2.56 * -0.9 + disc * 0.2) / all};
  CHECK(distance(center->points[0], expected) < 1e-12);
}

TEST_CASE("A density of its own moves the centre of mass") {
  std::vector<DemonstrationShape> heavy = parts;
  heavy[2].density = 1000;
  const Story story = told(Algorithm::center_of_mass, heavy);
  CHECK(distance(mark_called(story.steps.back(), MarkKind::dot, "balance")->points[0], Vec2d{2.4, 0.2}) < 0.02);
}

TEST_CASE("The moments of inertia add up to that of the body, each by Steiner's theorem") {
  const Story story = told(Algorithm::moment_of_inertia, parts);
  BodyDef body;
  for (const DemonstrationShape& part : parts) {
    ShapeDef def;
    def.points = part.parts[0];
    def.radius = part.radius;
    body.shapes.push_back(def);
  }
  const MassProperties whole = mass_of(body);
  const Step& last = story.steps.back();
  double sum = 0;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    const std::string n = std::to_string(i + 1);
    const std::string key = "$I_{" + n + "} + m_{" + n + "}\u2009d_{" + n + "}^2$";
    const MassProperties own = mass_of(body.shapes[i]);
    CHECK(bar_length(last, 1, key) == Approx(own.inertia / whole.inertia));
    const double moved = own.mass * length_squared(own.center - whole.center);
    CHECK(bar_length(last, 1, key + " further") == Approx(moved / whole.inertia));
    sum += bar_length(last, 1, key) + bar_length(last, 1, key + " further");
  }
  CHECK(sum == Approx(1));
  CHECK(bar_length(last, 1, "sum") == Approx(1));
}

TEST_CASE("Once round its own centre a shape's moment of inertia stays, and beside it it is larger") {
  const Story story = told(Algorithm::moment_of_inertia, parts);
  const double own = bar_length(step_saying(story, "I_1 ="), 1, "sum");
  for (const Step& step : story.steps) {
    if (step.heading == "Moment of inertia about the own centre") CHECK(bar_length(step, 1, "sum") == Approx(own));
    if (step.caption.starts_with("Now the shape goes round")) CHECK(bar_length(step, 1, "sum") > own);
  }
}

TEST_CASE("A shape in the middle of its body has no axis beside it to turn about") {
  const std::vector<DemonstrationShape> cross{box_at({0, 0}, 3, 0.5), box_at({0, 1}, 0.5, 1.5),
                                              box_at({0, -1}, 0.5, 1.5)};
  for (const Step& step : told(Algorithm::moment_of_inertia, cross).steps)
    CHECK(step.heading.find("Steiner") == std::string::npos);
}

TEST_CASE("Whatever the coefficients, the block comes to rest again at the end") {
  for (const auto& [at_rest, sliding] : {std::pair{0.21, 0.2}, {1.0, 0.2}, {1.0, 0.99}, {0.5, 0.49}}) {
    DemonstrationShape block = box_at({0, 0}, 2, 0.5);
    block.friction = {at_rest, sliding};
    const Step last = told(Algorithm::friction_cone, std::vector{block}).steps.back();
    CHECK(last.counters[1].value == "0.00 m/s");
  }
}

TEST_CASE("Inside the cone friction is the force along the ground; the block begins to slide at its edge") {
  const double at_rest = 0.6;
  const Story story = told(Algorithm::friction_cone, std::vector{block_of(at_rest, 0.4)});
  const DemonstrationShape block = block_of(at_rest, 0.4);
  int resting = 0, sliding = 0;
  const double start = mark_called(story.steps.front(), MarkKind::shape, "block")->points[0].x;
  bool moved = false;
  for (const Step& step : story.steps) {
    const StoryMark* f = mark_called(step, MarkKind::arrow, "F");
    const StoryMark* r = mark_called(step, MarkKind::arrow, "R");
    REQUIRE(f != nullptr);
    REQUIRE(r != nullptr);
    const double along = tip(*f).x, down = -tip(*f).y;
    const double x = mark_called(step, MarkKind::shape, "block")->points[0].x;
    moved |= x > start + 1e-6;
    if (!moved) {
      ++resting;
      CHECK(along <= at_rest * down + 1e-9);
      CHECK(tip(*r).x == Approx(-along).margin(1e-6));
      CHECK(tip(*r).y == Approx(down));
    } else if (f->role == Role::alert) {
      ++sliding;
      CHECK(tip(*r).x == Approx(-0.4 * tip(*r).y).epsilon(0.01));
    }
  }
  CHECK(resting > 100);
  CHECK(sliding > 30);
  CHECK(story.steps.back().caption.starts_with("At rest again"));
  const StoryMark* last = mark_called(story.steps.back(), MarkKind::arrow, "R");
  CHECK(tip(*last).x == Approx(-tip(*mark_called(story.steps.back(), MarkKind::arrow, "F")).x).margin(1e-6));
}

TEST_CASE("From warm starts a tower gets what the weights ask for; from cold ones it sinks more than twice as deep") {
  const Story story = told(Algorithm::sequential_impulses, tower);
  const double g = 9.81 / 60;
  const std::vector<double> masses{1.4 * 0.8, 1.2 * 0.8, 1 * 0.8};
  const double all = g * (masses[0] + masses[1] + masses[2]);
  const auto impulse = [&](int pane, const std::string& name) {
    return 1.3 * all * bar_length(story.steps.back(), pane, name);
  };
  CHECK(impulse(2, "ground\u20131") == Approx(all).epsilon(0.1));
  CHECK(impulse(2, "2\u20133") == Approx(g * masses[2]).epsilon(0.1));
  const double cold = bar_length(story.steps.back(), 1, "sunk"), warm = bar_length(story.steps.back(), 2, "sunk");
  CHECK(cold > 0.1);
  CHECK(warm < 0.5 * cold);
}

TEST_CASE("The marks of what the contacts have to bear are at the weights above them") {
  const Story story = told(Algorithm::sequential_impulses, tower);
  const auto marks = marks_of(story.steps.back(), MarkKind::path, Role::first, 1);
  REQUIRE(marks.size() == 3);
  const std::vector<double> above{0.8, 0.8 + 0.96, 0.8 + 0.96 + 1.12};  // kg, from the top down
  for (std::size_t i = 0; i < 3; ++i) CHECK(marks[i].points[0].x * 1.3 == Approx(above[i] / above[2]).epsilon(1e-4));
}

TEST_CASE("The film's warm side is what the engine does in a tick of as many substeps") {
  Stack stack(tower);
  for (int substep = 0; substep < 3; ++substep) {
    stack.begin_substep(1.0 / 60, true);
    for (int i = 0; i < 4; ++i) stack.sweep();
    stack.end_substep();
  }
  Scene scene;
  scene.rate = 20;
  scene.method.integrator = Integrator::symplectic_euler;
  scene.method.contact_solver = ContactMethod::sequential_impulses;
  scene.method.substeps = 3;
  scene.method.iterations = 4;
  BodyDef ground;
  ground.type = BodyType::fixed;
  ShapeDef slab;
  slab.points = {{-3, -1}, {3, -1}, {3, 0}, {-3, 0}};
  ground.shapes = {slab};
  scene.bodies = {ground};
  for (const DemonstrationShape& box : tower) {
    BodyDef body;
    ShapeDef shape;
    shape.points = box.parts[0];
    body.shapes = {shape};
    scene.bodies.push_back(body);
  }
  const auto simulation = make_simulation(scene);
  simulation->step();
  const auto speed = [&](int body) { return simulation->body(BodyId{static_cast<std::uint32_t>(body)}).velocity.y; };
  for (int i = 0; i < 3; ++i)
    CHECK(stack.velocity(static_cast<std::size_t>(i) + 1).y == Approx(speed(i + 2)).margin(1e-9));
}

TEST_CASE("A sweep tells of every contact once, and its last word is what the solver keeps") {
  Stack stack(tower);
  stack.begin_substep(1.0 / 60, false);
  std::vector<double> told(stack.contacts().size(), -1);
  std::size_t events = 0;
  for (int i = 0; i < 5; ++i) {
    stack.sweep(Observer([&](const Event& event) {
      const auto& swept = std::get<ContactSwept>(event);
      REQUIRE(swept.contact < told.size());
      told[swept.contact] = swept.normal[0] + swept.normal[1];
      CHECK(swept.normal[0] >= 0);
      ++events;
    }));
  }
  CHECK(events == 5 * told.size());
  CHECK(told == stack.impulses());
}
