#include "engine/collide.h"

#include <catch2/catch.hpp>

#include "engine/polygon.h"
#include "tests/engine/random.h"
#include "tests/engine/scenes.h"

using namespace proofreel;
using namespace proofreel::test;

namespace {

/// A random hull of 1 to 8 corners, rounded half of the time (discs always).
ShapeDef random_shape(Random& random) {
  ShapeDef shape;
  const int corners = 1 + static_cast<int>(random.below(8));
  while (static_cast<int>(shape.points.size()) < std::min(corners, 3)) {
    shape.points.clear();
    for (int i = 0; i < corners; ++i) shape.points.push_back({random.between(-1, 1), random.between(-1, 1)});
    shape.points = convex_hull(shape.points);
  }
  shape.radius = corners == 1 || random.below(2) == 1 ? random.between(0.05, 0.5) : 0;
  if (corners == 2 && shape.radius == 0) shape.radius = 0.1;
  return shape;
}

std::vector<Vec2d> placed(const ShapeDef& shape, Vec2d position, double angle) {
  std::vector<Vec2d> points;
  for (const Vec2d p : shape.points) points.push_back(position + rotate(Rotd(angle), p));
  return points;
}

double distance_to_segment(Vec2d p, Vec2d a, Vec2d b) {
  const double l2 = dot(b - a, b - a);
  const double t = l2 > 0 ? std::clamp(dot(p - a, b - a) / l2, 0.0, 1.0) : 0.0;
  return distance(p, lerp(a, b, t));
}

/// The largest gap along any direction that could separate two cores: brute force over all edge normals. Positive when
/// apart.
double separation_along_normals(const std::vector<Vec2d>& a, const std::vector<Vec2d>& b) {
  double best = -1e300;
  const auto try_edges = [&](const std::vector<Vec2d>& p, const std::vector<Vec2d>& q) {
    for (std::size_t i = 0; p.size() > 1 && i < p.size(); ++i) {
      const Vec2d n = -perp(normalized(p[(i + 1) % p.size()] - p[i]));
      double nearest = 1e300;
      for (const Vec2d x : q) nearest = std::min(nearest, dot(n, x - p[i]));
      best = std::max(best, nearest);
    }
  };
  try_edges(a, b);
  try_edges(b, a);
  return best;
}

/// The distance of two cores by trying every corner against every edge; they must be apart.
double distance_by_brute_force(const std::vector<Vec2d>& a, const std::vector<Vec2d>& b) {
  double nearest = 1e300;
  for (std::size_t i = 0; i < a.size(); ++i) {
    for (std::size_t j = 0; j < b.size(); ++j) {
      nearest = std::min(nearest, distance_to_segment(a[i], b[j], b[(j + 1) % b.size()]));
      nearest = std::min(nearest, distance_to_segment(b[j], a[i], a[(i + 1) % a.size()]));
    }
  }
  return nearest;
}

bool cross_each_other(const std::vector<Vec2d>& a, const std::vector<Vec2d>& b) {
  for (std::size_t i = 0; i < a.size(); ++i) {
    for (std::size_t j = 0; j < b.size(); ++j) {
      const Vec2d a1 = a[i], a2 = a[(i + 1) % a.size()], b1 = b[j], b2 = b[(j + 1) % b.size()];
      if (orientation(a1, a2, b1) * orientation(a1, a2, b2) < 0 &&
          orientation(b1, b2, a1) * orientation(b1, b2, a2) < 0) {
        return true;
      }
    }
  }
  return false;
}

bool inside(Vec2d p, const std::vector<Vec2d>& polygon) {
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    if (orientation(polygon[i], polygon[(i + 1) % polygon.size()], p) < 0) return false;
  }
  return true;
}

struct Placed {
  ShapeDef shape;
  Vec2d position;
  double angle = 0;
};

Manifold collide_placed(const Placed& a, const Placed& b, double margin) {
  return collide(make_hull(a.shape, {}), {Vec2(a.position), Rot(Rotd(a.angle))}, make_hull(b.shape, {}),
                 {Vec2(b.position), Rot(Rotd(b.angle))}, static_cast<real>(margin));
}

Placed random_placed(Random& random, double spread) {
  return {
      random_shape(random), {random.between(-spread, spread), random.between(-spread, spread)}, random.between(-4, 4)};
}

}  // namespace

