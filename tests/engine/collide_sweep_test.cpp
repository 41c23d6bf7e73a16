/// Random pairs of every two kinds of shapes against an answer found another way: the distance by all corners and edges
/// when the cores are apart, the least overlap over all face normals when they are not. All in double, from the very
/// numbers the engine was given.

#include <catch2/catch.hpp>
#include <cmath>
#include <limits>
#include <string>

#include "engine/collide.h"
#include "engine/polygon.h"
#include "tests/engine/random.h"
#include "tests/engine/scenes.h"

using namespace proofreel;
using namespace proofreel::test;

namespace {

#ifdef NDEBUG
constexpr int pairs_per_kind = 1000000;
#else
constexpr int pairs_per_kind = 5000;
#endif

/// Of the size of the shapes, which is about a metre.
const double rounding = pick(1e-12, 1e-5);

struct Placed {
  Hull hull;
  Pose pose;
};

/// A shape's core in world coordinates.
struct Core {
  Vec2d points[max_polygon_vertices];
  int count = 0;
  double radius = 0;
  double detail = 0;

  int next(int i) const { return i + 1 < count ? i + 1 : 0; }
  Vec2d normal(int i) const { return -perp(normalized(points[next(i)] - points[i])); }
};

Core core_of(const Placed& p) {
  Core core;
  core.count = p.hull.count;
  core.radius = static_cast<double>(p.hull.radius);
  core.detail = static_cast<double>(p.hull.detail);
  for (int i = 0; i < core.count; ++i) core.points[i] = to_world(Posed(p.pose), Vec2d(p.hull.points[i]));
  return core;
}

double distance_to_segment(Vec2d p, Vec2d a, Vec2d b) {
  const double l2 = dot(b - a, b - a);
  const double t = l2 > 0 ? std::clamp(dot(p - a, b - a) / l2, 0.0, 1.0) : 0.0;
  return distance(p, lerp(a, b, t));
}

double distance_to_outline(Vec2d p, const Core& core) {
  double nearest = 1e300;
  for (int i = 0; i < core.count; ++i) {
    nearest = std::min(nearest, distance_to_segment(p, core.points[i], core.points[core.next(i)]));
  }
  return nearest;
}

double distance_of_outlines(const Core& a, const Core& b) {
  double nearest = 1e300;
  for (int i = 0; i < a.count; ++i) nearest = std::min(nearest, distance_to_outline(a.points[i], b));
  for (int i = 0; i < b.count; ++i) nearest = std::min(nearest, distance_to_outline(b.points[i], a));
  return nearest;
}

/// The largest gap along one of a's face normals; nothing to be found for a point.
double gap_along_faces(const Core& a, const Core& b) {
  double best = -1e300;
  for (int i = 0; a.count > 1 && i < a.count; ++i) {
    const Vec2d n = a.normal(i);
    double nearest = 1e300;
    for (int j = 0; j < b.count; ++j) nearest = std::min(nearest, dot(n, b.points[j] - a.points[i]));
    best = std::max(best, nearest);
  }
  return best;
}

/// How far a point is outside the rounded shape; negative inside.
double outside(Vec2d p, const Core& core) {
  double deepest = -1e300;
  for (int i = 0; core.count > 2 && i < core.count; ++i) {
    deepest = std::max(deepest, dot(core.normal(i), p - core.points[i]));
  }
  return (core.count > 2 && deepest < 0 ? deepest : distance_to_outline(p, core)) - core.radius;
}

/// The separation of two shapes lies between these two. They are the same but for two choices the engine makes in
/// favour of steady features: of faces equally good to 1e-4 of the thinner shape it takes A's, and it keeps a face
/// whose end is nearest to 1e-6 of that.
struct Truth {
  double least = 0;
  double most = 0;
  double separation = 0;
};

Truth truth_of(const Core& a, const Core& b) {
  const double radii = a.radius + b.radius;
  if (a.count == 1 && b.count == 1) {
    const double apart = distance(a.points[0], b.points[0]) - radii;
    return {apart, apart, apart};
  }
  const double gap_a = gap_along_faces(a, b);
  const double gap_b = gap_along_faces(b, a);
  const double gap = std::max(gap_a, gap_b);
  const double separation = (gap < 0 ? gap : distance_of_outlines(a, b)) - radii;
  if (a.count == 1 || b.count == 1) return {separation, separation, separation};
  const double detail = std::min(a.detail, b.detail);
  const bool tie = gap <= 1e-4 * detail && std::abs(gap_a - gap_b) <= 1e-4 * detail;
  const double least = tie ? std::min(gap_a, gap_b) - radii : separation;
  return {std::min(least, separation), separation + (gap > -1e-4 * detail ? 1e-6 * detail : 0), separation};
}

/// Whether one face of all is better than every other by more than `margin`: then the engine has no choice to make.
/// Discs have no faces and leave none.
bool has_clear_axis(const Core& a, const Core& b, double margin) {
  double best = -1e300;
  double second = -1e300;
  const auto try_faces = [&](const Core& p, const Core& q) {
    for (int i = 0; p.count > 1 && i < p.count; ++i) {
      double gap = 1e300;
      for (int j = 0; j < q.count; ++j) gap = std::min(gap, dot(p.normal(i), q.points[j] - p.points[i]));
      second = std::max(second, std::min(best, gap));
      best = std::max(best, gap);
    }
  };
  try_faces(a, b);
  try_faces(b, a);
  return (a.count == 1 && b.count == 1) || best - second > 1e-4 * std::min(a.detail, b.detail) + margin;
}

/// Whether every point of `m` that is clearly within the margin is one of `other`, at the same place and as deep.
bool holds_points_of(const Manifold& m, Vec2 at, const Manifold& other, Vec2 other_at, double margin, double slack) {
  bool all = true;
  for (int k = 0; k < m.count; ++k) {
    if (static_cast<double>(m.points[k].separation) > margin - slack) continue;
    bool found = false;
    for (int l = 0; l < other.count; ++l) {
      const Vec2d apart = Vec2d(at) + Vec2d(m.points[k].point) - Vec2d(other_at) - Vec2d(other.points[l].point);
      const double deeper =
          static_cast<double>(m.points[k].separation) - static_cast<double>(other.points[l].separation);
      found = found || (length(apart) <= slack && std::abs(deeper) <= slack);
    }
    all = all && found;
  }
  return all;
}

/// Whether one manifold is the other with the shapes swapped: the normal turned round, the points the same. A normal
/// from corner to corner is as exact as these are far apart, and the end of an edge that was cut as the edge is level.
bool mirror_each_other(const Manifold& m, Vec2 at, const Manifold& back, Vec2 back_at, double margin, double radii) {
  const double apart = static_cast<double>(deepest(m)) + radii;
  const double slack = 2 * rounding * (apart > 0 ? 1 + 1 / apart : 1);
  return length(Vec2d(m.normal) + Vec2d(back.normal)) <= slack &&
         holds_points_of(m, at, back, back_at, margin, slack) && holds_points_of(back, back_at, m, at, margin, slack);
}

using MakeHull = Hull (*)(Random&);

Hull disc(Random& random) { return make_hull(disc_shape(random.between(0.05, 0.5)), {}); }

ShapeDef two_points(Random& random, double radius) {
  ShapeDef shape;
  shape.points = {{random.between(-1, 1), random.between(-1, 1)}, {random.between(-1, 1), random.between(-1, 1)}};
  shape.radius = radius;
  return distance(shape.points[0], shape.points[1]) > 0.05 ? shape : two_points(random, radius);
}

Hull capsule(Random& random) { return make_hull(two_points(random, random.between(0.05, 0.5)), {}); }

Hull segment(Random& random) { return make_hull(two_points(random, 0), {}); }

/// 3 to 8 corners, none too flat: those have tests of their own.
Hull rounded_by(Random& random, double radius) {
  const int corners = 3 + static_cast<int>(random.below(6));
  ShapeDef shape;
  for (int i = 0; i < corners; ++i) shape.points.push_back({random.between(-1, 1), random.between(-1, 1)});
  shape.points = convex_hull(shape.points);
  shape.radius = radius;
  const Hull hull = make_hull(shape, {});
  return hull.count > 2 && hull.thickness - 2 * hull.radius > real(0.05) ? hull : rounded_by(random, radius);
}

Hull polygon(Random& random) { return rounded_by(random, 0); }
Hull rounded(Random& random) { return rounded_by(random, random.between(0.05, 0.5)); }

Pose random_pose(Random& random, double spread) {
  const Vec2d position{random.between(-spread, spread), random.between(-spread, spread)};
  return {Vec2(position), Rot(Rotd(random.between(-4, 4)))};
}

struct Kind {
  const char* name;
  MakeHull a;
  MakeHull b;
};

const Kind kinds[] = {
    {"disc and disc", disc, disc},
    {"disc and capsule", disc, capsule},
    {"disc and polygon", disc, polygon},
    {"capsule and capsule", capsule, capsule},
    {"capsule and polygon", capsule, polygon},
    {"segment and polygon", segment, polygon},
    {"polygon and polygon", polygon, polygon},
    {"rounded and rounded", rounded, rounded},
};

std::string describe(const Kind& kind, int number, const Placed& a, const Placed& b, const Truth& truth) {
  return std::string(kind.name) + " " + std::to_string(number) + ", corners " + std::to_string(a.hull.count) + " and " +
         std::to_string(b.hull.count) + ", separation " + std::to_string(truth.separation);
}

/// Each surface within half the separation of each point.
bool lies_between(const Manifold& m, const Placed& a, const Core& core_a, const Core& core_b, double slack) {
  bool all = true;
  for (int k = 0; k < m.count; ++k) {
    const Vec2d p = Vec2d(a.pose.position) + Vec2d(m.points[k].point);
    const double half = 0.5 * std::abs(static_cast<double>(m.points[k].separation)) + slack;
    const double out_a = outside(p, core_a);
    const double out_b = outside(p, core_b);
    all = all && out_a <= half && out_b <= half;
    // A rounded edge that is tilted goes deeper than its end's distance says, except at the deepest point.
    if (m.points[k].separation == deepest(m)) all = all && out_a >= -half && out_b >= -half;
  }
  return all;
}

void check_pair(const Kind& kind, int number, Random& random) {
  const double spread = random.between(0, 2);
  const Placed a{kind.a(random), random_pose(random, spread)};
  const Placed b{kind.b(random), random_pose(random, spread)};
  const real margin = static_cast<real>(random.below(4) == 0 ? 0.0 : random.between(0, 1));
  const Core core_a = core_of(a);
  const Core core_b = core_of(b);
  const Truth truth = truth_of(core_a, core_b);
  const Manifold m = collide(a.hull, a.pose, b.hull, b.pose, margin);
  const Manifold mirrored = collide(b.hull, b.pose, a.hull, a.pose, margin);
  const double limit = static_cast<double>(margin);
  const double found = static_cast<double>(deepest(m));
  const double back = static_cast<double>(deepest(mirrored));

  // Nothing nearer than the margin is missing, nothing farther is there.
  const bool must = truth.most < limit - rounding;
  bool good = must ? m.count > 0 && mirrored.count > 0 : true;
  if (m.count > 0) {
    good = good && found <= limit && found >= truth.least - rounding && found <= truth.most + rounding;
    good = good && lies_between(m, a, core_a, core_b, rounding + truth.most - truth.least);
    good = good && std::abs(length(Vec2d(m.normal)) - 1) < rounding;
  }
  if (m.count > 0 && mirrored.count > 0)
    good = good && std::abs(back - found) <= 2 * rounding + truth.most - truth.least;
  if (!good) FAIL(describe(kind, number, a, b, truth) << ", found " << found << ", mirrored " << back);
}

}  // namespace

