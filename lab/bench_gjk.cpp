// Built against the engine in single precision, as Box2D is.

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <functional>
#include <string>
#include <vector>

#include "engine/polygon.h"
#include "engine/time_of_impact.h"
#include "lab/bench.h"
#include "lab/bench_process.h"
#include "lab/peers/box2d_distance.h"

namespace proofreel {
namespace {

constexpr int pair_count = 1000;
constexpr int repeats = 60;  ///< of all pairs, for one figure
constexpr int figures = 15;

/// Numbers that are the same everywhere (Steele and Vigna 2014: splitmix64).
class Numbers {
 public:
  double between(double low, double high) {
    std::uint64_t z = state_ += 0x9e3779b97f4a7c15U;
    z = (z ^ z >> 30) * 0xbf58476d1ce4e5b9U;
    z = (z ^ z >> 27) * 0x94d049bb133111ebU;
    return low + (high - low) * (static_cast<double>((z ^ z >> 31) >> 11) * 0x1p-53);
  }

 private:
  std::uint64_t state_ = 1;
};

/// Exactly so many corners, on an ellipse.
std::vector<Vec2d> random_polygon(Numbers& numbers, int count) {
  const double width = numbers.between(0.4, 1);
  const double height = numbers.between(0.4, 1);
  std::vector<double> angles;
  for (int i = 0; i < count; ++i) angles.push_back((i + numbers.between(0, 0.8)) * 6.283185307179586 / count);
  std::vector<Vec2d> corners;
  for (const double angle : angles) corners.push_back({width * std::cos(angle), height * std::sin(angle)});
  const Vec2d center = centroid_of(corners);
  for (Vec2d& corner : corners) corner -= center;
  return corners;
}

/// `speed` metres and `spin` radians per step at most.
MovingPolygon random_moving(Numbers& numbers, double speed, double spin) {
  MovingPolygon polygon;
  polygon.corners = random_polygon(numbers, static_cast<int>(numbers.between(3, 9)));
  polygon.position = {numbers.between(-1.2, 1.2), numbers.between(-1.2, 1.2)};
  polygon.angle = numbers.between(-3, 3);
  polygon.displacement = {numbers.between(-speed, speed), numbers.between(-speed, speed)};
  polygon.turn = numbers.between(-spin, spin);
  return polygon;
}

std::vector<MovingPair> random_pairs(double speed, double spin) {
  Numbers numbers;
  std::vector<MovingPair> pairs;
  for (int i = 0; i < pair_count; ++i) {
    pairs.push_back({random_moving(numbers, speed, spin), random_moving(numbers, speed, spin)});
  }
  return pairs;
}

Sweep sweep_of(const MovingPolygon& polygon) {
  return {
      {Vec2(polygon.position), Rot(Rotd(polygon.angle))}, Vec2(polygon.displacement), static_cast<float>(polygon.turn)};
}

Pose pose_of(const MovingPolygon& polygon, bool moved) {
  const double part = moved ? 1 : 0;
  return {Vec2(polygon.position + part * polygon.displacement), Rot(Rotd(polygon.angle + part * polygon.turn))};
}

Hull hull_of(const MovingPolygon& polygon) {
  ShapeDef def;
  def.points = polygon.corners;
  return make_hull(def, {});
}

/// What ours is given, made before the clock starts.
struct OurPair {
  explicit OurPair(const MovingPair& pair)
      : a(hull_of(pair.a)),
        b(hull_of(pair.b)),
        before{pose_of(pair.a, false), pose_of(pair.b, false)},
        after{pose_of(pair.a, true), pose_of(pair.b, true)},
        sweep_a(sweep_of(pair.a)),
        sweep_b(sweep_of(pair.b)) {}

  Hull a, b;
  Pose before[2], after[2];
  Sweep sweep_a, sweep_b;
  SimplexCache cache;
};

using Found = std::vector<float>;

void our_distances(std::vector<OurPair>& pairs, bool moved, bool warm, Found& found) {
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    OurPair& p = pairs[i];
    if (!warm) p.cache = {};
    const Pose* poses = moved ? p.after : p.before;
    found[i] = std::max(distance(p.a, poses[0], p.b, poses[1], p.cache).separation, 0.0F);
  }
}

void our_times(const std::vector<OurPair>& pairs, Found& found) {
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    const OurPair& p = pairs[i];
    found[i] =
        time_of_impact(p.a, p.sweep_a, p.b, p.sweep_b, Box2dDistances::target(), Box2dDistances::tolerance()).fraction;
  }
}