TEST_CASE("The separation of shapes that are apart is their true distance", "[collide]") {
  Random random(11);
  // Which of two almost parallel faces is the reference may differ, which costs up to a millionth of the thickness.
  const double tolerance = pick(2e-6, 5e-5);
  int seen = 0;
  for (int i = 0; i < 60000; ++i) {
    const Placed a = random_placed(random, 1.5);
    const Placed b = random_placed(random, 1.5);
    const auto pa = placed(a.shape, a.position, a.angle);
    const auto pb = placed(b.shape, b.position, b.angle);
    const bool apart = !cross_each_other(pa, pb) && distance_by_brute_force(pa, pb) > 0.01 &&
                       (pa.size() < 3 || !inside(pb[0], pa)) && (pb.size() < 3 || !inside(pa[0], pb));
    if (!apart) continue;
    ++seen;
    const double truth = distance_by_brute_force(pa, pb) - a.shape.radius - b.shape.radius;
    const Manifold m = collide_placed(a, b, 10);
    REQUIRE(m.count > 0);
    INFO("pair " << i << ", corners " << pa.size() << " and " << pb.size());
    REQUIRE(deepest(m) == Approx(truth).margin(tolerance));
  }
  CHECK(seen > 20000);
}

TEST_CASE("Overlapping polygons are separated along the axis of least penetration", "[collide]") {
  Random random(12);
  int seen = 0;
  for (int i = 0; i < 60000; ++i) {
    const Placed a = random_placed(random, 0.7);
    const Placed b = random_placed(random, 0.7);
    if (a.shape.points.size() < 3 || b.shape.points.size() < 3) continue;
    const double truth =
        separation_along_normals(placed(a.shape, a.position, a.angle), placed(b.shape, b.position, b.angle));
    if (truth > -0.01) continue;
    ++seen;
    const Manifold m = collide_placed(a, b, 0.001);
    REQUIRE(m.count > 0);
    REQUIRE(deepest(m) == Approx(truth - a.shape.radius - b.shape.radius).margin(3e-4));
    // Moving b out along the normal by that much parts them.
    Placed parted = b;
    parted.position += (1e-3 - truth) * Vec2d(m.normal);
    REQUIRE(separation_along_normals(placed(a.shape, a.position, a.angle),
                                     placed(parted.shape, parted.position, parted.angle)) > 0);
  }
  CHECK(seen > 5000);
}

TEST_CASE("A manifold does not depend on where in the world it is", "[collide]") {
  const Placed a{box_shape(1, 1), {0, 0}, 0.3};
  const Placed b{box_shape(1, 2), {0.7, 0.9}, -0.2};
  const Manifold here = collide_placed(a, b, 0.1);
  Placed far_a = a;
  Placed far_b = b;
  far_a.position += Vec2d{65536, -131072};  // powers of two, so that the sum itself loses only what float must lose
  far_b.position += Vec2d{65536, -131072};
  const Manifold there = collide_placed(far_a, far_b, 0.1);
  REQUIRE(here.count == 2);
  REQUIRE(there.count == 2);
  for (int i = 0; i < 2; ++i) {
    CHECK(there.points[i].separation == Approx(here.points[i].separation).margin(pick(1e-10, 0.02)));
    CHECK(there.points[i].feature == here.points[i].feature);
  }
}

TEST_CASE("Discs with the same centre overlap by the sum of their radii, straight up", "[collide]") {
  const Manifold m = collide_placed({disc_shape(0.5), {1, 1}, 0}, {disc_shape(0.25), {1, 1}, 0}, 0);
  REQUIRE(m.count == 1);
  CHECK(m.points[0].separation == Approx(-0.75));
  CHECK(m.normal == Vec2{0, 1});
}

TEST_CASE("A disc whose centre is inside a box leaves through the nearest face", "[collide]") {
  const Manifold m = collide_placed({box_shape(4, 2), {0, 0}, 0}, {disc_shape(0.25), {1.5, 0.2}, 0}, 0);
  REQUIRE(m.count == 1);
  CHECK(m.normal.x == Approx(1));
  CHECK(m.points[0].separation == Approx(-0.5 - 0.25));
}