TEST_CASE("Manifolds of random pairs agree with brute force", "[collide]") {
  for (const Kind& kind : kinds) {
    Random random(100);
    for (int i = 0; i < pairs_per_kind; ++i) check_pair(kind, i, random);
    SUCCEED(kind.name);
  }
}

TEST_CASE("Swapping the shapes turns the normal round and leaves the points where they are", "[collide]") {
  for (const Kind& kind : kinds) {
    Random random(104);
    int seen = 0;
    int compared = 0;
    int different = 0;
    for (int i = 0; i < pairs_per_kind / 10; ++i) {
      const Placed a{kind.a(random), random_pose(random, 1)};
      const Placed b{kind.b(random), random_pose(random, 1)};
      const real margin = static_cast<real>(random.between(0, 0.5));
      const Manifold ab = collide(a.hull, a.pose, b.hull, b.pose, margin);
      const Manifold ba = collide(b.hull, b.pose, a.hull, a.pose, margin);
      if (ab.count == 0 || ba.count == 0) continue;  // the other sweep sees to it that both have what they must
      ++seen;
      if (!has_clear_axis(core_of(a), core_of(b), 4 * rounding)) continue;
      ++compared;
      const double radii = static_cast<double>(a.hull.radius) + static_cast<double>(b.hull.radius);
      const bool same = mirror_each_other(ab, a.pose.position, ba, b.pose.position, static_cast<double>(margin), radii);
      different += same ? 0 : 1;
    }
    INFO(kind.name << ": " << different << " of " << compared << " differ from their mirror image");
    CHECK(compared > 0.98 * seen);
    CHECK(different == 0);
  }
}

