#include <catch2/catch.hpp>
#include <limits>

#include "engine/dynamic_tree.h"
#include "tests/engine/checked_tree.h"

namespace proofreel {
namespace {

struct Ray {
  Vec2 origin;
  Vec2 translation;
  real max_fraction = 1;
};

Ray random_ray(Random& random) {
  const Vec2 origin = random_point(random);
  const Vec2 way = random_point(random) - origin;
  const std::uint32_t kind = random.below(6);
  const Vec2 translation{kind == 0 ? real(0) : way.x, kind == 1 ? real(0) : way.y};
  return {origin, translation, real_between(random, 0.1, 1.5)};
}

real entry_of(const Ray& ray, const Aabb& box, real max_fraction) {
  return BasicRay<real>(ray.origin, ray.translation).entry_into(box, max_fraction);
}

/// Owners of all boxes the ray meets.
std::vector<std::uint32_t> hit_by(const DynamicTree& tree, const Ray& ray) {
  std::vector<std::uint32_t> owners;
  tree.cast_ray(ray.origin, ray.translation, ray.max_fraction, [&](ProxyId, std::uint32_t owner, real max_fraction) {
    owners.push_back(owner);
    return max_fraction;
  });
  return owners;
}

/// The fraction at which the ray enters its first box; beyond max_fraction when there is none.
real first_hit(const DynamicTree& tree, const Ray& ray) {
  real first = std::numeric_limits<real>::infinity();
  tree.cast_ray(ray.origin, ray.translation, ray.max_fraction, [&](ProxyId leaf, std::uint32_t, real max_fraction) {
    return first = entry_of(ray, tree.aabb(leaf), max_fraction);
  });
  return first;
}

std::optional<NearestLeaf> nearest_box(const DynamicTree& tree, Vec2 point, real limit) {
  return tree.nearest(point, limit, [&](ProxyId leaf, std::uint32_t) { return distance(tree.aabb(leaf), point); });
}

void check_query(const CheckedTree& checked, const Aabb& box) {
  REQUIRE(sorted(checked.found(box)) == checked.overlapping(box));
}

void check_ray(const CheckedTree& checked, const Ray& ray) {
  std::vector<std::uint32_t> hit;
  real first = std::numeric_limits<real>::infinity();
  for (const auto& [owner, box] : checked.boxes) {
    const real entry = entry_of(ray, box, ray.max_fraction);
    if (entry <= ray.max_fraction) hit.push_back(owner);
    first = std::min(first, entry);
  }
  REQUIRE(sorted(hit_by(checked.tree, ray)) == hit);
  REQUIRE(first_hit(checked.tree, ray) == first);
}

void check_nearest(const CheckedTree& checked, Vec2 point, real limit) {
  std::optional<std::pair<real, std::uint32_t>> expected;
  for (const auto& [owner, box] : checked.boxes) {
    const real away = distance(box, point);
    if (away <= limit && (!expected || away < expected->first)) expected = {away, owner};
  }
  const std::optional<NearestLeaf> found = nearest_box(checked.tree, point, limit);
  REQUIRE(found.has_value() == expected.has_value());
  if (!found) return;
  REQUIRE(found->distance == expected->first);
  REQUIRE(checked.tree.owner(found->leaf) == expected->second);
}

std::vector<OwnerPair> traversed_pairs(const CheckedTree& checked) {
  std::vector<OwnerPair> pairs;
  checked.tree.for_each_pair([&](ProxyId a, ProxyId b) { pairs.push_back(checked.owners_of(a, b)); });
  return sorted(pairs);
}

std::vector<OwnerPair> queried_pairs(const CheckedTree& checked) {
  std::vector<OwnerPair> pairs;
  for (const auto& [owner, box] : checked.boxes) {
    for (const std::uint32_t other : checked.found(box)) {
      if (owner < other) pairs.emplace_back(owner, other);
    }
  }
  return sorted(pairs);
}

void check_pairs(const CheckedTree& checked) {
  const std::vector<OwnerPair> expected = checked.overlapping_pairs();
  REQUIRE(traversed_pairs(checked) == expected);
  REQUIRE(queried_pairs(checked) == expected);
}

/// Of every third leaf.
void check_pairs_of_some(const CheckedTree& checked) {
  std::vector<ProxyId> leaves;
  for (const auto& [owner, leaf] : checked.leaves) {
    if (owner % 3 == 0) leaves.push_back(leaf);
  }
  std::vector<OwnerPair> pairs;
  checked.tree.for_each_pair_of(leaves, [&](ProxyId a, ProxyId b) { pairs.push_back(checked.owners_of(a, b)); });
  std::vector<OwnerPair> expected = checked.overlapping_pairs();
  std::erase_if(expected, [](OwnerPair pair) { return pair.first % 3 != 0 && pair.second % 3 != 0; });
  REQUIRE(sorted(pairs) == expected);
}

void check_all(const CheckedTree& checked, Random& random) {
  check_query(checked, expanded(random_box(random), real(2)));
  check_query(checked, random_box(random));
  check_ray(checked, random_ray(random));
  check_nearest(checked, random_point(random), random.below(3) == 0 ? real(1) : real(100));
}

TEST_CASE("Queries, rays and the nearest are what brute force finds, whatever happened to the tree before") {
  Random random(31);
  CheckedTree checked;
  for (int i = 0; i < thoroughness * 2000; ++i) {
    checked.disturb(random, 200);
    if (i % 5 == 0) check_all(checked, random);
  }
}

TEST_CASE("Pairs are what brute force finds at every step, by the traversal and by queries") {
  Random random(32);
  CheckedTree checked;
  for (int i = 0; i < thoroughness * 400; ++i) {
    checked.disturb(random, 60);
    check_pairs(checked);
    check_pairs_of_some(checked);
  }
}

TEST_CASE("Everything is found among boxes that are unkind to trees, inserted or rebuilt") {
  for (const NamedBoxes& unkind : unkind_boxes(150)) {
    INFO(unkind.name);
    CheckedTree checked;
    for (const Aabb& box : unkind.boxes) checked.insert(box);
    for (const bool rebuilt : {false, true}) {
      if (rebuilt) checked.tree.rebuild();
      check_pairs(checked);
      check_pairs_of_some(checked);
      for (const Aabb& box : {unkind.boxes.front(), unkind.boxes[77], unkind.boxes.back()}) {
        check_query(checked, box);
        check_ray(checked, {box.lower, box.upper - box.lower, 2});
        check_ray(checked, {box.lower - Vec2{200, 100}, Vec2{400, 200}, 1});
        check_nearest(checked, box.lower - Vec2{30, 10}, 1000);
      }
    }
  }
}

TEST_CASE("A query stops as soon as it is told to") {
  Random random(33);
  DynamicTree tree;
  for (std::uint32_t i = 0; i < 100; ++i) tree.insert(random_box(random), i);
  int calls = 0;
  tree.query(Aabb{{0, 0}, {60, 60}}, [&](ProxyId, std::uint32_t) { return ++calls < 7; });
  CHECK(calls == 7);
}

TEST_CASE("An empty tree has no pairs, no hits and nothing near") {
  const DynamicTree tree;
  int found = 0;
  const auto count = [&](ProxyId, std::uint32_t) { return ++found > 0; };
  tree.query({{-9, -9}, {9, 9}}, count);
  const auto count_pair = [&](ProxyId, ProxyId) { ++found; };
  tree.for_each_pair(count_pair);
  tree.for_each_pair_of({}, count_pair);
  CHECK(found == 0);
  CHECK(hit_by(tree, {{0, 0}, {1, 1}}).empty());
  CHECK_FALSE(nearest_box(tree, {0, 0}, 100).has_value());
}

TEST_CASE("A leaf is no pair with itself, and two equal boxes are one") {
  CheckedTree checked;
  checked.insert({{0, 0}, {1, 1}});
  CHECK(traversed_pairs(checked).empty());
  checked.insert({{0, 0}, {1, 1}});
  CHECK(traversed_pairs(checked) == std::vector<OwnerPair>{{0, 1}});
}

TEST_CASE("Rays meet a box they start in, touch at a corner, run along or only just reach") {
  DynamicTree tree;
  tree.insert({{1, 1}, {3, 2}}, 0);
  const auto hits = [&](Ray ray) { return hit_by(tree, ray).size() == 1; };
  CHECK(hits({{2, 1.5}, {5, 5}}));
  CHECK(first_hit(tree, {{2, 1.5}, {5, 5}}) == real(0));
  CHECK(hits({{0, 2}, {2, -2}}));  // through the corner (1, 1)
  CHECK(hits({{0, 1}, {9, 0}}));   // along an edge
  CHECK(hits({{3, 9}, {0, -9}}));
  CHECK(hits({{0, 1.5}, {1, 0}}));  // ends at the edge
  CHECK(hits({{3, 2}, {1, 1}}));    // starts at a corner and goes away
  CHECK_FALSE(hits({{0, 1.5}, {0.875, 0}}));
  CHECK_FALSE(hits({{0, 1.5}, {9, 0}, 0.0625}));
  CHECK_FALSE(hits({{3.125, 2}, {1, 0}}));
  CHECK_FALSE(hits({{0, 0.875}, {9, 0}}));
  CHECK_FALSE(hits({{4, 1.5}, {1, 0}}));  // behind the origin
}

TEST_CASE("A ray of length zero meets what lies around its origin") {
  DynamicTree tree;
  tree.insert({{1, 1}, {3, 2}}, 0);
  tree.insert({{5, 5}, {6, 6}}, 1);
  CHECK(hit_by(tree, {{3, 2}, {0, 0}}) == std::vector<std::uint32_t>{0});
  CHECK(hit_by(tree, {{4, 4}, {0, 0}}).empty());
  CHECK(hit_by(tree, {{2, 1.5}, {std::numeric_limits<real>::denorm_min(), 0}}).size() == 1);
}

TEST_CASE("A ray that grazes corners far from the origin misses none of them") {
  Random random(34);
  for (int i = 0; i < thoroughness * 1000; ++i) {
    const Vec2 origin{real_between(random, -1e6, 1e6), real_between(random, -1e6, 1e6)};
    const Vec2 corner{real_between(random, -1e6, 1e6), real_between(random, -1e6, 1e6)};
    DynamicTree tree;
    tree.insert({corner, corner}, 0);
    REQUIRE(hit_by(tree, {origin, corner - origin, 2}).size() == 1);
  }
}

TEST_CASE("A ray told to stop hits nothing more, and nearer boxes come first") {
  CheckedTree checked;
  for (const Aabb& box : boxes_in_a_row(100)) checked.insert(box);
  std::vector<std::uint32_t> seen;
  checked.tree.cast_ray({-5, 0.5}, {300, 0}, 1, [&](ProxyId, std::uint32_t owner, real) {
    seen.push_back(owner);
    return seen.size() < 3 ? real(1) : real(-1);
  });
  CHECK(seen == std::vector<std::uint32_t>{0, 1, 2});
}

TEST_CASE("Of several equally near the smallest owner is the nearest, and the limit itself is near enough") {
  CheckedTree checked;
  for (const real x : {real(5), real(3), real(-3), real(3), real(-7)}) checked.insert({{x, 0}, {x, 0}});
  checked.tree.rebuild();
  const std::optional<NearestLeaf> found = nearest_box(checked.tree, {0, 0}, 3);
  REQUIRE(found.has_value());
  CHECK(checked.tree.owner(found->leaf) == 1);
  CHECK(found->distance == real(3));
  CHECK_FALSE(nearest_box(checked.tree, {0, 0}, real(2.99)).has_value());
}

TEST_CASE("The nearest is told by the owner's own distance, not by its box") {
  DynamicTree tree;
  tree.insert({{1, 0}, {2, 1}}, 0);
  tree.insert({{3, 0}, {4, 1}}, 1);
  const auto found =
      tree.nearest({0, 0}, 100, [](ProxyId, std::uint32_t owner) { return owner == 0 ? real(9) : real(4); });
  REQUIRE(found.has_value());
  CHECK(tree.owner(found->leaf) == 1);
}

/// What an observer of queries, casts and traversals counts.
struct Visits {
  int nodes = 0;
  int entered = 0;  ///< inner nodes
  int leaves = 0;   ///< not pruned
  bool honest = true;
  Observer observer{[this](const Event& event) {
    if (const auto* node = std::get_if<NodeVisited>(&event)) add(node->leaf, node->pruned);
    if (const auto* pair = std::get_if<PairVisited>(&event)) {
      add(pair->leaves, pair->pruned);
      honest = honest && overlaps(pair->a, pair->b) != pair->pruned;
    }
  }};

