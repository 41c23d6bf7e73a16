// The contact solvers side by side: what all of them must obey, and what tells them apart.

#include <catch2/catch.hpp>
#include <cmath>
#include <string>

#include "engine/elementary.h"
#include "tests/engine/scenes.h"

using namespace proofreel;
using namespace proofreel::test;

namespace {

constexpr ContactMethod all_methods[] = {ContactMethod::soft_step, ContactMethod::sequential_impulses,
                                         ContactMethod::ngs, ContactMethod::exact, ContactMethod::event};

Scene stack_of(int boxes, ContactMethod method) {
  Scene scene;
  scene.method.contact_solver = method;
  scene.bodies = {floor_body()};
  for (int i = 0; i < boxes; ++i) scene.bodies.push_back(body_with(box_shape(1, 1), {0, i + 0.5}));
  return scene;
}

BodyState state_after(const Scene& scene, double seconds, BodyId body) {
  const auto simulation = simulate(scene);
  run(*simulation, seconds, scene.rate);
  REQUIRE_FALSE(simulation->failure());
  return simulation->body(body);
}

/// How fast a box goes after a second on a plane tilted by the angle whose tangent is `slope`.
double speed_on_slope(double slope, double friction, ContactMethod method) {
  Scene scene;
  scene.method.contact_solver = method;
  const double cosine = 1 / std::sqrt(1 + slope * slope);
  scene.gravity = {9.81 * slope * cosine, -9.81 * cosine};
  scene.bodies = {floor_body(), body_with(box_shape(1, 0.5), {0, 0.25})};
  for (BodyDef& body : scene.bodies) body.shapes[0].friction = {friction, friction};
  return state_after(scene, 1, BodyId(2)).velocity.x;
}

}  // namespace

TEST_CASE("Under every solver a stack of four stands still", "[contact solver]") {
  const ContactMethod method = GENERATE(from_range(std::begin(all_methods), std::end(all_methods)));
  const auto simulation = simulate(stack_of(4, method));
  run(*simulation, 3);
  for (int i = 0; i < 4; ++i) {
    const BodyState box = simulation->body(BodyId(static_cast<std::uint32_t>(i + 2)));
    INFO("solver " << static_cast<int>(method) << ", box " << i);
    CHECK(box.position.y == Approx(i + 0.5).margin(5e-3));
    CHECK(box.position.x == Approx(0).margin(2e-3));
    CHECK(length(box.velocity) < pick(1e-5, 1e-3));
  }
}

TEST_CASE("Under every solver a box starts to slide at the angle of friction", "[contact solver]") {
  const ContactMethod method = GENERATE(from_range(std::begin(all_methods), std::end(all_methods)));
  INFO("solver " << static_cast<int>(method));
  CHECK(std::abs(speed_on_slope(0.4995, 0.5, method)) < pick(1e-5, 1e-3));
  const double expected = 9.81 * 0.0005 / std::sqrt(1 + 0.5005 * 0.5005);
  CHECK(speed_on_slope(0.5005, 0.5, method) == Approx(expected).epsilon(0.05));
}

TEST_CASE("Under every solver momentum passes through a collision unchanged", "[contact solver]") {
  const ContactMethod method = GENERATE(from_range(std::begin(all_methods), std::end(all_methods)));
  Scene scene;
  scene.method.contact_solver = method;
  scene.gravity = {0, 0};
  scene.bodies = {body_with(box_shape(1, 1), {-2, 0.3}), body_with(disc_shape(0.4), {1, 0})};
  scene.bodies[0].velocity = {3, 0};
  scene.bodies[1].velocity = {-1, 0.2};
  const auto simulation = simulate(scene);
  const auto sums = [&] {
    Vec2d momentum;
    double spin = 0;
    for (const BodyId id : {BodyId(1), BodyId(2)}) {
      const BodyState b = simulation->body(id);
      momentum += b.mass * b.velocity;
      spin += b.inertia * b.spin + b.mass * cross(b.center, b.velocity);
    }
    return std::pair(momentum, spin);
  };
  const auto [momentum, turning] = sums();
  run(*simulation, 2);
  const auto [momentum_after, turning_after] = sums();
  INFO("solver " << static_cast<int>(method));
  CHECK(length(momentum_after - momentum) < pick(1e-12, 1e-5));
  // Contacts act at one place of the tick for both bodies but for the way they go meanwhile.
  CHECK(turning_after == Approx(turning).margin(0.02));
  CHECK(simulation->body(BodyId(1)).velocity.x < simulation->body(BodyId(2)).velocity.x);
}

