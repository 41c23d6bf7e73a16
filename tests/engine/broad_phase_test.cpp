#include "engine/broad_phase.h"

#include <catch2/catch.hpp>
#include <set>

#include "tests/engine/checked_tree.h"

namespace proofreel {
namespace {

/// Shapes on bodies of their own, and beside them what the broad phase should have told.
struct CheckedPhase {
  BroadPhase phase;
  std::vector<Shape> shapes;
  std::vector<Body> bodies;
  std::vector<Aabb> boxes;  ///< tight
  std::set<OwnerPair> contacts;

  ShapeIndex add(const Aabb& box, BodyType type = BodyType::dynamic) {
    const auto index = static_cast<ShapeIndex>(shapes.size());
    shapes.emplace_back().body = static_cast<BodyIndex>(bodies.size());
    shapes.back().hull.thickness = 1;
    bodies.emplace_back().type = type;
    boxes.push_back(box);
    phase.add(index, shapes.back(), box);
    return index;
  }
  void remove(ShapeIndex index) {
    phase.remove(index, shapes[index]);
    shapes[index].alive = false;
    std::erase_if(contacts, [&](OwnerPair pair) {
      if (pair.first != index && pair.second != index) return false;
      phase.forget({pair.first, pair.second});
      return true;
    });
  }
  void move(ShapeIndex index, Vec2 way) {
    boxes[index] = {boxes[index].lower + way, boxes[index].upper + way};
    phase.move(index, shapes[index], boxes[index], way);
  }
  const Aabb& fat(ShapeIndex index) const { return phase.tree().aabb(shapes[index].proxy); }

