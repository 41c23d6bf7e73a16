#include "engine/seam.h"

#include <catch2/catch.hpp>

#include "tests/engine/scenes.h"

using namespace proofreel;
using namespace proofreel::test;

namespace {

ShapeDef segment_shape(Vec2d a, Vec2d b) {
  ShapeDef shape;
  shape.points = {a, b};
  return shape;
}

ShapeDef block(Vec2d low, Vec2d high) {
  ShapeDef shape;
  shape.points = {low, {high.x, low.y}, high, {low.x, high.y}};
  return shape;
}

Hull hull_of(const ShapeDef& def) { return make_hull(def, {0, 0}); }

Seam seam_between(const ShapeDef& own, const ShapeDef& other) {
  Seam seam;
  const Hull others[] = {hull_of(other)};
  find_seam(hull_of(own), others, seam);
  return seam;
}

void set_friction(Scene& scene, double mu) {
  for (BodyDef& body : scene.bodies) {
    for (ShapeDef& shape : body.shapes) shape.friction = {mu, mu};
  }
}

/// A body that glides to the right over ground from x = 0 to x = 30, whose top is y = 0.
Scene gliding(const ShapeDef& shape, double height, std::vector<BodyDef> ground, double mu) {
  Scene scene;
  BodyDef body = body_with(shape, {0.5, height});
  body.velocity = {6, 0};
  scene.bodies.push_back(body);
  for (BodyDef& part : ground) scene.bodies.push_back(part);
  set_friction(scene, mu);
  return scene;
}

std::vector<BodyDef> slab() { return {body_with(block({-1, -1}, {31, 0}), {0, 0}, BodyType::fixed)}; }

std::vector<BodyDef> tiles() {
  std::vector<BodyDef> row;
  for (int i = -1; i < 31; ++i) {
    const double x = i;
    row.push_back(body_with(block({0, -1}, {1, 0}), {x, 0}, BodyType::fixed));
  }
  return row;
}

std::vector<BodyDef> chain() {
  BodyDef body;
  body.type = BodyType::fixed;
  for (int i = -1; i < 31; ++i) {
    const double x = i;
    body.shapes.push_back(segment_shape({x + 1, 0}, {x, 0}));
  }
  return {body};
}

struct Glide {
  double travelled = 0;
  double highest = 0;  ///< speed up or down, m/s
};

Glide glide(const ShapeDef& shape, double height, std::vector<BodyDef> ground, double mu) {
  const auto simulation = simulate(gliding(shape, height, std::move(ground), mu));
  Glide result;
  for (int i = 0; i < 4 * 240; ++i) {
    simulation->step();
    result.highest = std::max(result.highest, std::abs(simulation->body(BodyId{1}).velocity.y));
  }
  result.travelled = simulation->body(BodyId{1}).position.x - 0.5;
  return result;
}

}  // namespace

TEST_CASE("A box glides over thirty flat seams as over one slab") {
  for (const double mu : {0.0, 0.1, 0.3}) {
    const Glide reference = glide(box_shape(0.8, 0.5), 0.25, slab(), mu);
    for (const auto& ground : {tiles(), chain()}) {
      const Glide seamed = glide(box_shape(0.8, 0.5), 0.25, ground, mu);
      INFO("friction " << mu << ", " << ground.size() << " bodies");
      CHECK(seamed.travelled == Approx(reference.travelled).epsilon(pick(1e-4, 1e-3)));
      CHECK(seamed.highest < reference.highest + pick(5e-3, 6e-3));
    }
  }
}

TEST_CASE("A disc rolls over a chain of segments without a kick") {
  const Glide reference = glide(disc_shape(0.25), 0.25, slab(), 0.5);
  for (const auto& ground : {tiles(), chain()}) {
    const Glide rolling = glide(disc_shape(0.25), 0.25, ground, 0.5);
    CHECK(rolling.highest < reference.highest + pick(1e-9, 1e-4));
    CHECK(rolling.travelled == Approx(reference.travelled).epsilon(pick(1e-9, 1e-4)));
  }
}

TEST_CASE("A capsule and a triangle glide over a chain as over a slab") {
  ShapeDef capsule = segment_shape({-0.4, 0}, {0.4, 0});
  capsule.radius = 0.2;
  ShapeDef triangle;
  triangle.points = {{-0.4, 0}, {0.4, 0}, {0, 0.5}};
  for (const auto& ground : {tiles(), chain()}) {
    CHECK(glide(capsule, 0.2, ground, 0.0).travelled == Approx(24).epsilon(1e-4));
    CHECK(glide(triangle, 0.0, ground, 0.0).travelled == Approx(24).epsilon(1e-4));
  }
}

