#include "engine/time_of_impact.h"

#include <catch2/catch.hpp>

#include "tests/engine/hulls.h"

using namespace proofreel;
using namespace proofreel::test;

namespace {

constexpr real target = real(0.005);
constexpr real tolerance = real(0.00125);
const double rounding = pick(1e-11, 2e-4);

struct Moving {
  Hull hull;
  Sweep sweep;

  Moving(const ShapeDef& shape, Vec2d from, Vec2d displacement, double angle = 0, double turn = 0)
      : hull(make_hull(shape, {})),
        sweep{{Vec2(from), Rot(Rotd(angle))}, Vec2(displacement), static_cast<real>(turn)} {}
  Moving(const PlacedHull& placed, Vec2d displacement, double turn)
      : hull(placed.hull), sweep{placed.pose, Vec2(displacement), static_cast<real>(turn)} {}
  PlacedHull at(real fraction) const { return {hull, pose_at(sweep, fraction)}; }
};

TimeOfImpact meet(const Moving& a, const Moving& b) {
  return time_of_impact(a.hull, a.sweep, b.hull, b.sweep, target, tolerance);
}

double separation_at(const Moving& a, const Moving& b, real fraction) {
  const PlacedHull pa = a.at(fraction);
  const PlacedHull pb = b.at(fraction);
  return static_cast<double>(distance(pa.hull, pa.pose, pb.hull, pb.pose).separation);
}

/// The least separation at that many moments up to `end`.
double least_separation(const Moving& a, const Moving& b, real end, int moments) {
  double least = 1e300;
  for (int k = 0; k <= moments; ++k) {
    least = std::min(least, separation_at(a, b, end * static_cast<real>(k) / static_cast<real>(moments)));
  }
  return least;
}

Moving random_moving(HullPool& pool, Kind kind, double spread, double way, double turn) {
  const PlacedHull placed = pool.draw(kind, spread);
  Random& random = pool.random();
  return {placed, {random.between(-way, way), random.between(-way, way)}, random.between(-turn, turn)};
}

struct Sweeps {
  int count;
  int moments;
  double way;
  double turn;
};

}  // namespace

TEST_CASE("No sampled moment before a time of impact is nearer than the target", "[time_of_impact]") {
  HullPool pool(61);
  for (const Sweeps& sweeps : {Sweeps{pairs_per_kind / 10, 30, 3, 0.5}, Sweeps{pairs_per_kind / 20, 100, 4, 6},
                               Sweeps{pairs_per_kind / 500, 1000, 1, 60}, Sweeps{pairs_per_kind / 20, 20, 5, 0}}) {
    Worst through;
    Worst off_target;
    int hits = 0;
    int unfinished = 0;
    for (int i = 0; i < sweeps.count; ++i) {
      const KindPair kinds = kind_pairs[static_cast<std::size_t>(i) % kind_pairs.size()];
      const Moving a = random_moving(pool, kinds.a, 2, sweeps.way, sweeps.turn);
      const Moving b = random_moving(pool, kinds.b, 2, sweeps.way, sweeps.turn);
      const TimeOfImpact r = meet(a, b);
      unfinished += r.state == ImpactState::unfinished ? 1 : 0;
      if (r.state == ImpactState::touching_at_start) {
        off_target.see(separation_at(a, b, 0) - static_cast<double>(target + tolerance), i);
        continue;
      }
      through.see(static_cast<double>(target) - least_separation(a, b, r.fraction, sweeps.moments), i);
      if (r.state != ImpactState::hit) continue;
      ++hits;
      const double there = separation_at(a, b, r.fraction);
      off_target.see(std::abs(there - static_cast<double>(r.separation)), i);
      off_target.see(there - static_cast<double>(target + tolerance), i);
    }
    INFO("way " << sweeps.way << ", turn " << sweeps.turn << ", pair " << through.pair << " and " << off_target.pair);
    CHECK(through.error < rounding);
    CHECK(off_target.error < rounding);
    CHECK(unfinished == 0);
    CHECK(hits > sweeps.count / 20);
  }
}