  /// What a world does at each tick. Returns what is new.
  std::vector<OwnerPair> update() {
    std::erase_if(contacts, [&](OwnerPair pair) {
      if (phase.boxes_overlap(shapes[pair.first], shapes[pair.second])) return false;
      phase.forget({pair.first, pair.second});
      return true;
    });
    std::vector<OwnerPair> found;
    for (const ShapePair pair : phase.new_pairs(shapes, bodies)) {
      found.emplace_back(pair.a, pair.b);
      REQUIRE(contacts.insert(found.back()).second);
    }
    return found;
  }
  bool may_meet(ShapeIndex a, ShapeIndex b) const {
    const Body& first = bodies[shapes[a].body];
    const Body& second = bodies[shapes[b].body];
    return shapes[a].alive && shapes[b].alive && shapes[a].body != shapes[b].body &&
           (first.type == BodyType::dynamic || second.type == BodyType::dynamic) &&
           filters_agree(first.filter, second.filter);
  }
  std::set<OwnerPair> brute_force() const {
    std::set<OwnerPair> pairs;
    for (ShapeIndex a = 0; a < shapes.size(); ++a) {
      for (ShapeIndex b = a + 1; b < shapes.size(); ++b) {
        if (may_meet(a, b) && overlaps(fat(a), fat(b))) pairs.emplace(a, b);
      }
    }
    return pairs;
  }
  std::set<OwnerPair> traversed() const {
    std::set<OwnerPair> pairs;
    phase.tree().for_each_pair([&](ProxyId p, ProxyId q) {
      const OwnerPair pair = std::minmax({phase.tree().owner(p), phase.tree().owner(q)});
      if (may_meet(pair.first, pair.second)) pairs.insert(pair);
    });
    return pairs;
  }
};

TEST_CASE("The pairs kept step by step are all pairs, and those of a traversal, at every step") {
  Random random(41);
  CheckedPhase checked;
  std::vector<Vec2> velocities;
  for (int i = 0; i < 80; ++i) {
    const Vec2 lower{real_between(random, 0, 15), real_between(random, 0, 15)};
    checked.add({lower, lower + Vec2{1, 1}}, i % 7 == 0 ? BodyType::fixed : BodyType::dynamic);
    velocities.push_back({real_between(random, -0.3, 0.3), real_between(random, -0.3, 0.3)});
  }
  for (int step = 0; step < thoroughness * 50; ++step) {
    for (ShapeIndex i = 0; i < checked.shapes.size(); ++i) {
      if (i % 7 == 0 || !checked.shapes[i].alive) continue;
      if (random.below(20) == 0) velocities[i] = -velocities[i];
      checked.move(i, velocities[i]);
    }
    const std::uint32_t victim = random.below(80);
    if (step % 40 == 39 && checked.shapes[victim].alive) checked.remove(victim);
    checked.update();
    const std::set<OwnerPair> expected = checked.brute_force();
    REQUIRE(checked.contacts == expected);
    REQUIRE(checked.traversed() == expected);
    REQUIRE(checked.phase.tree().validate());
  }
  CHECK_FALSE(checked.contacts.empty());
}

TEST_CASE("New pairs come in ascending order, whatever the order of the shapes in the tree") {
  Random random(42);
  CheckedPhase checked;
  for (int i = 0; i < 200; ++i) checked.add(random_box(random));
  const std::vector<OwnerPair> pairs = checked.update();
  CHECK(pairs.size() > 50);
  CHECK(pairs == sorted(pairs));
}

TEST_CASE("A pair is told once while it lasts, and again after it was forgotten and moves again") {
  CheckedPhase checked;
  checked.add({{0, 0}, {1, 1}});
  checked.add({{real(0.5), 0}, {real(1.5), 1}});
  CHECK(checked.update() == std::vector<OwnerPair>{{0, 1}});
  checked.move(0, {real(0.3), 0});
  CHECK(checked.update().empty());
  checked.move(0, {-5, 0});
  CHECK(checked.update().empty());
  CHECK(checked.contacts.empty());
  checked.move(0, {5, 0});
  CHECK(checked.update() == std::vector<OwnerPair>{{0, 1}});
}

TEST_CASE("Shapes of one body, two that nothing moves and two whose filters disagree are no pair") {
  const Aabb box{{0, 0}, {1, 1}};
  CheckedPhase fixed;
  fixed.add(box, BodyType::fixed);
  fixed.add(box, BodyType::kinematic);
  CHECK(fixed.update().empty());
  CheckedPhase siblings;
  siblings.add(box);
  siblings.add(box);
  siblings.shapes[1].body = 0;
  CHECK(siblings.update().empty());
  CheckedPhase strangers;
  strangers.add(box);
  strangers.add(box);
  for (Body& body : strangers.bodies) body.filter.group = -1;
  CHECK(strangers.update().empty());
}

TEST_CASE("A box stays while its shape with all its way is inside, and then reaches ahead of it") {
  CheckedPhase checked;
  checked.add({{0, 0}, {1, 1}});
  checked.move(0, {real(0.5), 0});
  const Aabb fat = checked.fat(0);
  CHECK(fat.lower.x == Approx(0.4));
  CHECK(fat.upper.x == Approx(1.5 + 0.1 + 4 * 0.5));
  CHECK(fat.upper.y == Approx(1.1));
  checked.move(0, {real(0.5), 0});
  CHECK(checked.fat(0).upper.x == fat.upper.x);
  for (int i = 0; i < 3; ++i) checked.move(0, {real(0.5), 0});
  CHECK(checked.fat(0).upper.x > fat.upper.x);
}

TEST_CASE("A shape removed and added again between two ticks is looked at under its new name") {
  CheckedPhase checked;
  checked.add({{0, 0}, {1, 1}});
  checked.add({{5, 0}, {6, 1}});
  checked.update();
  checked.move(0, {real(0.5), 0});
  checked.phase.remove(0, checked.shapes[0]);
  checked.phase.remove(1, checked.shapes[1]);
  checked.phase.add(1, checked.shapes[1], {{5, 0}, {6, 1}});
  checked.phase.add(0, checked.shapes[0], {{5, 0}, {6, 1}});
  CHECK(checked.update() == std::vector<OwnerPair>{{0, 1}});
}

}  // namespace
}  // namespace proofreel
