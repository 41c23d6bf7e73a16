#include "engine/mass.h"

#include <catch2/catch.hpp>

#include "tests/engine/random.h"
#include "tests/engine/scenes.h"

using namespace proofreel;
using namespace proofreel::test;

namespace {
constexpr double pi = 3.14159265358979323846;
}

TEST_CASE("A disc weighs density pi r^2 and turns with half m r^2", "[mass]") {
  ShapeDef disc = disc_shape(0.3);
  disc.points = {{2, -1}};
  disc.density = 7;
  const MassProperties m = mass_of(disc);
  CHECK(m.mass == Approx(7 * pi * 0.09).epsilon(1e-14));
  CHECK(m.center == Vec2d{2, -1});
  CHECK(m.inertia == Approx(0.5 * m.mass * 0.09).epsilon(1e-14));
}

TEST_CASE("A box turns with m (w^2 + h^2) / 12, wherever its origin is", "[mass]") {
  ShapeDef box = box_shape(2, 0.5);
  for (Vec2d& p : box.points) p += Vec2d{1000, -2000};
  const MassProperties m = mass_of(box);
  CHECK(m.mass == Approx(1).epsilon(1e-14));
  CHECK(m.center.x == Approx(1000).epsilon(1e-14));
  CHECK(m.center.y == Approx(-2000).epsilon(1e-14));
  CHECK(m.inertia == Approx((4 + 0.25) / 12).epsilon(1e-12));
}

TEST_CASE("A capsule is a rectangle and two half discs", "[mass]") {
  const double l = 0.8;
  const double r = 0.125;
  ShapeDef capsule;
  capsule.points = {{-l / 2, 0}, {l / 2, 0}};
  capsule.radius = r;
  const MassProperties m = mass_of(capsule);
  const double rectangle = 2 * r * l;
  const double disc = pi * r * r;
  // A half disc's centre lies 4 r / (3 pi) beyond the flat side.
  const double half = 4 * r / (3 * pi);
  const double own = disc * r * r / 2 - disc * half * half;
  const double inertia = rectangle * (l * l + 4 * r * r) / 12 + own + disc * (l / 2 + half) * (l / 2 + half);
  CHECK(m.mass == Approx(rectangle + disc).epsilon(1e-14));
  CHECK(length(m.center) < 1e-15);
  CHECK(m.inertia == Approx(inertia).epsilon(1e-13));
}

TEST_CASE("A rounded square of vanishing core becomes a disc", "[mass]") {
  ShapeDef square = box_shape(1e-7, 1e-7);
  square.radius = 1;
  const MassProperties m = mass_of(square);
  CHECK(m.mass == Approx(pi).epsilon(1e-6));
  CHECK(m.inertia == Approx(pi / 2).epsilon(1e-6));
}

TEST_CASE("A rounded polygon's mass agrees with counting random points in it", "[mass]") {
  ShapeDef shape;
  shape.points = {{0, 0}, {2, 0.2}, {1.5, 1.4}, {0.2, 1}};
  shape.radius = 0.3;
  const MassProperties m = mass_of(shape);
  Random random(5);
  const int n = 400000;
  double inside = 0;
  Vec2d sum;
  double second = 0;
  for (int i = 0; i < n; ++i) {
    const Vec2d p{random.between(-0.5, 2.5), random.between(-0.5, 2.0)};
    double outside = -1e9;  // distance to the core: all edges' half planes, then the nearest corner or edge
    bool in_core = true;
    double nearest = 1e9;
    for (std::size_t k = 0; k < 4; ++k) {
      const Vec2d a = shape.points[k];
      const Vec2d b = shape.points[(k + 1) % 4];
      in_core &= cross(b - a, p - a) >= 0;
      const double t = std::clamp(dot(p - a, b - a) / dot(b - a, b - a), 0.0, 1.0);
      nearest = std::min(nearest, distance(p, lerp(a, b, t)));
    }
    outside = in_core ? 0 : nearest;
    if (outside > shape.radius) continue;
    inside += 1;
    sum += p;
    second += length_squared(p - m.center);
  }
  const double cell = 3.0 * 2.5 / n;
  CHECK(m.mass == Approx(inside * cell).epsilon(0.005));
  CHECK(m.center.x == Approx(sum.x / inside).epsilon(0.005));
  CHECK(m.center.y == Approx(sum.y / inside).epsilon(0.005));
  CHECK(m.inertia == Approx(second * cell).epsilon(0.01));
}

TEST_CASE("A given mass scales the inertia, a given inertia replaces it", "[mass]") {
  BodyDef body = body_with(box_shape(1, 1), {0, 0});
  const double plain = mass_of(body).inertia;
  body.mass = 3;
  CHECK(mass_of(body).mass == 3);
  CHECK(mass_of(body).inertia == Approx(3 * plain));
  body.inertia = 0.7;
  CHECK(mass_of(body).inertia == 0.7);
}

TEST_CASE("A dumbbell of two discs obeys the parallel-axis theorem", "[mass]") {
  BodyDef body = body_with(disc_shape(0.1), {0, 0});
  body.shapes.push_back(disc_shape(0.1));
  body.shapes[0].points = {{-1, 0}};
  body.shapes[1].points = {{3, 0}};
  body.shapes[1].density = 3;
  const MassProperties m = mass_of(body);
  const double light = pi * 0.01;
  CHECK(m.mass == Approx(4 * light));
  CHECK(m.center.x == Approx(2));
  CHECK(m.inertia == Approx(0.5 * 4 * light * 0.01 + light * 9 + 3 * light * 1));
}

TEST_CASE("A bare segment weighs what it is given, spread evenly along it", "[mass]") {
  ShapeDef segment;
  segment.points = {{0, 0}, {3, 0}};
  BodyDef body = body_with(segment, {0, 0});
  body.mass = 2;
  const MassProperties m = mass_of(body);
  CHECK(m.center.x == Approx(1.5));
  CHECK(m.inertia == Approx(2 * 9 / 12.0));
}

TEST_CASE("Only dynamic bodies have mass", "[mass]") {
  CHECK(mass_of(body_with(box_shape(1, 1), {0, 0}, BodyType::fixed)).mass == 0);
  CHECK(mass_of(body_with(box_shape(1, 1), {0, 0}, BodyType::kinematic)).inertia == 0);
}
