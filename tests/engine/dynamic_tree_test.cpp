#include "engine/dynamic_tree.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <map>
#include <optional>

#include "tests/engine/random.h"

namespace proofreel {
namespace {

real real_between(Random& random, double low, double high) { return static_cast<real>(random.between(low, high)); }

Aabb random_box(Random& random) {
  const Vec2 lower{real_between(random, 0, 50), real_between(random, 0, 50)};
  return {lower, lower + Vec2{real_between(random, 0, 3), real_between(random, 0, 3)}};
}

std::vector<std::uint32_t> found_in(const DynamicTree& tree, const Aabb& box) {
  std::vector<std::uint32_t> owners;
  tree.query(box, [&](ProxyId leaf, std::uint32_t owner) {
    REQUIRE(tree.owner(leaf) == owner);
    owners.push_back(owner);
    return true;
  });
  return owners;
}

/// The tree and, beside it, a plain list of what it should hold.
struct Checked {
  DynamicTree tree;
  std::map<std::uint32_t, ProxyId> leaves;  ///< by owner
  std::map<std::uint32_t, Aabb> boxes;      ///< by owner
  std::uint32_t next_owner = 0;

  void insert(const Aabb& box) {
    leaves[next_owner] = tree.insert(box, next_owner);
    boxes[next_owner++] = box;
  }
  void remove(std::uint32_t owner) {
    tree.remove(leaves.at(owner));
    leaves.erase(owner);
    boxes.erase(owner);
  }
  std::uint32_t any_owner(Random& random) const {
    return std::next(boxes.begin(), random.below(static_cast<std::uint32_t>(boxes.size())))->first;
  }
  /// Inserts, moves or removes one.
  void disturb(Random& random) {
    const std::uint32_t choice = random.below(10);
    if (boxes.empty() || choice < 4) return insert(random_box(random));
    const std::uint32_t owner = any_owner(random);
    if (choice >= 7) return remove(owner);
    boxes[owner] = random_box(random);
    tree.move(leaves.at(owner), boxes[owner]);
  }
  std::vector<std::uint32_t> brute_force(const Aabb& box) const {
    std::vector<std::uint32_t> owners;
    for (const auto& [owner, stored] : boxes) {
      if (overlaps(stored, box)) owners.push_back(owner);
    }
    return owners;
  }
};

std::vector<std::uint32_t> sorted(std::vector<std::uint32_t> owners) {
  std::sort(owners.begin(), owners.end());
  return owners;
}

TEST_CASE("An empty tree finds nothing and has no height") {
  const DynamicTree tree;
  CHECK(tree.is_empty());
  CHECK(tree.height() == 0);
  CHECK(tree.area_ratio() == real(0));
  CHECK(tree.validate());
  CHECK(found_in(tree, Aabb{{-9, -9}, {9, 9}}).empty());
  tree.visit([](const Aabb&, int, bool) { FAIL("there is no node to visit"); });
}

TEST_CASE("A single leaf is found by what touches its box and by nothing else") {
  DynamicTree tree;
  const ProxyId leaf = tree.insert(Aabb{{0, 0}, {1, 1}}, 42);
  CHECK(found_in(tree, Aabb{{1, 1}, {2, 2}}) == std::vector<std::uint32_t>{42});
  CHECK(found_in(tree, Aabb{{1.5, 0}, {2, 2}}).empty());
  tree.move(leaf, Aabb{{5, 5}, {6, 6}});
  CHECK(found_in(tree, Aabb{{1, 1}, {2, 2}}).empty());
  CHECK(tree.aabb(leaf).lower == Vec2{5, 5});
  CHECK(tree.height() == 0);
  tree.remove(leaf);
  CHECK(tree.is_empty());
}

TEST_CASE("Queries find exactly what brute force finds, whatever was inserted, moved and removed before") {
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    Random random(seed);
    Checked checked;
    for (int i = 0; i < 2000; ++i) {
      checked.disturb(random);
      if (i % 10 != 0) continue;
      const Aabb box = expanded(random_box(random), real(2));
      REQUIRE(sorted(found_in(checked.tree, box)) == checked.brute_force(box));
      REQUIRE(checked.tree.validate());
    }
  }
}

TEST_CASE("Everything can be removed again, in any order, and the space is used anew") {
  Random random(11);
  Checked checked;
  for (int round = 0; round < 3; ++round) {
    for (int i = 0; i < 300; ++i) checked.insert(random_box(random));
    ProxyId highest = 0;
    for (const auto& [owner, leaf] : checked.leaves) highest = std::max(highest, leaf);
    CHECK(highest < 2 * 300);
    while (!checked.boxes.empty()) {
      checked.remove(checked.any_owner(random));
      REQUIRE(checked.tree.validate());
    }
    CHECK(checked.tree.is_empty());
  }
}

TEST_CASE("The height stays within three times the logarithm, for scattered boxes and for rows") {
  for (const bool in_a_row : {false, true}) {
    Random random(12);
    DynamicTree tree;
    for (std::uint32_t i = 0; i < 4096; ++i) {
      const auto x = static_cast<real>(i);
      tree.insert(in_a_row ? Aabb{{x, 0}, {x + 1, 1}} : random_box(random), i);
    }
    CHECK(tree.height() >= 12);
    CHECK(tree.height() <= 36);
    CHECK(tree.validate());
  }
}

TEST_CASE("A query looks at few boxes only: the perimeters in the tree stay small") {
  Random random(13);
  DynamicTree tree;
  for (std::uint32_t i = 0; i < 2000; ++i) {
    const Vec2 lower{real_between(random, 0, 100), real_between(random, 0, 100)};
    tree.insert(Aabb{lower, lower + Vec2{1, 1}}, i);
  }
  CHECK(tree.area_ratio() > real(1));
  CHECK(tree.area_ratio() < real(100));  // a tree that joins leaves at random comes to over a thousand
}

TEST_CASE("Boxes nested like onion skins make a deep tree that still finds everything") {
  DynamicTree tree;
  constexpr std::uint32_t count = 500;
  for (std::uint32_t i = 0; i < count; ++i) {
    const auto size = static_cast<real>(i + 1);
    tree.insert(Aabb{{-size, -size}, {size, size}}, i);
  }
  CHECK(tree.height() > 64);
  CHECK(found_in(tree, Aabb{{0, 0}, {0, 0}}).size() == count);
  CHECK(found_in(tree, Aabb{{0, 400}, {0, 401}}).size() == count - 399);
  CHECK(tree.validate());
}

TEST_CASE("A query stops as soon as it is told to") {
  Random random(14);
  DynamicTree tree;
  for (std::uint32_t i = 0; i < 100; ++i) tree.insert(random_box(random), i);
  int calls = 0;
  tree.query(Aabb{{0, 0}, {60, 60}}, [&](ProxyId, std::uint32_t) { return ++calls < 7; });
  CHECK(calls == 7);
}

TEST_CASE("All nodes are visited, parents before children and around them") {
  Random random(15);
  DynamicTree tree;
  for (std::uint32_t i = 0; i < 100; ++i) tree.insert(random_box(random), i);
  std::vector<Aabb> path;
  int nodes = 0;
  int leaves = 0;
  int deepest = 0;
  tree.visit([&](const Aabb& box, int depth, bool is_leaf) {
    REQUIRE(depth <= static_cast<int>(path.size()));
    path.resize(static_cast<std::size_t>(depth));
    if (!path.empty()) REQUIRE(contains(path.back(), box));
    path.push_back(box);
    ++nodes;
    leaves += is_leaf ? 1 : 0;
    deepest = std::max(deepest, depth);
  });
  CHECK(leaves == 100);
  CHECK(nodes == 199);
  CHECK(deepest == tree.height());
}

TEST_CASE("The same operations give the same tree everywhere, down to the order in which leaves are found") {
  Random random(16);
  Checked checked;
  for (int i = 0; i < 3000; ++i) checked.disturb(random);
  std::uint64_t sum = 0xcbf29ce484222325U;  // FNV-1a over the owners in order
  for (const std::uint32_t owner : found_in(checked.tree, Aabb{{0, 0}, {60, 60}})) {
    sum = (sum ^ owner) * 0x100000001b3U;
  }
  CHECK(sum == (sizeof(real) == 4 ? 0xacd93917ff1aa499U : 0xc401819eb8dec859U));
}

}  // namespace
}  // namespace proofreel