TEST_CASE("The end of a row of tiles still stops what runs into it") {
  Scene scene = gliding(box_shape(0.5, 0.5), -0.5, tiles(), 0.0);
  scene.gravity = {0, 0};
  scene.bodies[0].position = {-3, -0.5};
  const auto simulation = simulate(scene);
  run(*simulation, 2);
  CHECK(simulation->body(BodyId{1}).position.x < -1.2);
}

TEST_CASE("A step between two tiles still stops what runs into it") {
  std::vector<BodyDef> ground = tiles();
  ground[10].position.y = 0.4;  // from x = 9 on
  Scene scene = gliding(box_shape(0.8, 0.5), 0.25, ground, 0.0);
  const auto simulation = simulate(scene);
  double farthest = 0;
  for (int i = 0; i < 3 * 240; ++i) {
    simulation->step();
    farthest = std::max(farthest, simulation->body(BodyId{1}).position.x);
  }
  CHECK(farthest == Approx(8.6).margin(0.02));
}

TEST_CASE("What slides off the last tile tips over its corner") {
  Scene scene = gliding(box_shape(0.8, 0.5), 0.25, tiles(), 0.2);
  scene.bodies[0].position = {30.8, 0.25};
  scene.bodies[0].velocity = {1, 0};
  const auto simulation = simulate(scene);
  run(*simulation, 1);
  CHECK(simulation->body(BodyId{1}).angle < -0.1);
}

TEST_CASE("What falls on a seam rests there") {
  for (const auto& ground : {tiles(), chain()}) {
    for (const ShapeDef& shape : {disc_shape(0.2), box_shape(0.4, 0.4), block({-0.2, -0.2}, {0.3, 0.2})}) {
      Scene scene = gliding(shape, 5, ground, 0.5);
      scene.bodies[0].position.x = 5;
      scene.bodies[0].velocity = {0, -6};
      const auto simulation = simulate(scene);
      run(*simulation, 4);
      CHECK(simulation->body(BodyId{1}).position.y == Approx(0.2).margin(0.005));
    }
  }
}

TEST_CASE("A disc in the inner corner of an angled body touches both arms") {
  Scene scene;
  BodyDef corner;
  corner.type = BodyType::fixed;
  corner.shapes = {block({0, -1}, {3, 0}), block({-1, -1}, {0, 3})};
  scene.bodies = {corner, body_with(disc_shape(0.5), {0.5, 0.5})};
  scene.gravity = {-5, -5};
  const auto simulation = simulate(scene);
  run(*simulation, 1);
  CHECK(simulation->contacts().size() == 2);
  CHECK(simulation->body(BodyId{2}).position.x == Approx(0.5).margin(0.005));
  CHECK(simulation->body(BodyId{2}).position.y == Approx(0.5).margin(0.005));
}

TEST_CASE("What is pushed into the corner of two overlapping walls stays out") {
  for (const ShapeDef& shape : {disc_shape(0.1), box_shape(0.2, 0.2), box_shape(0.05, 0.4)}) {
    Scene scene;
    BodyDef corner;
    corner.type = BodyType::fixed;
    corner.shapes = {block({-1, -0.2}, {3, 0}), block({-0.2, -1}, {0, 3})};
    BodyDef grain = body_with(shape, {0.5, 0.5});
    grain.velocity = {-4, -4};
    grain.angle = 0.785;
    grain.spin = 2;
    scene.bodies = {corner, grain};
    scene.gravity = {-30, -30};
    const auto simulation = simulate(scene);
    for (int i = 0; i < 480; ++i) {
      simulation->step();
      const Vec2d at = simulation->body(BodyId{2}).position;
      REQUIRE(std::min(at.x, at.y) > 0.01);
    }
  }
}

TEST_CASE("Two long slabs with a narrow gap between them are not joined, and what is in the gap stays there") {
  Scene scene;
  scene.bodies = {body_with(disc_shape(0.01), {0, 0.02}),
                  body_with(block({-200, -1}, {200, 0}), {0, 0}, BodyType::fixed),
                  body_with(block({-200, 0.05}, {200, 1}), {0, 0}, BodyType::fixed)};
  const auto simulation = simulate(scene);
  run(*simulation, 2);
  CHECK(simulation->body(BodyId{1}).position.y == Approx(0.01).margin(1e-3));
}

