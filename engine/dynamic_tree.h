#pragma once

/// Bounding-volume hierarchy of the broad phase (thesis chapter 4.1, BBTree): a binary tree of axis-aligned boxes in
/// which every inner node's box is the smallest around its two children. A query goes down only where boxes overlap,
/// so among n boxes it costs O(log n + found) when the tree is good.
///
/// What makes a tree good is the surface-area heuristic (Goldsmith and Salmon 1987): the chance that a query enters a
/// node grows with its box, so the sum of the inner boxes' perimeters should be small. A new leaf goes where it adds
/// least, and on the way back up subtrees are rotated where that makes a box smaller (Catto, GDC 2019). That keeps the
/// height near log n for boxes side by side; boxes nested like onion skins make a tree as deep as they are many, in
/// which everything stays right but nothing is fast.
///
/// The nodes lie in one array and are linked by index. The tree depends on nothing but the order of the operations.

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "engine/real.h"

namespace proofreel {
inline namespace PROOFREEL_PRECISION {

/// A leaf's name from `insert` until `remove`; may be given out again after that.
using ProxyId = std::int32_t;

class DynamicTree {
 public:
  /// Boxes are stored as given: make them larger than the shape, and a body that moves a little needs no `move`.
  /// `owner` is the caller's own number.
  ProxyId insert(const Aabb& box, std::uint32_t owner);
  void remove(ProxyId leaf);
  /// Takes the leaf out and puts it in again with another box; its name stays.
  void move(ProxyId leaf, const Aabb& box);

  const Aabb& aabb(ProxyId leaf) const { return node(leaf).box; }
  std::uint32_t owner(ProxyId leaf) const { return node(leaf).owner; }

  /// Calls found(leaf, owner) for every leaf whose box overlaps `box`, until it returns false. It must not change the
  /// tree.
  template <typename Found>
  void query(const Aabb& box, Found&& found) const {
    if (root_ != none && overlaps(node(root_).box, box)) query_below(root_, box, found);
  }

  /// Calls visited(box, depth, is_leaf) for every node, parents before children; the root has depth 0.
  template <typename Visited>
  void visit(Visited&& visited) const;

  bool is_empty() const { return root_ == none; }
  /// Edges from the root to the deepest leaf; 0 for a tree of one leaf or none.
  int height() const { return root_ == none ? 0 : node(root_).height; }
  /// The perimeters of all inner nodes over that of the root: the lower, the fewer boxes a query has to look at.
  real area_ratio() const;
  /// Whether all links, heights and boxes agree with each other; for tests.
  bool validate() const;

 private:
  using NodeId = std::int32_t;
  static constexpr NodeId none = -1;

  struct Node {
    Aabb box;
    NodeId parent = none;  ///< of a free node: the next free one
    std::array<NodeId, 2> children{none, none};
    int height = 0;  ///< 0 for a leaf
    std::uint32_t owner = 0;
    bool is_leaf() const { return height == 0; }
  };

  Node& node(NodeId id) { return nodes_[static_cast<std::size_t>(id)]; }
  const Node& node(NodeId id) const { return nodes_[static_cast<std::size_t>(id)]; }

  NodeId allocate();
  void free(NodeId id);
  void link(NodeId leaf);
  void unlink(NodeId leaf);
  NodeId best_sibling(const Aabb& box) const;
  void put_in_place(NodeId old_child, NodeId new_child, NodeId parent);
  void repair_upwards(NodeId id);
  void refit(NodeId id);
  void rotate(NodeId id);
  void swap_with_grandchild(NodeId id, int child, int grandchild);
  bool node_is_sound(NodeId id) const;

  template <typename Found>
  bool query_below(NodeId id, const Aabb& box, Found& found) const;

  std::vector<Node> nodes_;
  NodeId root_ = none;
  NodeId first_free_ = none;
};

/// The nodes still to be entered wait on a small stack of fixed size; a tree so deep that it overflows goes on in a
/// nested call with the next one. Returns false when `found` has had enough.
template <typename Found>
bool DynamicTree::query_below(NodeId id, const Aabb& box, Found& found) const {
  std::array<NodeId, 64> waiting;
  std::size_t count = 0;
  waiting[count++] = id;
  while (count > 0) {
    const NodeId next = waiting[--count];
    const Node& entered = node(next);
    if (entered.is_leaf()) {
      if (!found(next, entered.owner)) return false;
      continue;
    }
    for (const NodeId child : entered.children) {
      if (!overlaps(node(child).box, box)) continue;
      if (count < waiting.size()) {
        waiting[count++] = child;
      } else if (!query_below(child, box, found)) {
        return false;
      }
    }
  }
  return true;
}

template <typename Visited>
void DynamicTree::visit(Visited&& visited) const {
  struct Waiting {
    NodeId id;
    int depth;
  };
  std::vector<Waiting> waiting;
  if (root_ != none) waiting.push_back({root_, 0});
  while (!waiting.empty()) {
    const Waiting next = waiting.back();
    waiting.pop_back();
    const Node& visited_node = node(next.id);
    visited(visited_node.box, next.depth, visited_node.is_leaf());
    if (visited_node.is_leaf()) continue;
    waiting.push_back({visited_node.children[1], next.depth + 1});
    waiting.push_back({visited_node.children[0], next.depth + 1});
  }
}

}  // namespace PROOFREEL_PRECISION
}  // namespace proofreel
