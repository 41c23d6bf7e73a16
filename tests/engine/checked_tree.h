#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <map>
#include <utility>
#include <vector>

#include "engine/dynamic_tree.h"
#include "tests/engine/random.h"

namespace proofreel {

#ifdef NDEBUG
constexpr int thoroughness = 10;
#else
constexpr int thoroughness = 1;  // a tenth of the work where the code is slow
#endif

inline real real_between(Random& random, double low, double high) {
  return static_cast<real>(random.between(low, high));
}

inline Vec2 random_point(Random& random) { return {real_between(random, -5, 55), real_between(random, -5, 55)}; }

/// Within 0 .. 53, some as thin as a line, some as small as a point.
inline Aabb random_box(Random& random) {
  const Vec2 lower{real_between(random, 0, 50), real_between(random, 0, 50)};
  const std::uint32_t kind = random.below(10);
  const Vec2 size{real_between(random, 0, 3), real_between(random, 0, 3)};
  return {lower, lower + Vec2{kind < 2 ? real(0) : size.x, kind % 5 == 0 ? real(0) : size.y}};
}

/// The owners of two leaves, the smaller first.
using OwnerPair = std::pair<std::uint32_t, std::uint32_t>;

template <typename T>
std::vector<T> sorted(std::vector<T> values) {
  std::sort(values.begin(), values.end());
  return values;
}

/// The tree and, beside it, a plain list of what it should hold.
struct CheckedTree {
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
    const auto last = next_owner;
    const auto found = boxes.lower_bound(random.below(last));
    return found != boxes.end() ? found->first : boxes.begin()->first;
  }
  /// Inserts, moves, removes or changes one, or builds all anew, so that about `usual` boxes stay.
  void disturb(Random& random, std::size_t usual) {
    const std::uint32_t choice = random.below(1000);
    if (choice < 2) return tree.rebuild();
    if (boxes.empty() || choice < (boxes.size() < usual ? 300U : 150U)) return insert(random_box(random));
    const std::uint32_t owner = any_owner(random);
    if (choice < 400) return remove(owner);
    Aabb& box = boxes[owner];
    if (choice < 600) {
      box = random_box(random);
      tree.move(leaves.at(owner), box);
    } else if (choice < 800) {
      const Vec2 way{real_between(random, -1, 1), real_between(random, -1, 1)};
      box = {box.lower + way, box.upper + way};
      tree.move(leaves.at(owner), box);
    } else {
      box = expanded(box, real_between(random, 0, 0.1));
      tree.refit(leaves.at(owner), box);
    }
  }

  std::vector<std::uint32_t> found(const Aabb& box) const {
    std::vector<std::uint32_t> owners;
    tree.query(box, [&](ProxyId leaf, std::uint32_t owner) {
      if (tree.owner(leaf) == owner) owners.push_back(owner);
      return true;
    });
    return owners;
  }
  std::vector<std::uint32_t> overlapping(const Aabb& box) const {
    std::vector<std::uint32_t> owners;
    for (const auto& [owner, stored] : boxes) {
      if (overlaps(stored, box)) owners.push_back(owner);
    }
    return owners;
  }
  OwnerPair owners_of(ProxyId a, ProxyId b) const { return std::minmax({tree.owner(a), tree.owner(b)}); }
  std::vector<OwnerPair> overlapping_pairs() const {
    std::vector<OwnerPair> pairs;
    for (auto a = boxes.begin(); a != boxes.end(); ++a) {
      for (auto b = std::next(a); b != boxes.end(); ++b) {
        if (overlaps(a->second, b->second)) pairs.emplace_back(a->first, b->first);
      }
    }
    return pairs;
  }
};

inline std::vector<Aabb> nested_boxes(int count) {
  std::vector<Aabb> boxes;
  for (int i = 1; i <= count; ++i) {
    const auto size = static_cast<real>(i);
    boxes.push_back({{-size, -size}, {size, size}});
  }
  return boxes;
}

/// Unit squares from the origin along the x axis, each touching the next.
inline std::vector<Aabb> boxes_in_a_row(int count) {
  std::vector<Aabb> boxes;
  for (int i = 0; i < count; ++i) {
    const auto x = static_cast<real>(i);
    boxes.push_back({{x, 0}, {x + 1, 1}});
  }
  return boxes;
}

struct NamedBoxes {
  const char* name;
  std::vector<Aabb> boxes;
};

/// Boxes that are unkind to trees, `count` of each kind.
inline std::vector<NamedBoxes> unkind_boxes(int count) {
  const auto size = static_cast<std::size_t>(count);
  NamedBoxes doubling{"each twice as far as the one before", {}};
  NamedBoxes huge{"a billion metres away", {}};
  for (int i = 0; i < count; ++i) {
    const auto x = static_cast<real>(i);
    const real far = std::ldexp(real(1), i % 30);
    doubling.boxes.push_back({{far, 0}, {real(1.5) * far, 1}});
    huge.boxes.push_back({{real(1e9) - 64 * x, real(-1e9)}, {real(1e9) - 64 * x + 100, real(-1e9) + 128}});
  }
  return {{"all equal", std::vector<Aabb>(size, Aabb{{1, 2}, {3, 4}})},
          {"points in one place", std::vector<Aabb>(size, Aabb{{5, 5}, {5, 5}})},
          {"nested like onion skins", nested_boxes(count)},
          {"in a row, touching", boxes_in_a_row(count)},
          doubling,
          huge};
}

}  // namespace proofreel