TEST_CASE("A step that is small beside the slabs still stops what runs into it") {
  Scene scene;
  BodyDef ball = body_with(disc_shape(0.03), {-1, 0.03});
  ball.velocity = {2, 0};
  scene.bodies = {ball, body_with(block({-400, -1}, {0, 0}), {0, 0}, BodyType::fixed),
                  body_with(block({0, -1}, {400, 0.035}), {0, 0}, BodyType::fixed)};
  const auto simulation = simulate(scene);
  run(*simulation, 1);
  CHECK(simulation->body(BodyId{1}).position.x < 0);
}

TEST_CASE("A leg that ends flush in a table top does not catch what slides over the table") {
  Scene scene;
  BodyDef table;
  table.type = BodyType::fixed;
  table.shapes = {block({-10, -0.2}, {10, 0}), block({-0.1, -1}, {0.1, 0})};
  BodyDef box = body_with(box_shape(0.8, 0.5), {-3, 0.25});
  box.velocity = {6, 0};
  scene.bodies = {box, table};
  set_friction(scene, 0);
  const auto simulation = simulate(scene);
  run(*simulation, 1);
  CHECK(simulation->body(BodyId{1}).position.x == Approx(3).margin(1e-3));
}

TEST_CASE("Posts that hang under a thin floor do not catch what slides over it, and hold what comes from below") {
  Scene scene;
  BodyDef floor;
  floor.type = BodyType::fixed;
  floor.shapes = {segment_shape({-10, 0}, {10, 0}), segment_shape({0, 0}, {0, -2}), block({-2.05, -1}, {-1.95, 0})};
  BodyDef above = body_with(box_shape(0.4, 0.4), {-3, 0.2});
  above.velocity = {4, 0};
  BodyDef below = body_with(disc_shape(0.1), {1.5, -0.5});
  below.velocity = {-4, 0};
  below.gravity_scale = 0;
  scene.bodies = {above, floor, below};
  set_friction(scene, 0);
  const auto simulation = simulate(scene);
  run(*simulation, 1);
  CHECK(simulation->body(BodyId{1}).position.x == Approx(1).margin(1e-3));
  CHECK(simulation->body(BodyId{3}).position.x > 0.09);
}

TEST_CASE("Between two blocks side by side the common side is hidden and the top corner pushes only upwards") {
  const ShapeDef left = block({0, 0}, {1, 1});
  const Seam seam = seam_between(left, block({1, 0}, {2, 1}));
  const Hull hull = hull_of(left);
  CHECK(seam.hides(hull, 1, real(0.5)));
  CHECK_FALSE(seam.hides(hull, 2, real(0.5)));
  CHECK(seam.admits(hull, 2, {0, 1}));
  CHECK_FALSE(seam.admits(hull, 2, {1, 0}));
  CHECK_FALSE(seam.admits(hull, 2, {real(0.6), real(0.8)}));
  CHECK(seam.admits(hull, 3, {real(-0.6), real(0.8)}));
}

TEST_CASE("A neighbour that stands lower leaves the rest of the side exposed") {
  const ShapeDef tall = block({0, 0}, {1, 2});
  const Seam seam = seam_between(tall, block({1, 0}, {2, 1}));
  const Hull hull = hull_of(tall);
  CHECK(seam.hides(hull, 1, real(0.5)));
  CHECK_FALSE(seam.hides(hull, 1, real(1.5)));
  CHECK(seam.admits(hull, 2, {1, 0}));
}

TEST_CASE("Over the ridge of a chain all normals between the two segments push, and below it only their faces do") {
  const ShapeDef rising = segment_shape({-1, -1}, {0, 0});
  const Seam seam = seam_between(rising, segment_shape({0, 0}, {1, -1}));
  const Hull hull = hull_of(rising);
  CHECK(seam.admits(hull, 1, {0, 1}));
  CHECK(seam.admits(hull, 1, normalized(Vec2{-1, 1})));
  CHECK(seam.admits(hull, 1, normalized(Vec2{1, 1})));
  CHECK_FALSE(seam.admits(hull, 1, {1, 0}));
  CHECK_FALSE(seam.admits(hull, 1, {0, -1}));
  CHECK_FALSE(seam.admits(hull, 1, normalized(Vec2{1, -1})));
}

TEST_CASE("Shapes that only stand near each other hide nothing") {
  Seam seam;
  const Hull apart[] = {hull_of(block({1.01, 0}, {2, 1}))};
  CHECK_FALSE(find_seam(hull_of(block({0, 0}, {1, 1})), apart, seam));
  ShapeDef round = block({1, 0}, {2, 1});
  round.radius = 0.1;
  const Hull rounded[] = {hull_of(round)};
  CHECK_FALSE(find_seam(hull_of(block({0, 0}, {1, 1})), rounded, seam));
}
