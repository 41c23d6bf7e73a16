/// Hulls with corners so straight that rounding cannot tell the faces on both sides apart: which of them is nearest,
/// and which corner lies farthest out, is a matter of the last digit. What two hulls touch in must not be. The truth is
/// that of every corner against every edge, in double precision, from the very numbers the engine was given.

#include <catch2/catch.hpp>

#include "engine/collide.h"
#include "engine/collide_gjk.h"
#include "tests/engine/hulls.h"

using namespace proofreel;
using namespace proofreel::test;

namespace {

#ifdef NDEBUG
constexpr int pairs_per_shape = 100000;
#else
constexpr int pairs_per_shape = 5000;
#endif

/// A box of a metre whose lower side is bent outwards a little, at one to three places.
ShapeDef bent_box(Random& random) {
  const double bend = std::pow(10.0, random.between(-8, -1));
  const int bends = 1 + static_cast<int>(random.below(3));
  ShapeDef shape;
  shape.points = {{-0.5, -0.5}};
  for (int i = 1; i <= bends; ++i) {
    const double x = (i + random.between(-0.4, 0.4)) / (bends + 1);
    shape.points.push_back({x - 0.5, -0.5 - bend * x * (1 - x)});
  }
  shape.points.insert(shape.points.end(), {{0.5, -0.5}, {0.5, 0.5}, {-0.5, 0.5}});
  return shape;
}

ShapeDef rounded(ShapeDef shape, double radius) {
  shape.radius = radius;
  return shape;
}

ShapeDef needle(Random& random) { return polygon_shape({{0, 0}, {random.between(0.05, 0.5), 1}, {-0.05, 1}}); }
ShapeDef any_polygon(Random& random) { return random_shape(random, Kind::polygon); }
ShapeDef rounded_bent_box(Random& random) { return rounded(bent_box(random), random.between(0.05, 0.5)); }
ShapeDef segment(Random& random) { return polygon_shape({{-random.between(0.1, 1), 0}, {random.between(0.1, 1), 0}}); }
ShapeDef capsule(Random& random) { return rounded(segment(random), random.between(0.05, 0.5)); }
ShapeDef disc(Random& random) { return disc_shape(random.between(0.05, 0.5)); }

struct Other {
  const char* name;
  ShapeDef (*make)(Random&);
};

const Other others[] = {
    {"needle", needle},   {"polygon", any_polygon}, {"bent box", bent_box}, {"rounded bent box", rounded_bent_box},
    {"segment", segment}, {"capsule", capsule},     {"disc", disc}};

/// A bent box in any pose, and below its bent side something else, often turned so that it lies against it.
struct Pair {
  PlacedHull bent;
  PlacedHull other;
};

Pair random_pair(Random& random, const Other& other) {
  const Posed bent{{random.between(-1, 1), random.between(-1, 1)}, Rotd(random.between(-4, 4))};
  const Vec2d below{random.between(-0.6, 0.6), -0.5 - random.between(-0.3, 1)};
  const double angle = random.below(2) == 0 ? random.between(-4, 4) : random.between(-1e-4, 1e-4);
  const Hull hull = make_hull(random.below(2) == 0 ? bent_box(random) : rounded_bent_box(random), {});
  return {{hull, Pose(bent)},
          {make_hull(other.make(random), {}), Pose(Posed{to_world(bent, below), bent.rotation * Rotd(angle)})}};
}

using Collide = Manifold (*)(const Hull&, const Pose&, const Hull&, const Pose&, real, NoObserver);

/// How much too near or too far apart the manifold has the shapes. Of faces as good to 1e-4 of the thinner shape any
/// may be taken.
double error_of(const Manifold& m, const PlacedHull& a, const PlacedHull& b) {
  const Corners core_a(a, a.pose.position);
  const Corners core_b(b, a.pose.position);
  const double apart = distance_by_force(core_a, core_b);
  const double truth = (apart > 0 ? apart : separation_by_force(core_a, core_b)) - static_cast<double>(a.hull.radius) -
                       static_cast<double>(b.hull.radius);
  const double tie = (apart > 0 ? 1e-6 : 1e-4) * static_cast<double>(std::min(a.hull.detail, b.hull.detail));
  return std::max(std::abs(static_cast<double>(deepest(m)) - truth) - tie, 0.0);
}

void check_others(Collide collide_by) {
  for (const Other& other : others) {
    Random random(7);
    Worst worst;
    for (int i = 0; i < pairs_per_shape; ++i) {
      const auto [bent, beside] = random_pair(random, other);
      worst.see(error_of(collide_by(bent.hull, bent.pose, beside.hull, beside.pose, 9, {}), bent, beside), i);
      worst.see(error_of(collide_by(beside.hull, beside.pose, bent.hull, bent.pose, 9, {}), beside, bent), i);
    }
    INFO(other.name << ", pair " << worst.pair);
    CHECK(worst.error < pick(1e-12, 1e-5));
  }
}

}  // namespace

TEST_CASE("Beside an almost straight corner the separation is the true one, to rounding", "[collide]") {
  check_others(collide<NoObserver>);
}

TEST_CASE("Beside an almost straight corner GJK with EPA finds the true separation, to rounding", "[collide_gjk]") {
  check_others(collide_gjk<NoObserver>);
}