  void add(bool leaf, bool pruned) {
    ++nodes;
    if (!pruned) ++(leaf ? leaves : entered);
  }
};

TEST_CASE("The events of a search suffice to recount what it looked at and what it found") {
  Random random(35);
  CheckedTree checked;
  for (int i = 0; i < 2000; ++i) checked.insert(random_box(random));
  Visits query;
  int found = 0;
  checked.tree.query(
      {{10, 10}, {12, 12}}, [&](ProxyId, std::uint32_t) { return ++found > 0; }, query.observer);
  CHECK(query.leaves == found);
  CHECK(query.nodes == 1 + 2 * query.entered);
  CHECK(query.nodes < 400);

  Visits cast;
  int hits = 0;
  const auto count = [&](ProxyId, std::uint32_t, real max_fraction) { return ++hits, max_fraction; };
  checked.tree.cast_ray({0, 0}, {50, 40}, 1, count, cast.observer);
  CHECK(cast.leaves == hits);
  CHECK(cast.nodes == 1 + 2 * cast.entered);

  Visits near;
  checked.tree.nearest(
      {25, 25}, 100, [](ProxyId, std::uint32_t) { return real(9); }, near.observer);
  CHECK(near.nodes <= 1 + 2 * near.entered);
  CHECK(near.nodes > checked.tree.height());

  Visits pairs;
  int overlapping = 0;
  checked.tree.for_each_pair([&](ProxyId, ProxyId) { ++overlapping; }, pairs.observer);
  CHECK(pairs.leaves == overlapping);
  CHECK(pairs.honest);
  CHECK(pairs.nodes < 2000 * 60);
}

TEST_CASE("A ray that looks for its first hit visits far fewer nodes than one that looks for all") {
  CheckedTree checked;
  for (const Aabb& box : boxes_in_a_row(1000)) checked.insert(box);
  Visits first;
  Visits all;
  const Ray ray{{-5, 0.5}, {2000, 0}};
  const auto stop_here = [&](ProxyId leaf, std::uint32_t, real max_fraction) {
    return entry_of(ray, checked.tree.aabb(leaf), max_fraction);
  };
  const auto go_on = [](ProxyId, std::uint32_t, real max_fraction) { return max_fraction; };
  checked.tree.cast_ray(ray.origin, ray.translation, 1, stop_here, first.observer);
  checked.tree.cast_ray(ray.origin, ray.translation, 1, go_on, all.observer);
  CHECK(all.nodes == 1999);
  CHECK(first.nodes < 60);
}

}  // namespace
}  // namespace proofreel