TEST_CASE("A disc at a box's corner is pushed along the line to the corner", "[collide]") {
  const Manifold m = collide_placed({box_shape(2, 2), {0, 0}, 0}, {disc_shape(0.5), {1.3, 1.3}, 0}, 0.1);
  REQUIRE(m.count == 1);
  CHECK(m.normal.x == Approx(m.normal.y));
  CHECK(m.points[0].separation == Approx(std::sqrt(0.18) - 0.5).margin(1e-6));
}

TEST_CASE("A box that lies on another touches it in two points", "[collide]") {
  const Manifold m = collide_placed({box_shape(4, 1), {0, 0}, 0}, {box_shape(1, 1), {0.5, 0.99}, 0}, 0.01);
  REQUIRE(m.count == 2);
  CHECK(m.normal.y == Approx(1));
  CHECK(std::abs(m.points[0].point.x - m.points[1].point.x) == Approx(1));
  CHECK(m.points[0].separation == Approx(-0.01).margin(1e-6));
  CHECK(m.points[0].feature != m.points[1].feature);
}

TEST_CASE("Capsules end to end touch in one point between their ends", "[collide]") {
  ShapeDef capsule;
  capsule.points = {{-0.5, 0}, {0.5, 0}};
  capsule.radius = 0.1;
  const Manifold m = collide_placed({capsule, {0, 0}, 0}, {capsule, {1.15, 0}, 0}, 0.1);
  REQUIRE(m.count == 1);
  CHECK(m.normal.x == Approx(1));
  CHECK(m.points[0].separation == Approx(-0.05).margin(1e-6));
  CHECK(m.points[0].point.x == Approx(0.575));
}

TEST_CASE("Crossing capsules are separated across the shorter way", "[collide]") {
  ShapeDef long_one;
  long_one.points = {{-2, 0}, {2, 0}};
  long_one.radius = 0.1;
  ShapeDef short_one;
  short_one.points = {{0, -0.3}, {0, 1}};
  short_one.radius = 0.1;
  const Manifold m = collide_placed({long_one, {0, 0}, 0}, {short_one, {0, 0}, 0}, 0.01);
  REQUIRE(m.count >= 1);
  CHECK(m.normal.y == Approx(1));
  CHECK(deepest(m) == Approx(-0.3 - 0.2).margin(1e-6));
}

TEST_CASE("Features stay the same under small motion", "[collide]") {
  const Placed a{box_shape(4, 1), {0, 0}, 0};
  const Manifold before = collide_placed(a, {box_shape(1, 1), {0.5, 0.999}, 0}, 0.02);
  for (const double tilt : {-1e-4, 1e-4}) {
    const Manifold after = collide_placed(a, {box_shape(1, 1), {0.501, 1.0}, tilt}, 0.02);
    REQUIRE(after.count == before.count);
    for (int i = 0; i < after.count; ++i) CHECK(after.points[i].feature == before.points[i].feature);
  }
}

TEST_CASE("Shapes farther apart than the margin make no manifold", "[collide]") {
  CHECK(collide_placed({disc_shape(1), {0, 0}, 0}, {disc_shape(1), {2.2, 0}, 0}, 0.1).count == 0);
  CHECK(collide_placed({box_shape(1, 1), {0, 0}, 0}, {box_shape(1, 1), {1.2, 0}, 0}, 0.1).count == 0);
}

// Shapes at the edge of what there is, each with its stated outcome.

namespace {

ShapeDef polygon_shape(std::vector<Vec2d> points) {
  ShapeDef shape;
  shape.points = std::move(points);
  return shape;
}

ShapeDef capsule_shape(double half_length, double radius) {
  ShapeDef shape = polygon_shape({{-half_length, 0}, {half_length, 0}});
  shape.radius = radius;
  return shape;
}

ShapeDef regular_shape(int corners) {
  ShapeDef shape;
  for (int i = 0; i < corners; ++i) shape.points.push_back(rotate(Rotd(2 * 3.14159265358979 * i / corners), {1, 0}));
  return shape;
}

void check_manifold(const Manifold& m, int count, Vec2d normal, double separation) {
  REQUIRE(m.count == count);
  CHECK(static_cast<double>(m.normal.x) == Approx(normal.x).margin(1e-4));
  CHECK(static_cast<double>(m.normal.y) == Approx(normal.y).margin(1e-4));
  CHECK(static_cast<double>(deepest(m)) == Approx(separation).margin(pick(1e-12, 1e-6)));
}

}  // namespace

