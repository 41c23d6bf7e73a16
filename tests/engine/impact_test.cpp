#include <catch2/catch.hpp>
#include <cmath>

#include "engine/elementary.h"
#include "tests/engine/random.h"
#include "tests/engine/scenes.h"

using namespace proofreel;
using namespace proofreel::test;

namespace {

Vec2d momentum(const Simulation& simulation, int bodies) {
  Vec2d sum;
  for (int i = 1; i <= bodies; ++i) {
    const BodyState b = simulation.body(BodyId(i));
    sum += b.mass * b.velocity;
  }
  return sum;
}

double angular_momentum(const Simulation& simulation, int bodies) {
  double sum = 0;
  for (int i = 1; i <= bodies; ++i) {
    const BodyState b = simulation.body(BodyId(i));
    sum += b.inertia * b.spin + b.mass * cross(b.center, b.velocity);
  }
  return sum;
}

Scene bouncing_ball(double restitution) {
  Scene scene = with_floor(body_with(disc_shape(0.5), {0, 1.5}));
  scene.bodies[1].shapes[0].restitution = restitution;
  return scene;
}

}  // namespace

TEST_CASE("An elastic ball bounces for ever, and the bounces stay in phase", "[impact]") {
  auto simulation = simulate(bouncing_ball(1));
  const double start = simulation->energy().total();
  run(*simulation, 100);
  // Period 2 sqrt(2 h / g) = 0.903047281971 s; the gap after 100 s by the closed form.
  CHECK(simulation->body(BodyId{2}).position.y - 0.5 == Approx(0.721581154448).margin(pick(1e-8, 0.2)));
  CHECK(simulation->energy().total() == Approx(start).epsilon(pick(1e-9, 1e-2)));
}

TEST_CASE("Each bounce reaches the square of the restitution of the height before", "[impact]") {
  for (const double e : {0.3, 0.5, 0.8, 0.95}) {
    auto simulation = simulate(bouncing_ball(e));
    double apex = 0;
    bool bounced = false;
    for (int i = 0; i < 240; ++i) {
      simulation->step();
      const BodyState ball = simulation->body(BodyId{2});
      bounced |= ball.velocity.y > 0;
      if (bounced) apex = std::max(apex, ball.position.y - 0.5);
    }
    CHECK(apex == Approx(e * e).epsilon(1e-3));
  }
}

TEST_CASE("Ever smaller bounces end when the series says", "[impact]") {
  // e = 0.5 from 1 m: the sum of all flights is 1.35457092296 s.
  auto simulation = simulate(bouncing_ball(0.5));
  int last_moving = 0;
  for (int i = 1; i <= 480; ++i) {
    simulation->step();
    if (length(simulation->body(BodyId{2}).velocity) > 1e-3) last_moving = i;
  }
  CHECK(last_moving / 240.0 == Approx(1.35457).margin(0.02));
}

TEST_CASE("A box that lands flat bounces without turning", "[impact]") {
  Scene scene = with_floor(body_with(box_shape(1, 0.5), {0.3, 2}));
  scene.bodies[1].shapes[0].restitution = 0.6;
  auto simulation = simulate(scene);
  run(*simulation, 2);
  CHECK(std::abs(simulation->body(BodyId{2}).angle) < pick(1e-9, 1e-3));
}

TEST_CASE("A row of elastic discs passes the momentum on to the last one", "[impact]") {
  Scene scene;
  scene.gravity = {0, 0};
  for (int i = 0; i < 5; ++i) {
    scene.bodies.push_back(body_with(disc_shape(0.2), {i == 0 ? -1 : 0.4 * i, 0}));
    scene.bodies.back().shapes[0].restitution = 1;
    scene.bodies.back().shapes[0].friction = {0, 0};
  }
  scene.bodies[0].velocity = {2, 0};
  auto simulation = simulate(scene);
  run(*simulation, 1);
  for (int i = 1; i <= 4; ++i) CHECK(length(simulation->body(BodyId(i)).velocity) < pick(1e-9, 1e-4));
  CHECK(simulation->body(BodyId{5}).velocity.x == Approx(2).epsilon(1e-6));
}

TEST_CASE("Collisions keep momentum, and angular momentum but for the soft push", "[impact]") {
  Random random(9);
  Scene scene;
  scene.gravity = {0, 0};
  for (int i = 0; i < 20; ++i) {
    const ShapeDef shape = i % 2 == 0 ? box_shape(0.6, 0.4) : disc_shape(0.3);
    scene.bodies.push_back(body_with(shape, {random.between(-2, 2), random.between(-2, 2)}));
    scene.bodies.back().velocity = {random.between(-3, 3), random.between(-3, 3)};
    scene.bodies.back().spin = random.between(-5, 5);
  }
  auto simulation = simulate(scene);
  const Vec2d before = momentum(*simulation, 20);
  const double turning = angular_momentum(*simulation, 20);
  run(*simulation, 2);
  CHECK(distance(momentum(*simulation, 20), before) < pick(1e-12, 1e-4));
  CHECK(angular_momentum(*simulation, 20) == Approx(turning).margin(pick(0.05, 0.05)));
}