TEST_CASE("The exact solver lets a stack stand where it was put, to the last digits", "[contact solver]") {
  const auto simulation = simulate(stack_of(10, ContactMethod::exact));
  run(*simulation, 2);
  for (int i = 0; i < 10; ++i) {
    const BodyState box = simulation->body(BodyId(static_cast<std::uint32_t>(i + 2)));
    CHECK(box.position.y == Approx(i + 0.5).margin(pick(1e-11, 1e-4)));
    CHECK(length(box.velocity) < pick(1e-11, 1e-4));
  }
}

TEST_CASE("What a heavy box does on a light one tells the solvers apart", "[contact solver]") {
  const auto sunk = [](ContactMethod method) {
    Scene scene = stack_of(2, method);
    scene.bodies[2].mass = 1000;
    return 1.5 - state_after(scene, 3, BodyId(3)).position.y;
  };
  CHECK(sunk(ContactMethod::soft_step) > 1e-3);  // a spring gives way to a load
  CHECK(std::abs(sunk(ContactMethod::exact)) < pick(1e-10, 1e-4));
  CHECK(std::abs(sunk(ContactMethod::event)) < pick(1e-10, 1e-4));
}

TEST_CASE("The exact solution does not depend on the order the bodies were made in", "[contact solver]") {
  Scene upwards = stack_of(5, ContactMethod::exact);
  for (std::size_t i = 1; i <= 5; ++i) upwards.bodies[i].position.x = 0.07 * static_cast<double>(i % 3);
  Scene downwards = upwards;
  std::reverse(downwards.bodies.begin() + 1, downwards.bodies.end());
  const BodyState top = state_after(upwards, 2, BodyId(6));
  const BodyState same = state_after(downwards, 2, BodyId(2));
  CHECK(length(top.position - same.position) < pick(1e-10, 1e-3));
}

TEST_CASE("Weight that several contacts share adds up to the weight", "[contact solver]") {
  const ContactMethod method = GENERATE(from_range(std::begin(all_methods), std::end(all_methods)));
  Scene scene = stack_of(0, method);  // a table on four legs: more contacts than it takes to tell their loads
  BodyDef table = body_with(box_shape(3, 0.2), {0, 0.6});
  for (const double x : {-1.4, -0.5, 0.5, 1.4}) {
    ShapeDef leg = box_shape(0.1, 0.5);
    for (Vec2d& p : leg.points) p += Vec2d{x, -0.35};
    table.shapes.push_back(leg);
  }
  scene.bodies.push_back(table);
  const auto simulation = simulate(scene);
  run(*simulation, 1);
  double pressed = 0;
  for (const ContactView& c : simulation->contacts()) {
    for (int k = 0; k < c.point_count; ++k) pressed += c.points[k].normal_impulse;
  }
  INFO("solver " << static_cast<int>(method));
  CHECK(240 * pressed == Approx(simulation->body(BodyId(2)).mass * 9.81).epsilon(pick(1e-6, 1e-3)));
}

TEST_CASE("Baumgarte's way out of an overlap leaves energy behind, the way through positions none",
          "[contact solver]") {
  const auto fastest = [](ContactMethod method) {
    Scene scene;
    scene.method.contact_solver = method;
    scene.gravity = {0, 0};
    scene.bodies = {floor_body(), body_with(box_shape(1, 1), {0, 0.4})};
    scene.method.integrator = Integrator::symplectic_euler;
    const auto simulation = simulate(scene);
    run(*simulation, 1);
    return std::pair(simulation->body(BodyId(2)).velocity.y, simulation->body(BodyId(2)).position.y);
  };
  const auto [speed, height] = fastest(ContactMethod::sequential_impulses);
  CHECK(speed > 0.1);
  CHECK(height > 0.6);
  const auto [still, out] = fastest(ContactMethod::ngs);
  CHECK(std::abs(still) < pick(1e-12, 1e-6));
  CHECK(out == Approx(0.5).margin(0.006));  // but for the slop of half a percent
}