TEST_CASE("A straight flight ends at the same place as a cast of it", "[time_of_impact]") {
  const Moving wall(box_shape(1, 10), {5, 0}, {});
  const Moving ball(disc_shape(0.5), {0, 0}, {8, 0});
  const TimeOfImpact r = meet(ball, wall);
  REQUIRE(r.state == ImpactState::hit);
  CHECK(8 * r.fraction == Approx(4 - 0.005).margin(0.0013));
  CHECK(r.separation <= target + tolerance);
  CHECK(r.iterations <= 3);
}

TEST_CASE("A bullet of 200 m/s does not pass a wall of 0.1 m, nor ten thousand kilometres away", "[time_of_impact]") {
  std::vector<double> places{0, 1000};
  if (is_double) places.push_back(1e7);
  for (const double x : places) {
    const Moving wall(box_shape(0.1, 4), {x, 0}, {});
    for (int i = 0; i < 100; ++i) {
      const Moving bullet(disc_shape(0.1), {x - 0.2 - 0.03 * i, 0.01 * i}, {200.0 / 60, 0});
      const TimeOfImpact r = meet(bullet, wall);
      REQUIRE(r.state == (0.2 + 0.03 * i - 0.15 < 200.0 / 60 ? ImpactState::hit : ImpactState::separated));
      if (r.state == ImpactState::hit) {
        CHECK(separation_at(bullet, wall, r.fraction) ==
              Approx(0.005).margin(0.0013 + pick(1e-8, 1e-4) * (1 + x / 1000)));
      }
    }
  }
}

TEST_CASE("A plank of 100 m/s that spins at 50 rad/s does not pass a post", "[time_of_impact]") {
  const Moving post(box_shape(0.2, 0.2), {0, 0}, {});
  int hits = 0;
  for (const double spin : {-50.0, 50.0}) {
    for (int i = 0; i < 200; ++i) {
      const Moving plank(box_shape(4, 0.1), {-0.5 - 0.015 * i, 0.01 * i}, {100.0 / 60, 0}, 0.031 * i, spin / 60);
      const TimeOfImpact r = meet(plank, post);
      CHECK(r.state != ImpactState::unfinished);
      if (r.state == ImpactState::touching_at_start) continue;
      hits += r.state == ImpactState::hit ? 1 : 0;
      CHECK(least_separation(plank, post, r.fraction, 400) > static_cast<double>(target) - rounding);
    }
  }
  CHECK(hits > 50);
}

TEST_CASE("A wedge of 200 m/s does not pass a thin floor point first", "[time_of_impact]") {
  const Moving floor(box_shape(10, 0.02), {0, 0}, {});
  const Moving wedge(polygon_shape({{0, -1}, {0.1, 0.5}, {-0.1, 0.5}}), {0, 1.5}, {0, -200.0 / 60}, 0.2, 0.4);
  const TimeOfImpact r = meet(wedge, floor);
  REQUIRE(r.state == ImpactState::hit);
  CHECK(separation_at(wedge, floor, r.fraction) == Approx(0.005).margin(0.0013));
  CHECK(wedge.at(r.fraction).pose.position.y > 0.4);
}

TEST_CASE("A body that turns many times on the spot is caught where it first reaches out", "[time_of_impact]") {
  const Moving wall(box_shape(1, 4), {1.2, 0}, {});
  for (const double turns : {0.4, 1.0, 10.0}) {
    // Half a diagonal of 0.707 reaches over the gap of 0.7 when a corner points at the wall.
    const Moving box(box_shape(1, 1), {0, 0}, {}, 0, 6.283185307179586 * turns);
    const TimeOfImpact r = meet(box, wall);
    REQUIRE(r.state == ImpactState::hit);
    CHECK(r.fraction * turns < 0.125);
    CHECK(least_separation(box, wall, r.fraction, 1000) > static_cast<double>(target) - rounding);
    const Moving farther(box_shape(1, 4), {1.25, 0}, {});
    CHECK(meet(box, farther).state == ImpactState::separated);
  }
}

TEST_CASE("A disc spins as fast as it likes for nothing", "[time_of_impact]") {
  const Moving floor(box_shape(10, 1), {0, -0.5}, {});
  const TimeOfImpact r = meet(Moving(disc_shape(0.5), {-3, 0.51}, {6, 0}, 0, 1e4), floor);
  CHECK(r.state == ImpactState::separated);
  CHECK(r.iterations <= 2);
}