TEST_CASE("A disc leaves a box through the region its centre is in", "[collide]") {
  const Placed box{box_shape(2, 2), {0, 0}, 0};
  const double d = std::sqrt(0.5);
  const auto with = [&](Vec2d centre) { return collide_placed(box, {disc_shape(0.5), centre, 0}, 1); };
  for (const double side : {-1.0, 1.0}) {
    check_manifold(with({side * 1.2, 0.3}), 1, {side, 0}, -0.3);  // in front of a face
    check_manifold(with({0.3, side * 1.2}), 1, {0, side}, -0.3);  // in front of another
    check_manifold(with({side * 0.9, 0.3}), 1, {side, 0}, -0.6);  // inside
    check_manifold(with({side, 0.3}), 1, {side, 0}, -0.5);        // on the edge
    check_manifold(with({side * 1.2, 1.2}), 1, {side * d, d}, 0.2 * std::sqrt(2.0) - 0.5);
    check_manifold(with({side * 1.2, -1.2}), 1, {side * d, -d}, 0.2 * std::sqrt(2.0) - 0.5);
    CHECK(static_cast<double>(deepest(with({side, 1}))) == Approx(-0.5));  // on the corner, by either of its faces
  }
}

TEST_CASE("A disc on a capsule's axis leaves it sideways, at its end along the axis", "[collide]") {
  const Placed capsule{capsule_shape(1, 0.25), {0, 0}, 0};
  check_manifold(collide_placed(capsule, {disc_shape(0.5), {0.2, 0}, 0}, 0), 1, {0, -1}, -0.75);
  check_manifold(collide_placed(capsule, {disc_shape(0.5), {1.5, 0}, 0}, 0), 1, {1, 0}, -0.25);
}

TEST_CASE("Coincident shapes are parted by their least width", "[collide]") {
  CHECK(deepest(collide_placed({box_shape(2, 1), {0, 0}, 0.3}, {box_shape(2, 1), {0, 0}, 0.3}, 0)) ==
        Approx(-1).margin(1e-5));
  CHECK(deepest(collide_placed({capsule_shape(1, 0.2), {0, 0}, 0.3}, {capsule_shape(1, 0.2), {0, 0}, 0.3}, 0)) ==
        Approx(-0.4).margin(1e-5));
}

TEST_CASE("A shape that is all inside another leaves through the nearest face", "[collide]") {
  check_manifold(collide_placed({box_shape(10, 10), {0, 0}, 0}, {box_shape(1, 1), {4, 1}, 0}, 0), 2, {1, 0}, -1.5);
  check_manifold(collide_placed({box_shape(1, 1), {4, 1}, 0}, {box_shape(10, 10), {0, 0}, 0}, 0), 2, {-1, 0}, -1.5);
}

TEST_CASE("A sliver of 0.2 mm in a metre touches along its length", "[collide]") {
  const Placed sliver{box_shape(1, 0.0002), {0, 0.50005}, 0};
  check_manifold(collide_placed({box_shape(4, 1), {0, 0}, 0}, sliver, 0), 2, {0, 1}, -0.00005);
}

TEST_CASE("A needle's tip touches in one place and its side in two", "[collide]") {
  const ShapeDef needle = polygon_shape({{0, 0}, {0.001, 1}, {-0.001, 1}});
  const Manifold tip = collide_placed({box_shape(4, 1), {0, 0}, 0}, {needle, {0, 0.499}, 0}, 0);
  REQUIRE(tip.count >= 1);
  CHECK(static_cast<double>(deepest(tip)) == Approx(-0.001).margin(1e-6));
  const Placed lying{polygon_shape({{0, 0}, {1, -0.001}, {1, 0.001}}), {-0.5, 0.5005}, 0};
  check_manifold(collide_placed({box_shape(4, 1), {0, 0}, 0}, lying, 0.01), 2, {0, 1}, -0.0005);
}

TEST_CASE("Faces that are almost parallel touch in both ends", "[collide]") {
  for (const double tilt : {-1e-7, 0.0, 1e-7}) {
    const Manifold m = collide_placed({box_shape(4, 1), {0, 0}, 0}, {box_shape(1, 1), {0, 0.999}, tilt}, 0);
    REQUIRE(m.count == 2);
    CHECK(m.points[0].separation == Approx(-0.001).margin(1e-6));
    CHECK(m.points[1].separation == Approx(-0.001).margin(1e-6));
  }
}

