#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numbers>
#include <string>

#include "engine/polygon.h"
#include "lab/bench.h"
#include "lab/bench_process.h"
#include "lab/manifold_side.h"
#include "scenarios/random.h"

namespace proofreel {
namespace {

constexpr std::size_t pair_count = 2000;
constexpr int passes = 50;  ///< over all pairs, per round
constexpr int rounds = 15;
constexpr double target_ratio = 1.5;

/// Metres. An overlap that hardly favours one axis over the next may be resolved along either, and so may the corner
/// region of a disc seen from its edge; shallower than this nobody disagrees for long.
constexpr double clear_choice = 1e-3;

double between(Random& random, double low, double high) { return low + (high - low) * random.uniform(); }

ShapeDef disc(Random& random) {
  ShapeDef shape;
  shape.points = {{0, 0}};
  shape.radius = between(random, 0.2, 0.6);
  return shape;
}

ShapeDef box(Random& random) {
  const double x = between(random, 0.2, 0.6);
  const double y = between(random, 0.2, 0.6);
  ShapeDef shape;
  shape.points = {{-x, -y}, {x, -y}, {x, y}, {-x, y}};
  return shape;
}

/// 3 to 8 corners on a circle or so, none too near the next: Box2D welds what is.
ShapeDef polygon(Random& random) {
  const auto corners = random.between(3, 8);
  ShapeDef shape;
  for (std::int64_t i = 0; i < corners; ++i) {
    const double angle =
        2 * std::numbers::pi * (static_cast<double>(i) + between(random, -0.3, 0.3)) / static_cast<double>(corners);
    shape.points.push_back({0.5 * std::cos(angle), 0.5 * std::sin(angle)});
  }
  shape.points = convex_hull(shape.points);
  return shape;
}

/// Around its centroid, as in the engine.
ShapeDef centred(ShapeDef shape) {
  if (shape.points.size() < 3) return shape;
  const Vec2d centroid = centroid_of(shape.points);
  for (Vec2d& p : shape.points) p -= centroid;
  return shape;
}

Aabbd bounds(const ShapeDef& shape, const Posed& pose) {
  Aabbd box;
  for (const Vec2d p : shape.points) box = merged(box, to_world(pose, p));
  return expanded(box, shape.radius);
}

using MakeShape = ShapeDef (*)(Random&);

/// What a broad phase hands on: boxes overlap, so the shapes overlap or are near.
std::vector<ShapePair> random_pairs(MakeShape make_a, MakeShape make_b) {
  Random random(1);
  std::vector<ShapePair> pairs;
  while (pairs.size() < pair_count) {
    const Vec2d here{between(random, -50, 50), between(random, -50, 50)};
    const Vec2d there = here + Vec2d{between(random, -1.2, 1.2), between(random, -1.2, 1.2)};
    const ShapePair pair{centred(make_a(random)),
                         centred(make_b(random)),
                         {here, Rotd(between(random, -3, 3))},
                         {there, Rotd(between(random, -3, 3))}};
    if (overlaps(bounds(pair.a, pair.pose_a), bounds(pair.b, pair.pose_b))) pairs.push_back(pair);
  }
  return pairs;
}

/// One narrow phase and its times.
struct Side {
  std::string name;
  std::unique_ptr<ManifoldSide> manifolds;
  std::vector<double> ns;  ///< CPU, per pair
};

void measure(std::vector<Side>& sides) {
  for (int round = 0; round < rounds; ++round) {
    for (Side& side : sides) {
      const Stopwatch watch;
      for (int pass = 0; pass < passes; ++pass) side.manifolds->collide_all();
      side.ns.push_back(1e9 * watch.elapsed().cpu_s / passes / pair_count);
    }
  }
}

struct Agreement {
  int touching = 0;       ///< pairs in which at least one side finds a manifold deeper than rounding
  int disputed = 0;       ///< depths differ by more than that
  int other_axis = 0;     ///< resolved along another axis of nearly the same depth
  double normal = 0;      ///< largest difference of the normals' components
  double separation = 0;  ///< metres
};

/// Ours against a peer's.
Agreement compare(const ManifoldSide& ours, const ManifoldSide& theirs) {
  Agreement found;
  for (std::size_t i = 0; i < pair_count; ++i) {
    const Touch a = ours.touch(i);
    const Touch b = theirs.touch(i);
    if (a.points == 0 && b.points == 0) continue;
    ++found.touching;
    const double separation = std::abs((a.points > 0 ? a.separation : 0) - (b.points > 0 ? b.separation : 0));
    found.separation = std::max(found.separation, separation);
    found.disputed += separation > clear_choice ? 1 : 0;
    if (a.points == 0 || b.points == 0) continue;
    const Vec2d turned = a.normal - b.normal;
    const double normal = std::max(std::abs(turned.x), std::abs(turned.y));
    if (normal > 0.01 && separation < clear_choice) {
      ++found.other_axis;
    } else {
      found.normal = std::max(found.normal, normal);
    }
  }
  return found;
}

void print_peer(const Side& ours, const Side& peer) {
  const double own_ns = median(ours.ns);
  const double peer_ns = median(peer.ns);
  const Agreement same = compare(*ours.manifolds, *peer.manifolds);
  std::printf("    %-18s %6.1f ns; %-25s %6.1f ns: %4.2f times as many per second", ours.name.c_str(), own_ns,
              peer.name.c_str(), peer_ns, peer_ns / own_ns);
  std::printf(
      "; depths agree to %.1e m (%d of %d differ by over 1 mm), normals to %.1e, %d along another axis as good\n",
      same.separation, same.disputed, same.touching, same.normal, same.other_axis);
}

struct Kind {
  const char* name;
  MakeShape a;
  MakeShape b;
};

void bench_kind(const Kind& kind) {
  const std::vector<ShapePair> pairs = random_pairs(kind.a, kind.b);
  std::vector<Side> sides;
  sides.push_back({"proofreel, single", float32::our_manifolds(pairs), {}});
  sides.push_back({"Box2D", box2d_manifolds(pairs, false), {}});
  sides.push_back({"Box2D and b2WorldManifold", box2d_manifolds(pairs, true), {}});
  sides.push_back({"proofreel, double", float64::our_manifolds(pairs), {}});
  sides.push_back({"Chipmunk", chipmunk_manifolds(pairs), {}});
  measure(sides);
  std::printf("  %s\n", kind.name);
  print_peer(sides[0], sides[1]);
  print_peer(sides[0], sides[2]);
  print_peer(sides[3], sides[4]);
}

}  // namespace

void bench_manifolds() {
  std::printf("  manifolds of %zu random pairs whose boxes overlap, margin 0; CPU per pair, in turns, medians of %d\n",
              pair_count, rounds);
  std::printf(
      "  (target against Box2D, polygons and boxes: %.1f; what its functions give is in the shapes' own coordinates,\n"
      "   b2WorldManifold makes of it what ours is: world axes and separations)\n",
      target_ratio);
  for (const Kind& kind : {Kind{"polygon and polygon, 3 to 8 corners", polygon, polygon}, Kind{"box and box", box, box},
                           Kind{"polygon and disc", polygon, disc}, Kind{"disc and disc", disc, disc}}) {
    bench_kind(kind);
  }
}

}  // namespace proofreel