TEST_CASE("A thin wall stops a bullet of a kilometre per second", "[impact]") {
  Scene scene;
  scene.gravity = {0, 0};
  scene.bodies = {body_with(box_shape(0.02, 2), {0, 1}, BodyType::fixed), body_with(disc_shape(0.05), {-3, 1})};
  scene.bodies[1].velocity = {1000, 0};
  scene.bodies[1].bullet = true;
  auto simulation = simulate(scene);
  for (int i = 0; i < 120; ++i) {
    simulation->step();
    REQUIRE(simulation->body(BodyId{2}).position.x < 0);
  }
}

TEST_CASE("What flies past a corner is not deflected by it, however fast and close", "[impact]") {
  const double radius = 0.05;
  for (const double speed : {5.0, 15.0, 200.0}) {
    for (const double clearance : {0.004, 0.05}) {
      for (int phase = 0; phase < 20; ++phase) {
        Scene scene;
        scene.gravity = {0, 0};
        const Vec2d along = normalized(Vec2d{1, -1});
        const Vec2d nearest = Vec2d{0.5, 0.5} + (radius + clearance) * perp(along);
        scene.bodies = {body_with(box_shape(1, 1), {0, 0}, BodyType::fixed),
                        body_with(disc_shape(radius), nearest - (0.5 + phase * speed / 240 / 20) * along)};
        scene.bodies[1].velocity = speed * along;
        scene.bodies[1].shapes[0].restitution = phase % 2;
        auto simulation = simulate(scene);
        run(*simulation, 2 / speed + 0.02);
        INFO("speed " << speed << ", clearance " << clearance << ", phase " << phase);
        REQUIRE(distance(simulation->body(BodyId{2}).velocity, speed * along) < 1e-3 * speed);
      }
    }
  }
}

TEST_CASE("The end of a fast turning plank does not pass through a thin post", "[impact]") {
  for (int phase = 0; phase < 10; ++phase) {
    Scene scene;
    scene.gravity = {0, 0};
    scene.bodies = {body_with(box_shape(1, 0.02), {0, 0}), body_with(disc_shape(0.01), {0, 0.47}, BodyType::fixed)};
    scene.bodies[0].spin = 60;
    scene.bodies[0].angle = 0.02 * phase;
    auto simulation = simulate(scene);
    run(*simulation, 0.05);
    CHECK(simulation->body(BodyId{1}).spin < 50);
  }
}

TEST_CASE("Boxes that start inside each other part gently", "[impact]") {
  Scene scene;
  scene.gravity = {0, 0};
  scene.bodies = {body_with(box_shape(1, 1), {0, 0}), body_with(box_shape(1, 1), {0.75, 0.1})};
  auto simulation = simulate(scene);
  double fastest = 0;
  for (int i = 0; i < 240; ++i) {
    simulation->step();
    fastest = std::max(fastest, length(simulation->body(BodyId{2}).velocity));
  }
  CHECK(simulation->body(BodyId{2}).position.x - simulation->body(BodyId{1}).position.x > 0.99);
  CHECK(fastest < 3);
}

TEST_CASE("A smooth elastic disc is reflected without spin, at whatever speed, slope and moment it arrives") {
  for (const double speed : {3.0, 14.8, 60.0}) {
    for (const double slope : {0.2, 0.8, 1.3}) {
      for (int phase = 0; phase < 5; ++phase) {
        Scene scene;
        scene.gravity = {0, 0};
        ShapeDef shape = disc_shape(0.05);
        shape.restitution = 1;
        shape.friction = {0, 0};
        BodyDef disc = body_with(shape, {0, 0.5 + 0.013 * phase});
        disc.velocity = {speed * elementary::cos(slope), -speed * elementary::sin(slope)};
        BodyDef wall = body_with(box_shape(1, 1), {}, BodyType::fixed);
        wall.shapes[0].points = {{100, 0}, {-100, 0}};
        wall.shapes[0].friction = {0, 0};
        scene.bodies = {disc, wall};
        const auto simulation = simulate(scene);
        run(*simulation, 1.2);
        const BodyState state = simulation->body(BodyId{1});
        INFO(speed << " m/s, slope " << slope << ", phase " << phase);
        CHECK(state.spin == Approx(0).margin(pick(1e-9, 1e-2)));
        CHECK(state.velocity.x == Approx(disc.velocity.x).epsilon(pick(1e-9, 1e-4)));
        CHECK(state.velocity.y == Approx(-disc.velocity.y).epsilon(pick(1e-9, 1e-4)));
      }
    }
  }
}