TEST_CASE("Sequential impulses with as many sweeps as you like come to the exact solution", "[contact solver]") {
  const auto top = [](ContactMethod method, int sweeps) {
    Scene scene = stack_of(3, method);
    scene.gravity = {2, -9.81};
    scene.bodies[3].position.x = 0.3;
    scene.method.iterations = sweeps;
    return state_after(scene, 0.5, BodyId(4)).position;
  };
  const Vec2d truth = top(ContactMethod::exact, 1);
  const double few = length(top(ContactMethod::sequential_impulses, 2) - truth);
  const double many = length(top(ContactMethod::sequential_impulses, 200) - truth);
  CHECK(many < 1e-3);
  CHECK(many < few);
}

TEST_CASE("A jointed body at rest on contacts rests, when both are solved exactly", "[contact solver]") {
  Scene scene;
  scene.method.contact_solver = ContactMethod::exact;
  scene.bodies = {floor_body(), body_with(box_shape(3, 0.4), {0, 0.8}), body_with(disc_shape(0.3), {-1, 0.3}),
                  body_with(disc_shape(0.3), {1, 0.3})};
  scene.bodies[1].mass = 90;
  scene.bodies[2].mass = scene.bodies[3].mass = 0.28;
  scene.joints = {joint_between(JointKind::revolute, BodyId(2), {-1, -0.5}, BodyId(3), {0, 0}),
                  joint_between(JointKind::revolute, BodyId(2), {1, -0.5}, BodyId(4), {0, 0})};
  const auto simulation = simulate(scene);
  run(*simulation, 2);
  CHECK(length(simulation->body(BodyId(2)).velocity) < pick(1e-10, 1e-3));
  CHECK(simulation->body(BodyId(2)).position.y == Approx(0.8).margin(pick(1e-10, 1e-4)));
  CHECK(simulation->joint(JointId(0)).gap < pick(1e-12, 1e-5));
}

namespace {

/// Two legs of a pair of steps on ice, and half a ton on them: nothing but the hinge's stop keeps them from sliding
/// apart.
Scene loaded_steps() {
  constexpr double tilt = 0.3;
  const double top = std::cos(tilt) + 0.05 * std::sin(tilt);
  Scene scene = with_floor(body_with(disc_shape(0.1), {0, top}));
  scene.bodies[1].mass = 500;
  for (const double side : {-1.0, 1.0}) {
    BodyDef leg = body_with(box_shape(0.1, 1), {side * 0.5 * std::sin(tilt), top - 0.5 * std::cos(tilt)});
    leg.angle = side * tilt;
    scene.bodies.push_back(leg);
  }
  for (BodyDef& body : scene.bodies) body.shapes[0].friction = {0, 0};
  for (std::size_t i = 1; i < scene.bodies.size(); ++i) scene.bodies[i].filter.group = -1;
  scene.joints = {joint_between(JointKind::revolute, BodyId(3), {0, 0.5}, BodyId(4), {0, 0.5}),
                  joint_between(JointKind::revolute, BodyId(2), {0, 0}, BodyId(3), {0, 0.5})};
  scene.joints[0].limits = LimitsDef{-0.5, 0};
  return scene;
}

}  // namespace

TEST_CASE("Where a stop and contacts bear one load they are solved together: it rests, and nothing sinks in",
          "[contact solver]") {
  Scene scene = loaded_steps();
  scene.method.contact_solver = GENERATE(ContactMethod::automatic, ContactMethod::exact);
  const auto simulation = simulate(scene);
  const double height = simulation->body(BodyId(2)).position.y;
  double fastest = 0;
  for (int i = 0; i < 3 * 240; ++i) {
    simulation->step();
    if (i > 240) fastest = std::max(fastest, length(simulation->body(BodyId(2)).velocity));
  }
  CHECK(fastest < pick(1e-8, 1e-3));
  CHECK(simulation->body(BodyId(2)).position.y == Approx(height).margin(pick(1e-5, 1e-4)));
  CHECK(simulation->joint(JointId(0)).gap < pick(1e-10, 1e-5));
}