bool same_features(const Manifold& m, const Manifold& n) {
  bool same = m.count == n.count;
  for (int k = 0; k < m.count; ++k) same = same && m.points[k].feature == n.points[k].feature;
  return same;
}

// Rounding a coordinate there moves a shape by half a unit in the last place at most. So the two move against each
// other by less than two, and the separation changes by no more; the rest is for rounding on the way.
TEST_CASE("A million metres away a manifold is right to 4 units in the last place of the offset", "[collide]") {
  const double offset = 1e6;
  const double ulp =
      static_cast<double>(std::nextafter(static_cast<real>(offset), std::numeric_limits<real>::max())) - offset;
  for (const Kind& kind : kinds) {
    Random random(101);
    int compared = 0;
    for (int i = 0; i < pairs_per_kind / 50; ++i) {
      Placed a{kind.a(random), random_pose(random, 1)};
      Placed b{kind.b(random), random_pose(random, 1)};
      const Manifold here = collide(a.hull, a.pose, b.hull, b.pose, 9);
      const bool clear = has_clear_axis(core_of(a), core_of(b), 4 * ulp);
      a.pose.position += Vec2{static_cast<real>(offset), static_cast<real>(-offset)};
      b.pose.position += Vec2{static_cast<real>(offset), static_cast<real>(-offset)};
      const Manifold there = collide(a.hull, a.pose, b.hull, b.pose, 9);
      const double off = static_cast<double>(deepest(there)) - static_cast<double>(deepest(here));
      if (!(std::abs(off) <= 4 * ulp)) FAIL(kind.name << " " << i << ": off by " << off << ", 4 ulp are " << 4 * ulp);
      // In single precision 4 ulp are a quarter of a metre, and shapes that moved so far touch elsewhere.
      if (!is_double || !clear) continue;
      ++compared;
      const bool same = same_features(here, there) && length(Vec2d(here.normal - there.normal)) < 1e-6;
      if (!same) FAIL(kind.name << " " << i << ": other features or another normal");
    }
    if (is_double) CHECK(compared > pairs_per_kind / 100);
  }
  SUCCEED();
}

