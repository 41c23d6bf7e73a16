#include "engine/dynamic_tree.h"

#include <catch2/catch.hpp>
#include <limits>

#include "tests/engine/checked_tree.h"

namespace proofreel {
namespace {

/// Counts the events of one kind.
template <typename Wanted>
struct Count {
  int count = 0;
  Observer observer{[this](const Event& event) { count += std::holds_alternative<Wanted>(event) ? 1 : 0; }};
};

TEST_CASE("An empty tree finds nothing and has no height") {
  DynamicTree tree;
  tree.rebuild();
  CHECK(tree.is_empty());
  CHECK(tree.height() == 0);
  CHECK(tree.area_ratio() == real(0));
  CHECK(tree.validate());
  tree.visit([](const Aabb&, int, bool) { FAIL("there is no node to visit"); });
}

TEST_CASE("A single leaf keeps its name and is found by what touches its box and by nothing else") {
  CheckedTree checked;
  checked.insert({{0, 0}, {1, 1}});
  const ProxyId leaf = checked.leaves.at(0);
  CHECK(checked.found({{1, 1}, {2, 2}}) == std::vector<std::uint32_t>{0});
  CHECK(checked.found({{1.5, 0}, {2, 2}}).empty());
  checked.tree.move(leaf, Aabb{{5, 5}, {6, 6}});
  checked.tree.rebuild();
  CHECK(checked.found({{1, 1}, {2, 2}}).empty());
  CHECK(checked.found({{6, 6}, {7, 7}}).size() == 1);
  checked.tree.refit(leaf, Aabb{{7, 7}, {8, 8}});
  CHECK(checked.tree.aabb(leaf).lower == Vec2{7, 7});
  CHECK(checked.tree.height() == 0);
  CHECK(checked.tree.validate());
  checked.tree.remove(leaf);
  CHECK(checked.tree.is_empty());
}

TEST_CASE("All invariants hold whatever is inserted, moved, refitted, removed and rebuilt") {
  Random random(10);
  CheckedTree checked;
  for (int i = 0; i < thoroughness * 10'000; ++i) {
    checked.disturb(random, 300);
    if (i < 3000 || i % 200 == 0) REQUIRE(checked.tree.validate());
    if (i % 200 != 0) continue;
    for (const auto& [owner, leaf] : checked.leaves) {
      REQUIRE(checked.tree.owner(leaf) == owner);
      REQUIRE(checked.tree.aabb(leaf).lower == checked.boxes.at(owner).lower);
      REQUIRE(checked.tree.aabb(leaf).upper == checked.boxes.at(owner).upper);
    }
  }
}

TEST_CASE("Everything can be removed again, in any order, and the space is used anew") {
  Random random(11);
  CheckedTree checked;
  for (int round = 0; round < 3; ++round) {
    for (int i = 0; i < 300; ++i) checked.insert(random_box(random));
    if (round == 1) checked.tree.rebuild();
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
    tree.rebuild();
    CHECK(tree.height() >= 12);
    CHECK(tree.height() <= 24);
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

TEST_CASE("Rebuilding makes a tree good again that refitting has spoilt, and rebuilding twice changes nothing") {
  Random random(14);
  CheckedTree checked;
  for (int i = 0; i < 1000; ++i) checked.insert(random_box(random));
  const real inserted = checked.tree.area_ratio();
  for (const auto& [owner, leaf] : checked.leaves) checked.tree.refit(leaf, checked.boxes[owner] = random_box(random));
  CHECK(checked.tree.area_ratio() > 2 * inserted);
  checked.tree.rebuild();
  CHECK(checked.tree.area_ratio() < real(1.05) * inserted);
  const std::vector<std::uint32_t> order = checked.found({{0, 0}, {60, 60}});
  checked.tree.rebuild();
  CHECK(checked.found({{0, 0}, {60, 60}}) == order);
}

TEST_CASE("A rebuilt tree is sound and flat wherever its boxes lie") {
  for (const NamedBoxes& unkind : unkind_boxes(500)) {
    INFO(unkind.name);
    DynamicTree tree;
    for (std::uint32_t i = 0; i < unkind.boxes.size(); ++i) tree.insert(unkind.boxes[i], i);
    CHECK(tree.validate());
    tree.rebuild();
    CHECK(tree.validate());
    CHECK(tree.height() >= 9);
    CHECK(tree.height() <= 20);
  }
}

TEST_CASE("Boxes inserted like onion skins make a deep tree that still finds everything") {
  CheckedTree checked;
  for (const Aabb& box : nested_boxes(500)) checked.insert(box);
  CHECK(checked.tree.height() > 64);
  CHECK(checked.found({{0, 0}, {0, 0}}).size() == 500);
  CHECK(checked.found({{0, 400}, {0, 401}}).size() == 500 - 399);
}

TEST_CASE("A box that stays beside its sibling is refitted, one that goes elsewhere is inserted again") {
  DynamicTree tree;
  const ProxyId leaf = tree.insert({{0, 0}, {1, 1}}, 0);
  tree.insert({{1, 0}, {2, 1}}, 1);
  tree.insert({{50, 0}, {51, 1}}, 2);
  tree.insert({{52, 0}, {53, 1}}, 3);
  Count<SiblingTested> tested;
  tree.move(leaf, {{real(0.2), 0}, {real(1.2), 1}}, tested.observer);
  CHECK(tested.count == 0);
  tree.move(leaf, {{51, 0}, {52, 1}}, tested.observer);
  CHECK(tested.count > 0);
  CHECK(tree.validate());
}

TEST_CASE("An insertion tells which nodes it weighed, takes the cheapest and is not changed by being watched") {
  Random random(15);
  DynamicTree watched;
  DynamicTree alone;
  double least = 0;
  int chosen = 0;
  Count<NodesRotated> rotated;
  const Observer observer([&](const Event& event) {
    if (const auto* tested = std::get_if<SiblingTested>(&event)) least = std::min(least, tested->cost);
    if (const auto* taken = std::get_if<SiblingChosen>(&event)) chosen += taken->cost == least ? 1 : 0;
    if (std::holds_alternative<NodesRotated>(event)) ++rotated.count;
  });
  for (std::uint32_t i = 0; i < 300; ++i) {
    const Aabb box = random_box(random);
    least = std::numeric_limits<double>::infinity();
    REQUIRE(watched.insert(box, i, observer) == alone.insert(box, i));
  }
  CHECK(chosen == 299);  // the first one has no sibling
  CHECK(rotated.count > 0);
  CHECK(watched.area_ratio() == alone.area_ratio());
}

TEST_CASE("A removal tells of the rotations it brings about") {
  Random random(16);
  CheckedTree checked;
  for (int i = 0; i < 300; ++i) checked.insert(random_box(random));
  Count<NodesRotated> rotated;
  for (const auto& [owner, leaf] : checked.leaves) checked.tree.remove(leaf, rotated.observer);
  CHECK(rotated.count > 0);
  CHECK(checked.tree.is_empty());
}

TEST_CASE("All nodes are visited, parents before children and around them") {
  Random random(17);
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
  Random random(18);
  CheckedTree checked;
  for (int i = 0; i < 3000; ++i) checked.disturb(random, 300);
  std::uint64_t sum = 0xcbf29ce484222325U;  // FNV-1a over the owners in order
  for (const std::uint32_t owner : checked.found({{-9, -9}, {60, 60}})) sum = (sum ^ owner) * 0x100000001b3U;
  CHECK(sum == (sizeof(real) == 4 ? 0x6eb6636264fed9e2U : 0x2bef95e3d4996818U));
}

}  // namespace
}  // namespace proofreel
