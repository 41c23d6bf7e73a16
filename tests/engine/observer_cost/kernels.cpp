/// The algorithms that can be watched, run on fixed inputs with nobody watching. Built twice: from the engine's sources
/// as they are, and from copies without the statements that make events. Both must execute as many instructions, which
/// callgrind counts inside the functions named `measured_...`: what comes before them is left out.

#include <cstdio>
#include <cstring>
#include <vector>

#include "engine/collide.h"
#include "engine/dynamic_tree_query.h"
#include "engine/epa.h"
#include "engine/gjk.h"
#include "engine/polygon.h"
#include "tests/engine/random.h"

using namespace proofreel;

namespace {

struct Pair {
  Hull a, b;
  Pose pose_a, pose_b;
};

std::vector<Vec2d> random_points(Random& random, int count) {
  std::vector<Vec2d> points;
  for (int i = 0; i < count; ++i) points.push_back({random.between(-1, 1), random.between(-1, 1)});
  return points;
}

/// Discs, capsules and polygons, half of them rounded.
Hull random_hull(Random& random) {
  ShapeDef shape;
  shape.points = convex_hull(random_points(random, 1 + static_cast<int>(random.below(8))));
  shape.radius = shape.points.size() < 3 || random.below(2) == 0 ? random.between(0.05, 0.5) : 0;
  return make_hull(shape, {});
}

Pose random_pose(Random& random) {
  return {{static_cast<real>(random.between(-1, 1)), static_cast<real>(random.between(-1, 1))},
          Rot(static_cast<real>(random.between(-3, 3)))};
}

std::vector<Pair> random_pairs() {
  Random random(7);
  std::vector<Pair> pairs;
  for (int i = 0; i < 500; ++i) {
    const Hull a = random_hull(random);
    const Hull b = random_hull(random);
    pairs.push_back({a, b, random_pose(random), random_pose(random)});
  }
  return pairs;
}

std::vector<Aabb> random_boxes() {
  Random random(8);
  std::vector<Aabb> boxes;
  for (int i = 0; i < 500; ++i) {
    const Vec2 corner{static_cast<real>(random.between(-20, 20)), static_cast<real>(random.between(-20, 20))};
    boxes.push_back({corner, corner + Vec2{1, 1}});
  }
  return boxes;
}

}  // namespace

// Not static, not inline: callgrind finds them by name. Each returns something, so that nothing is computed in vain.

[[gnu::noinline]] int measured_collide(const std::vector<Pair>& pairs) {
  int points = 0;
  for (const Pair& p : pairs) points += collide(p.a, p.pose_a, p.b, p.pose_b, real(0.1)).count;
  return points;
}

[[gnu::noinline]] double measured_distance(const std::vector<Pair>& pairs) {
  double sum = 0;
  for (const Pair& p : pairs) {
    SimplexCache cache;
    sum += static_cast<double>(distance(p.a, p.pose_a, p.b, p.pose_b, cache).separation);
  }
  return sum;
}

[[gnu::noinline]] double measured_hull(const std::vector<std::vector<Vec2d>>& clouds) {
  double sum = 0;
  for (const std::vector<Vec2d>& cloud : clouds) sum += area_of(convex_hull(cloud));
  return sum;
}

[[gnu::noinline]] std::size_t measured_tree(const std::vector<Aabb>& boxes) {
  DynamicTree tree;
  std::size_t found = 0;
  for (const Aabb& box : boxes) {
    tree.query(box, [&](ProxyId, std::uint32_t) {
      ++found;
      return true;
    });
    tree.insert(box, 0);
  }
  return found;
}

int main(int argc, char** argv) {
  const char* wanted = argc == 2 ? argv[1] : "";
  if (std::strcmp(wanted, "collide") == 0) {
    std::printf("%d\n", measured_collide(random_pairs()));
  } else if (std::strcmp(wanted, "distance") == 0) {
    std::printf("%.17g\n", measured_distance(random_pairs()));
  } else if (std::strcmp(wanted, "hull") == 0) {
    Random random(9);
    std::vector<std::vector<Vec2d>> clouds;
    for (int i = 0; i < 100; ++i) clouds.push_back(random_points(random, 3 + static_cast<int>(random.below(40))));
    std::printf("%.17g\n", measured_hull(clouds));
  } else if (std::strcmp(wanted, "tree") == 0) {
    std::printf("%zu\n", measured_tree(random_boxes()));
  } else {
    std::fputs("usage: kernels collide|distance|hull|tree\n", stderr);
    return 2;
  }
  return 0;
}