TEST_CASE("What falls on its stops and the floor at once gains nothing from it when solved exactly",
          "[contact solver]") {
  Scene scene = loaded_steps();
  scene.method.contact_solver = ContactMethod::exact;
  for (std::size_t i = 1; i < scene.bodies.size(); ++i) {
    scene.bodies[i].position.y += 1;
    scene.bodies[i].velocity = {0.7, 0};
    scene.bodies[i].spin = 1;
  }
  const auto simulation = simulate(scene);
  const double start = simulation->energy().total();
  double most = -1e9;
  for (int i = 0; i < 3 * 240; ++i) {
    simulation->step();
    most = std::max(most, simulation->energy().total() - start);
  }
  CHECK(most < 1e-3 * 500 * 9.81);
}

TEST_CASE("A disc rolls down a slope under every solver with two thirds of what gravity would give it",
          "[contact solver]") {
  const ContactMethod method = GENERATE(from_range(std::begin(all_methods), std::end(all_methods)));
  Scene scene = with_floor(body_with(disc_shape(0.5), {0, 0.5}));
  scene.method.contact_solver = method;
  scene.gravity = {2, -9.81};
  const BodyState disc = state_after(scene, 2, BodyId(2));
  INFO("solver " << static_cast<int>(method));
  CHECK(disc.velocity.x == Approx(2.0 * 2 * 2 / 3).epsilon(pick(1e-4, 1e-3)));
  CHECK(disc.spin == Approx(-disc.velocity.x / 0.5).epsilon(pick(1e-4, 1e-3)));
}

TEST_CASE("What a press squeezes against the floor is not thrown about by the exact solver", "[contact solver]") {
  Scene scene = with_floor(body_with(disc_shape(0.5), {0, 0.5}));
  scene.method.contact_solver = ContactMethod::exact;
  BodyDef press = body_with(box_shape(4, 0.5), {0, 1.3}, BodyType::kinematic);
  press.velocity = {0, -0.1};
  press.angle = 0.02;
  scene.bodies.push_back(press);
  const auto simulation = simulate(scene);
  for (int i = 0; i < 240; ++i) {
    simulation->step();
    REQUIRE_FALSE(simulation->failure());
    REQUIRE(length(simulation->body(BodyId(2)).velocity) < 10);
  }
}

TEST_CASE("Rolling resistance and belts act in the exact solver as in the others", "[contact solver]") {
  const ContactMethod method = GENERATE(ContactMethod::soft_step, ContactMethod::exact);
  Scene scene = with_floor(body_with(disc_shape(0.5), {0, 0.5}));
  scene.method.contact_solver = method;
  scene.bodies[1].velocity = {3, 0};
  scene.bodies[1].spin = -6;
  scene.bodies[1].shapes[0].rolling_resistance = 0.02;
  // The torque of lever times weight brakes 3/2 m v r: v' = -(2/3) g lever / r.
  CHECK(state_after(scene, 1, BodyId(2)).velocity.x == Approx(3 - 9.81 * 0.02 / 0.5 * 2 / 3).epsilon(2e-3));
  scene.bodies[1] = body_with(box_shape(1, 0.5), {0, 0.25});
  scene.bodies[0].shapes[0].surface_speed = -2;
  CHECK(state_after(scene, 2, BodyId(2)).velocity.x == Approx(2).epsilon(1e-3));
}

TEST_CASE("Friction that is taken away brakes no more, under any solver", "[contact solver]") {
  const ContactMethod method = GENERATE(from_range(std::begin(all_methods), std::end(all_methods)));
  Scene scene = with_floor(body_with(box_shape(1, 1), {0, 0.5}));
  scene.method.contact_solver = method;
  scene.bodies[1].velocity = {3, 0};
  const auto simulation = simulate(scene);
  run(*simulation, 0.2);
  const double speed = simulation->body(BodyId(2)).velocity.x;
  CHECK(speed == Approx(3 - 0.2 * 0.5 * 9.81).epsilon(1e-2));
  ChangeBody icy;
  icy.body = BodyId(1);
  icy.friction = FrictionDef{0, 0};
  simulation->apply(icy);
  run(*simulation, 1);
  INFO("solver " << static_cast<int>(method));
  CHECK(simulation->body(BodyId(2)).velocity.x == Approx(speed).epsilon(pick(1e-6, 1e-3)));
}