TEST_CASE("Shapes of millimetres and of kilometres collide like those of metres", "[collide]") {
  for (const double scale : {1e-3, 1e3}) {
    for (const Kind& kind : kinds) {
      Random random(102);
      for (int i = 0; i < pairs_per_kind / 50; ++i) {
        const Placed a{kind.a(random), random_pose(random, 1)};
        const Placed b{kind.b(random), random_pose(random, 1)};
        const auto scaled = [&](const Placed& p) {
          ShapeDef shape;
          for (int k = 0; k < p.hull.count; ++k) shape.points.push_back(scale * Vec2d(p.hull.points[k]));
          shape.radius = scale * static_cast<double>(p.hull.radius);
          return Placed{make_hull(shape, {}), {static_cast<real>(scale) * p.pose.position, p.pose.rotation}};
        };
        const Placed sa = scaled(a);
        const Placed sb = scaled(b);
        const Truth truth = truth_of(core_of(a), core_of(b));
        const real far = static_cast<real>(9 * scale);
        const double here = static_cast<double>(deepest(collide(a.hull, a.pose, b.hull, b.pose, 9)));
        const double there = static_cast<double>(deepest(collide(sa.hull, sa.pose, sb.hull, sb.pose, far))) / scale;
        const bool same = std::abs(there - here) <= 2 * rounding + truth.most - truth.least;
        if (!same) FAIL(kind.name << " " << i << ": " << here << ", scaled " << there);
      }
    }
  }
  SUCCEED();
}

TEST_CASE("Moving by a millionth of the size changes no feature, save at the few places where it must", "[collide]") {
  int changed = 0;
  int seen = 0;
  for (const Kind& kind : kinds) {
    Random random(103);
    for (int i = 0; i < pairs_per_kind / 50; ++i) {
      const Placed a{kind.a(random), random_pose(random, 1)};
      const Placed b{kind.b(random), random_pose(random, 1)};
      Pose moved = b.pose;
      moved.position += Vec2{real(1e-6), real(-1e-6)};
      const Manifold before = collide(a.hull, a.pose, b.hull, b.pose, real(0.5));
      const Manifold after = collide(a.hull, a.pose, b.hull, moved, real(0.5));
      if (before.count == 0) continue;
      ++seen;
      changed += same_features(before, after) ? 0 : 1;
    }
  }
  CHECK(seen > pairs_per_kind / 50);
  // Where two faces of one shape are equally good, one of them has to be chosen.
  CHECK(changed <= seen / 10000);
}