/// One question, asked of both sides.
struct Race {
  std::string name;
  std::function<void(Found&)> ours;
  std::function<void(Found&)> theirs;
};

double nanoseconds_each(const std::function<void(Found&)>& side, Found& found) {
  const Stopwatch watch;
  for (int i = 0; i < repeats; ++i) side(found);
  return 1e9 * watch.elapsed().cpu_s / (repeats * static_cast<double>(found.size()));
}

void run(const Race& race, Found& our_found, Found& their_found) {
  std::vector<double> ours;
  std::vector<double> theirs;
  for (int i = 0; i < figures; ++i) {
    theirs.push_back(nanoseconds_each(race.theirs, their_found));
    ours.push_back(nanoseconds_each(race.ours, our_found));
  }
  std::printf("  %-38s %6.1f ns, Box2D %6.1f ns: %.2f times as many per second\n", race.name.c_str(), median(ours),
              median(theirs), median(theirs) / median(ours));
}

void print_difference(const Found& ours, const Found& theirs, const char* of) {
  double largest = 0;
  for (std::size_t i = 0; i < ours.size(); ++i) {
    largest = std::max(largest, static_cast<double>(std::abs(ours[i] - theirs[i])));
  }
  std::printf("    largest difference of %s: %.2g\n", of, largest);
}

void race_distances(const char* which, double speed, double spin, bool warm) {
  const std::vector<MovingPair> pairs = random_pairs(speed, spin);
  std::vector<OurPair> our_pairs(pairs.begin(), pairs.end());
  Box2dDistances peer(pairs);
  Found ours(pairs.size());
  Found theirs(pairs.size());
  bool our_turn = false;
  bool their_turn = false;
  const Race race{std::string("distance, ") + which,
                  [&](Found& found) { our_distances(our_pairs, our_turn = !our_turn, warm, found); },
                  [&](Found& found) { peer.distances(their_turn = !their_turn, warm, found); }};
  run(race, ours, theirs);
  print_difference(ours, theirs, "the distances, m");
}

/// Where both find an impact, how far apart in time; and how often only one does.
void compare_times(const Found& ours, const Found& theirs) {
  int hits = 0;
  int only_ours = 0;
  int only_theirs = 0;
  int apart = 0;
  for (std::size_t i = 0; i < ours.size(); ++i) {
    const bool our_hit = ours[i] < 1;
    const bool their_hit = theirs[i] < 1;
    hits += our_hit && their_hit ? 1 : 0;
    only_ours += our_hit && !their_hit ? 1 : 0;
    only_theirs += their_hit && !our_hit ? 1 : 0;
    apart += our_hit && their_hit && std::abs(ours[i] - theirs[i]) > 0.01F ? 1 : 0;
  }
  std::printf("    of %zu pairs both find %d impacts, only ours %d, only Box2D %d; %d differ by over 0.01 of the way\n",
              ours.size(), hits, only_ours, only_theirs, apart);
}

void race_times(const char* which, double speed, double spin) {
  const std::vector<MovingPair> pairs = random_pairs(speed, spin);
  const std::vector<OurPair> our_pairs(pairs.begin(), pairs.end());
  Box2dDistances peer(pairs);
  Found ours(pairs.size());
  Found theirs(pairs.size());
  const Race race{std::string("time of impact, ") + which, [&](Found& found) { our_times(our_pairs, found); },
                  [&](Found& found) { peer.times_of_impact(found); }};
  run(race, ours, theirs);
  compare_times(ours, theirs);
}

}  // namespace

void bench_gjk() {
  std::printf(
      "  %d pairs of polygons of 3 to 8 corners near each other, single precision; CPU, in turns, median of %d\n",
      pair_count, figures);
  race_distances("cold start", 0.02, 0.02, false);
  race_distances("warm start", 0.02, 0.02, true);
  race_times("slow (0.1 m, 0.1 rad)", 0.1, 0.1);
  race_times("fast (2 m, 0.5 rad)", 2, 0.5);
  race_times("spinning (2 m, 3 rad)", 2, 3);
}

}  // namespace proofreel
