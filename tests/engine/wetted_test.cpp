#include "engine/wetted.h"

#include <catch2/catch.hpp>

#include "engine/elementary.h"
#include "engine/mass.h"
#include "tests/engine/scenes.h"

using namespace proofreel;
using namespace proofreel::test;

namespace {

constexpr double pi = 3.14159265358979323846;

ShapeDef rounded(ShapeDef shape, double radius) {
  shape.radius = radius;
  return shape;
}

ShapeDef capsule_shape() {
  ShapeDef shape;
  shape.points = {{-0.7, 0.1}, {0.4, -0.2}};
  shape.radius = 0.35;
  return shape;
}

ShapeDef triangle_shape() {
  ShapeDef shape;
  shape.points = {{-0.6, -0.5}, {0.8, -0.3}, {0.1, 0.7}};
  return shape;
}

std::vector<ShapeDef> shapes() {
  return {disc_shape(0.8),
          box_shape(1.2, 0.5),
          triangle_shape(),
          capsule_shape(),
          rounded(box_shape(1, 0.4), 0.2),
          rounded(triangle_shape(), 0.3)};
}

Wetted wetted_of(const ShapeDef& shape, double angle, double level) {
  return wetted_part(make_hull(shape, {0, 0}), Rot(Rotd(angle)), level);
}

/// The distance of a point from the hull of the shape's points, 0 inside; for the slow and simple way.
double distance_to_core(const ShapeDef& shape, Vec2d p) {
  const std::size_t n = shape.points.size();
  double nearest = 1e30;
  bool inside = n > 2;
  for (std::size_t i = 0; i < n; ++i) {
    const Vec2d a = shape.points[i];
    const Vec2d edge = shape.points[(i + 1) % n] - a;
    const double t = n == 1 ? 0 : std::min(std::max(dot(p - a, edge) / dot(edge, edge), 0.0), 1.0);
    nearest = std::min(nearest, length(p - a - t * edge));
    inside = inside && cross(edge, p - a) > 0;
  }
  return inside ? 0 : nearest;
}

/// The same moments from a raster of small squares.
Wetted rastered(const ShapeDef& shape, double angle, double level) {
  constexpr double cell = 0.004;
  Wetted sum;
  for (double x = -1.5; x < 1.5; x += cell) {
    for (double y = -1.5; y < std::min(1.5, level); y += cell) {
      const Vec2d p{x, y};
      if (distance_to_core(shape, inverse_rotate(Rotd(angle), p)) > shape.radius) continue;
      sum += {cell * cell, cell * cell * p, cell * cell * dot(p, p)};
    }
  }
  return sum;
}

}  // namespace

TEST_CASE("A shape wholly under water is wetted all over, at any depth") {
  const double depth = GENERATE(0.0, 2.0, 1e3, 1e8);
  for (const ShapeDef& shape : shapes()) {
    const MassProperties whole = mass_of(shape);
    const Wetted wetted = wetted_of(shape, 0, 1.5 + depth);
    CHECK(wetted.area == Approx(whole.mass).epsilon(pick(1e-13, 1e-6)));
    CHECK(length(wetted.first - whole.mass * whole.center) < pick(1e-14, 1e-6));
    const double about_origin = whole.inertia + whole.mass * length_squared(whole.center);
    CHECK(wetted.second == Approx(about_origin).epsilon(pick(1e-13, 1e-6)));
  }
}

TEST_CASE("A shape wholly above water is dry, to the bit") {
  for (const ShapeDef& shape : shapes()) {
    const Wetted wetted = wetted_of(shape, 0.3, -2);
    CHECK(wetted.area == 0);
    CHECK(wetted.first == Vec2d{});
    CHECK(wetted.second == 0);
  }
}

TEST_CASE("The wetted part of a disc is the circular segment of the textbooks") {
  const double level = GENERATE(-0.79, -0.4, 0.0, 0.3, 0.75);
  const double r = 0.8;
  const double half = elementary::acos(-level / r);  // of the angle the chord is seen under
  const double sine = elementary::sin(half);
  const Wetted wetted = wetted_of(disc_shape(r), 0.7, level);
  CHECK(wetted.area == Approx(r * r * (half - sine * elementary::cos(half))).epsilon(pick(1e-12, 1e-5)));
  CHECK(wetted.first.x == 0);
  CHECK(wetted.first.y == Approx(-2.0 / 3 * r * r * r * sine * sine * sine).epsilon(pick(1e-12, 1e-5)));
}

TEST_CASE("The wetted part of a box that lies level is a rectangle") {
  const Wetted wetted = wetted_of(box_shape(1.2, 0.5), 0, 0.05);
  CHECK(wetted.area == Approx(1.2 * 0.3).epsilon(pick(1e-14, 1e-6)));
  CHECK(wetted.first.x == 0);
  CHECK(wetted.first.y == Approx(1.2 * 0.3 * -0.1).epsilon(pick(1e-13, 1e-6)));
  CHECK(wetted.second == Approx(1.2 * 0.3 * ((1.44 + 0.09) / 12 + 0.01)).epsilon(pick(1e-13, 1e-6)));
}

TEST_CASE("Every shape, turned and cut anywhere, is wetted as a raster of it says") {
  const double angle = GENERATE(0.0, 0.6, 2.5, -1.9);
  const double level = GENERATE(-0.35, 0.0, 0.2, 0.55);
  for (const ShapeDef& shape : shapes()) {
    const Wetted exact = wetted_of(shape, angle, level);
    const Wetted raster = rastered(shape, angle, level);
    INFO(shape.points.size() << " points, radius " << shape.radius);
    CHECK(exact.area == Approx(raster.area).margin(5e-3));
    CHECK(exact.first.x == Approx(raster.first.x).margin(4e-3));
    CHECK(exact.first.y == Approx(raster.first.y).margin(4e-3));
    CHECK(exact.second == Approx(raster.second).margin(4e-3));
  }
}

TEST_CASE("What is under water and what would be above it make up the whole shape") {
  for (const ShapeDef& shape : shapes()) {
    const double area = mass_of(shape).mass;
    const double below = wetted_of(shape, 0.8, 0.1).area;
    const double above = wetted_of(shape, 0.8 + pi, -0.1).area;  // the same line, seen upside down
    CHECK(below + above == Approx(area).epsilon(pick(1e-12, 1e-5)));
  }
}

TEST_CASE("A bare segment has no area to be wetted") {
  ShapeDef segment;
  segment.points = {{-1, -0.3}, {1, 0.4}};
  CHECK(wetted_of(segment, 0.2, 0.1).area == Approx(0).margin(pick(1e-16, 1e-7)));
}