TEST_CASE("What slides without kinetic friction goes on sliding, whatever static friction there is",
          "[contact solver]") {
  const ContactMethod method = GENERATE(from_range(std::begin(all_methods), std::end(all_methods)));
  Scene scene = with_floor(body_with(box_shape(1, 1), {0, 0.5}));
  scene.method.contact_solver = method;
  for (BodyDef& body : scene.bodies) body.shapes[0].friction = {0.5, 0};
  scene.bodies[1].velocity = {3, 0};
  INFO("solver " << static_cast<int>(method));
  CHECK(state_after(scene, 2, BodyId(2)).velocity.x == Approx(3).epsilon(0.01));  // it sticks until it is seen to slide
}

TEST_CASE("A bounce is not lost by a hair's breadth", "[contact solver]") {
  const ContactMethod method = GENERATE(from_range(std::begin(all_methods), std::end(all_methods)));
  const double hair = GENERATE(0.0, 1e-15, 1e-12, 1e-9, 1e-7);
  Scene scene;
  scene.method.contact_solver = method;
  scene.gravity = {0, 0};
  // After a whole number of substeps the ball is a hair's breadth before the wall.
  scene.bodies = {body_with(box_shape(1, 10), {0.5, 0}, BodyType::fixed), body_with(disc_shape(0.5), {-1.5 - hair, 0})};
  scene.bodies[1].velocity = {4.8, 0};
  scene.bodies[1].shapes[0].restitution = 1;
  INFO("solver " << static_cast<int>(method) << ", hair " << hair);
  CHECK(state_after(scene, 1, BodyId(2)).velocity.x == Approx(-4.8));
}

TEST_CASE("A thousand tons on two kilograms do not sink in when solved exactly", "[contact solver]") {
  Scene scene;
  scene.method.contact_solver = ContactMethod::exact;
  scene.bodies = {floor_body(), body_with(disc_shape(0.05), {0, 0.05}), body_with(disc_shape(0.05), {0.8, 0.05}),
                  body_with(box_shape(1.5, 0.5), {0.4, 0.35})};
  scene.bodies[1].mass = scene.bodies[2].mass = 1;
  scene.bodies[3].mass = 1e6;
  CHECK(state_after(scene, 2, BodyId(4)).position.y == Approx(0.35).margin(pick(1e-8, 1e-3)));
}

namespace {

/// Discs that fall into a bin pell-mell.
Scene poured_discs() {
  Scene scene;
  scene.bodies = {floor_body(), body_with(box_shape(1, 20), {-2.5, 10}, BodyType::fixed),
                  body_with(box_shape(1, 20), {2.5, 10}, BodyType::fixed)};
  for (int i = 0; i < 24; ++i) {
    const Vec2d place{-1.5 + i % 4 + 0.05 * (i % 3), 1.0 + i / 4};
    scene.bodies.push_back(body_with(disc_shape(0.35), place));
  }
  return scene;
}

/// "3 of 5 contacts at the last tick were solved exactly": 3 / 5.
double exact_share(const Simulation& simulation) {
  for (const EffectDecision& decision : simulation.effects()) {
    if (decision.effect != Effect::contacts) continue;
    const std::size_t of = decision.how.find(" of ");
    const std::size_t first = decision.how.rfind(' ', of - 1) + 1;
    return std::stod(decision.how.substr(first)) / std::stod(decision.how.substr(of + 4));
  }
  return -1;
}

}  // namespace

TEST_CASE("A crowd that jostles is left to the sweeps, and solved exactly once it lies still", "[contact solver]") {
  const auto simulation = simulate(poured_discs());
  run(*simulation, 1.5);
  CHECK(exact_share(*simulation) < 0.5);
  run(*simulation, 8.5);
  CHECK(exact_share(*simulation) == 1);
}