TEST_CASE("Polygons of 3 to 16 corners rest on a face like any other", "[collide]") {
  for (int corners = 3; corners <= 16; ++corners) {
    const ShapeDef shape = regular_shape(corners);
    const double half = 3.14159265358979 / corners;
    const double apothem = elementary::cos(half);
    const double angle = -0.5 * 3.14159265358979 - half;  // turns the first face down
    INFO(corners << " corners");
    const Placed resting{shape, {0, 0.5 + apothem - 0.001}, angle};
    check_manifold(collide_placed({box_shape(8, 1), {0, 0}, 0}, resting, 0), 2, {0, 1}, -0.001);
  }
}

TEST_CASE("Boxes that touch at a corner touch there", "[collide]") {
  const Manifold m = collide_placed({box_shape(2, 2), {0, 0}, 0}, {box_shape(2, 2), {2, 2}, 0}, 0.01);
  REQUIRE(m.count >= 1);
  CHECK(std::abs(deepest(m)) < pick(1e-12, 1e-6));
  CHECK(static_cast<double>(m.points[0].point.x) == Approx(1).margin(0.01));
  CHECK(static_cast<double>(m.points[0].point.y) == Approx(1).margin(0.01));
}

TEST_CASE("Bare segments that are parallel or on one line have a finite manifold", "[collide]") {
  const Placed line{capsule_shape(1, 0), {0, 0}, 0};
  check_manifold(collide_placed(line, {capsule_shape(1, 0), {0.5, 0.25}, 0}, 1), 2, {0, 1}, 0.25);
  check_manifold(collide_placed(line, {capsule_shape(1, 0), {2.5, 0}, 0}, 1), 1, {1, 0}, 0.5);
  CHECK(std::abs(deepest(collide_placed(line, {capsule_shape(1, 0), {0.5, 0}, 0}, 1))) < real(1e-6));
}

TEST_CASE("A disc over an almost straight corner is as far away as the face it is beside") {
  for (const double bend : {1e-7, 1e-5, 1e-3, 1e-1}) {
    ShapeDef roof;
    roof.points = {{-1, -1}, {1, -1}, {1, -bend}, {0, 0}, {-1, -bend}};
    ShapeDef ball;
    ball.points = {{0, 0}};
    ball.radius = 0.1;
    const Hull a = make_hull(roof, {0, 0});
    const Hull b = make_hull(ball, {0, 0});
    for (int i = -20; i <= 20; ++i) {
      const double x = 0.045 * i;
      const double below = std::abs(x) * bend;
      const double truth = (0.2 + below) / std::sqrt(1 + bend * bend) - 0.1;
      const Manifold m = collide(a, Pose{}, b, Pose{Vec2(Vec2d{x, 0.2}), Rot{}}, real(1));
      INFO("bend " << bend << ", x = " << x);
      REQUIRE(m.count == 1);
      // Right over the corner it is nearest to the corner itself.
      const double corner = std::sqrt(x * x + 0.04) - 0.1;
      const bool beside = std::abs(x) >= 0.2 * bend;
      CHECK(static_cast<double>(m.points[0].separation) == Approx(beside ? truth : corner).margin(pick(1e-12, 1e-5)));
    }
  }
}

TEST_CASE("A box that slides and rocks on a bare segment keeps its features", "[collide]") {
  const Placed line{capsule_shape(5, 0), {0, 0}, 0};
  const Placed slab{box_shape(10, 1), {0, -0.5}, 0};
  for (const Placed& below : {line, slab}) {
    const Manifold first = collide_placed(below, {box_shape(1, 1), {0, 0.5}, 0}, 0.1);
    REQUIRE(first.count == 2);
    for (int i = -100; i <= 100; ++i) {
      const Placed box{box_shape(1, 1), {0.03 * i, 0.5 + 1e-6 * (i % 3)}, 1e-4 * (i % 7)};
      const Manifold m = collide_placed(below, box, 0.1);
      REQUIRE(m.count == 2);
      CHECK(m.points[0].feature == first.points[0].feature);
      CHECK(m.points[1].feature == first.points[1].feature);
    }
  }
}