TEST_CASE("Shapes nearer than the target at the start are told from those that come near", "[time_of_impact]") {
  const Moving floor(box_shape(10, 1), {0, -0.5}, {});
  for (const double height : {0.4, 0.5, 0.504}) {
    const TimeOfImpact r = meet(Moving(box_shape(1, 1), {0, height}, {0, 1}), floor);
    CHECK(r.state == ImpactState::touching_at_start);
    CHECK(r.fraction == 0);
  }
  CHECK(meet(Moving(box_shape(1, 1), {0, 0.51}, {0, 1}), floor).state == ImpactState::separated);
  CHECK(meet(Moving(box_shape(1, 1), {0, 0.51}, {0, -1}), floor).state == ImpactState::hit);
}

TEST_CASE("A target of nothing is met to the rounding, and a negative one within the roundings", "[time_of_impact]") {
  const Moving wall(box_shape(1, 4), {3, 0}, {});
  const Moving box(box_shape(1, 1), {0, 0}, {4, 0}, 0.3, 1);
  const TimeOfImpact exact = time_of_impact(box.hull, box.sweep, wall.hull, wall.sweep, 0, 0);
  REQUIRE(exact.state == ImpactState::hit);
  CHECK(exact.separation == Approx(0).margin(pick(1e-12, 3e-4)));
  const Moving ball(disc_shape(0.5), {0, 0}, {4, 0});
  const TimeOfImpact sunk = time_of_impact(ball.hull, ball.sweep, wall.hull, wall.sweep, real(-0.25), tolerance);
  REQUIRE(sunk.state == ImpactState::hit);
  CHECK(4 * sunk.fraction == Approx(2.25).margin(0.0013));
}

TEST_CASE("Swapping the bodies finds the same time", "[time_of_impact]") {
  HullPool pool(62);
  int differ = 0;
  int hits = 0;
  for (int i = 0; i < 5000; ++i) {
    const Moving a = random_moving(pool, Kind::polygon, 2, 3, 2);
    const Moving b = random_moving(pool, Kind::polygon, 2, 3, 2);
    const TimeOfImpact ab = meet(a, b);
    const TimeOfImpact ba = meet(b, a);
    if (ab.state != ImpactState::hit) continue;
    ++hits;
    // Both are within the tolerance; how much time that is depends on how slowly they meet.
    differ += ba.state == ImpactState::hit && std::abs(ab.fraction - ba.fraction) < real(0.01) ? 0 : 1;
  }
  CHECK(differ < hits / 100);
  CHECK(hits > 500);
}

TEST_CASE("A pose on the way is turned as far as an angle would say, to the last digits", "[time_of_impact]") {
  const double digits = pick(4e-15, 2e-6);
  Worst wrong;
  for (int i = -4000; i <= 4000; ++i) {
    const double turn = 0.01 * i;
    Sweep sweep;
    sweep.turn = static_cast<real>(turn);
    const Rotd found(pose_at(sweep, 1).rotation);
    const Rotd truth(static_cast<double>(sweep.turn));
    wrong.see(std::hypot(found.c - truth.c, found.s - truth.s) / (1 + std::abs(turn)), i);
  }
  INFO("turn " << wrong.pair);
  CHECK(wrong.error < digits);
}

TEST_CASE("Who watches sees the time advance and the gap close", "[time_of_impact]") {
  const Moving wall(box_shape(1, 4), {3, 0}, {});
  const Moving box(box_shape(1, 1), {0, 0}, {4, 0}, 0.3, 1);
  double time = -1;
  double separation = 0;
  const Observer observer([&](const Event& event) {
    if (const auto* step = std::get_if<Advanced>(&event)) {
      CHECK(step->time > time);
      time = step->time;
      separation = step->separation;
    }
  });
  const TimeOfImpact watched = time_of_impact(box.hull, box.sweep, wall.hull, wall.sweep, target, tolerance, observer);
  CHECK(watched.fraction == meet(box, wall).fraction);
  CHECK(time == Approx(static_cast<double>(watched.fraction)));
  CHECK(separation == Approx(static_cast<double>(watched.separation)));
}
