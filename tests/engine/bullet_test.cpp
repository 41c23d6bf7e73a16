// Continuous collision: what is fast does not get through what is thin.

#include <catch2/catch.hpp>

#include "engine/rot.h"
#include "tests/engine/random.h"
#include "tests/engine/scenes.h"

using namespace proofreel;
using namespace proofreel::test;

namespace {

constexpr BodyId plate{1};
constexpr BodyId shot{2};

/// Which side of the plate the shot is on, m along the plate's short axis.
double side(const Simulation& simulation) {
  const BodyState p = simulation.body(plate);
  return inverse_rotate(Rotd(p.angle), simulation.body(shot).center - p.center).x;
}

/// A plate of 2 cm, and a shot aimed at a point of it near where it will be.
Scene shot_at_plate(BodyType type, double speed, Random& random) {
  Scene scene;
  scene.gravity = {0, 0};
  scene.bodies = {body_with(box_shape(0.02, 3), {0, 0}, type), body_with(disc_shape(0.04), {0, 0})};
  if (type != BodyType::fixed) {
    scene.bodies[0].velocity = {random.between(-3, 3), random.between(-2, 2)};
    scene.bodies[0].spin = random.between(-3, 3);
  }
  scene.bodies[0].angle = random.between(-0.5, 0.5);
  scene.bodies[0].mass = 5;
  scene.bodies[1].mass = 0.01;
  scene.bodies[1].bullet = true;
  const double way = random.between(2, 3);
  const Vec2d aim = (way / speed) * scene.bodies[0].velocity + Vec2d{0, random.between(-0.8, 0.8)};
  const Vec2d direction = rotate(Rotd(random.between(-0.4, 0.4)), Vec2d{1, 0});
  scene.bodies[1].position = aim - way * direction;
  scene.bodies[1].velocity = speed * direction;
  for (BodyDef& body : scene.bodies) body.shapes[0].restitution = random.between(0, 1) < 0.5 ? 0 : 0.7;
  return scene;
}

}  // namespace

TEST_CASE("A bullet gets through nothing: not through what stands, nor through what moves and turns", "[ccd]") {
  const BodyType type = GENERATE(BodyType::fixed, BodyType::kinematic, BodyType::dynamic);
  const ContactMethod method = GENERATE(ContactMethod::soft_step, ContactMethod::exact, ContactMethod::event);
  Random random(11);
  for (int run = 0; run < 60; ++run) {
    const double speed = std::exp2(random.between(4, 9));  // 16 to 512 m/s
    Scene scene = shot_at_plate(type, speed, random);
    scene.method.contact_solver = method;
    const auto simulation = simulate(scene);
    REQUIRE(side(*simulation) < 0);
    const int ticks = static_cast<int>(4 / speed * 240) + 3;
    bool met = false;
    for (int i = 0; i < ticks; ++i) {
      simulation->step();
      met |= !simulation->contact_events().empty();
      INFO("run " << run << ", " << speed << " m/s, tick " << i << ", solver " << static_cast<int>(method));
      REQUIRE(side(*simulation) < 0);
    }
    CHECK(met);
  }
}

TEST_CASE("A rod that whirls does not get its ends through a thin wall", "[ccd]") {
  Random random(12);
  for (int run = 0; run < 40; ++run) {
    Scene scene;
    scene.gravity = {0, 0};
    scene.bodies = {body_with(box_shape(0.02, 8), {0, 0}, BodyType::fixed), body_with(box_shape(2, 0.05), {-1.3, 0})};
    scene.bodies[1].angle = random.between(0.5, 2.5);
    scene.bodies[1].spin = random.between(10, 60) * (run % 2 == 0 ? 1 : -1);
    scene.bodies[1].velocity = {random.between(1, 30), 0};
    const auto simulation = simulate(scene);
    for (int i = 0; i < 60; ++i) {
      simulation->step();
      INFO("run " << run << ", tick " << i);
      REQUIRE(simulation->body(shot).center.x < 0);
    }
  }
}
