#pragma once

/// Bounding-volume hierarchy of the broad phase (thesis chapter 4.1, BBTree): a binary tree of axis-aligned boxes in
/// which every inner node's box is the smallest around its two children. A query goes down only where boxes overlap,
/// so among n boxes it costs O(log n + found) when the tree is good.
///
/// What makes a tree good is the surface-area heuristic (Goldsmith and Salmon 1987): the chance that a query enters a
/// node grows with its box, so the sum of the inner boxes' perimeters should be small. A new leaf goes where it adds
/// least, and on the way back up subtrees are rotated where that makes a box smaller (Catto, GDC 2019). That keeps the
/// height near log n for boxes side by side; boxes nested like onion skins make a tree as deep as they are many, in
/// which everything stays right but nothing is fast. `rebuild` makes the whole tree anew, better than single
/// insertions can.
///
/// The nodes lie in one array and are linked by index. The tree depends on nothing but the order of the operations.
/// What visits the nodes takes functions and is therefore defined in a header too, dynamic_tree_query.h.
///
/// An observer of changes sees SiblingTested, SiblingChosen and NodesRotated; one of queries and casts sees a
/// NodeVisited for every node whose box was looked at, one of the traversal a PairVisited for every pair. How many
/// there are is the usual measure of what a search costs.

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "engine/observer.h"
#include "engine/real.h"

namespace proofreel {
inline namespace PROOFREEL_PRECISION {

/// A leaf's name from `insert` until `remove`; may be given out again after that.
using ProxyId = std::int32_t;

/// What `nearest` has found.
struct NearestLeaf {
  ProxyId leaf = 0;
  real distance = 0;
};

class DynamicTree {
 public:
  /// Boxes are stored as given: make them larger than the shape, and a body that moves a little needs no `move`.
  /// `owner` is the caller's own number.
  template <typename Observer = NoObserver>
  ProxyId insert(const Aabb& box, std::uint32_t owner, Observer observer = {});
  template <typename Observer = NoObserver>
  void remove(ProxyId leaf, Observer observer = {});
  /// Gives the leaf another box; its name stays. As long as it suits the leaf's place, that is a `refit`; otherwise
  /// the leaf is taken out and inserted again, which costs some five times as much.
  template <typename Observer = NoObserver>
  void move(ProxyId leaf, const Aabb& box, Observer observer = {});
  /// Gives the leaf another box where it hangs. Always right, but boxes far from their neighbours make a bad tree.
  template <typename Observer = NoObserver>
  void refit(ProxyId leaf, const Aabb& box, Observer observer = {});
  /// Builds all inner nodes anew from the top down, in O(n log n): each set of leaves is split where the surface-area
  /// heuristic over a few bins says (Wald 2007). Leaves keep their names.
  void rebuild();

  const Aabb& aabb(ProxyId leaf) const { return node(leaf).box; }
  std::uint32_t owner(ProxyId leaf) const { return node(leaf).owner; }

  /// Calls found(leaf, owner) for every leaf whose box overlaps `box`, until it returns false. It must not change the
  /// tree.
  template <typename Found, typename Observer = NoObserver>
  void query(const Aabb& box, Found&& found, Observer observer = {}) const;

  /// Follows the ray from `origin` to `origin + max_fraction * translation` and calls hit(leaf, owner, max_fraction)
  /// for the leaves whose box it meets, nearer nodes first. What `hit` returns is the new max_fraction: the fraction at
  /// which the owner itself was hit, in order to find the first one; the same, to find all; a negative number, to stop.
  /// A ray that only touches a box meets it; one of length zero meets the boxes around its origin.
  template <typename Hit, typename Observer = NoObserver>
  void cast_ray(Vec2 origin, Vec2 translation, real max_fraction, Hit&& hit, Observer observer = {}) const;

  /// The leaf with the least distance_to(leaf, owner), where that is at most `limit`; of equal ones that of the
  /// smallest owner. No owner may be nearer to `point` than its box is.
  template <typename DistanceTo, typename Observer = NoObserver>
  std::optional<NearestLeaf> nearest(Vec2 point, real limit, DistanceTo&& distance_to, Observer observer = {}) const;

  /// Calls found(leaf, other_leaf) once for every pair of leaves whose boxes overlap: the tree is traversed against
  /// itself, from the pair (root, root) down, with a queue of the pairs of nodes still to be looked at (thesis chapter
  /// 4.1; but a leaf is not paired with itself).
  template <typename Found, typename Observer = NoObserver>
  void for_each_pair(Found&& found, Observer observer = {}) const;

  /// The same for the pairs only of which at least one is among `leaves`. Finds the pairs of all leaves that have moved
  /// faster than a query for each: nodes near the root are looked at once for all of them.
  template <typename Found, typename Observer = NoObserver>
  void for_each_pair_of(const std::vector<ProxyId>& leaves, Found&& found, Observer observer = {}) const;

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

  /// For archives (world_archive.cpp): every node where it lies, so that whatever happens to the tree from then on
  /// happens as it would have.
  template <typename Archive, typename Self>
  static void exchange(Archive& archive, Self& tree);
  /// Whether the links lead to nodes and nowhere in circles, and all agrees; for trees that come from outside.
  bool is_sound() const;
  /// Whether this is the name of a leaf, whatever number it may be.
  bool has_leaf(ProxyId leaf) const {
    return leaf >= 0 && static_cast<std::size_t>(leaf) < nodes_.size() && node(leaf).is_leaf();
  }
  std::size_t leaf_count() const;

 private:
  using NodeId = std::int32_t;
  using NodePair = std::pair<NodeId, NodeId>;
  static constexpr NodeId none = -1;

  /// In single precision two nodes fill a cache line, and none lies across two.
  struct alignas(sizeof(real) == 4 ? 32 : 16) Node {
    Aabb box;
    NodeId parent = none;  ///< of a free node: the next free one
    int height = 0;        ///< 0 for a leaf, -1 for a free node
    union {
      std::array<NodeId, 2> children{none, none};  ///< of an inner node
      std::uint32_t owner;                         ///< of a leaf
    };
    bool is_leaf() const { return height == 0; }
    template <typename Archive, typename Self>
    static void exchange(Archive& archive, Self& node);
  };

  /// A leaf during `rebuild`, with its box beside it.
  struct LooseLeaf {
    Aabb box;
    NodeId id;
  };

  Node& node(NodeId id) { return nodes_[static_cast<std::size_t>(id)]; }
  const Node& node(NodeId id) const { return nodes_[static_cast<std::size_t>(id)]; }
  NodeId sibling_of(NodeId id) const {
    const auto& children = node(node(id).parent).children;
    return children[0] == id ? children[1] : children[0];
  }

  NodeId allocate();
  void free(NodeId id);
  template <typename Observer>
  void link(NodeId leaf, Observer observer);
  template <typename Observer>
  void unlink(NodeId leaf, Observer observer);
  template <typename Observer>
  NodeId best_sibling(const Aabb& box, Observer observer) const;
  void put_in_place(NodeId old_child, NodeId new_child, NodeId parent);
  template <typename Observer>
  void repair_upwards(NodeId id, Observer observer);
  bool fit(NodeId id);
  template <typename Observer>
  bool rotate(NodeId id, Observer observer);
  void swap_with_grandchild(NodeId id, int child, int grandchild);

  std::vector<LooseLeaf> take_apart();

  bool links_are_sound() const;
  std::size_t count_reached() const;
  bool node_is_sound(NodeId id) const;

  template <typename Wanted, typename Found, typename Observer>
  void traverse(const Wanted& wanted, Found& found, Observer observer) const;
  template <typename Found>
  std::size_t line_up_children(NodePair pair, NodePair* next, Found& found) const;
  template <typename Found, typename Observer>
  bool query_below(NodeId id, const Aabb& box, Found& found, Observer observer) const;

  std::vector<Node> nodes_;
  NodeId root_ = none;
  NodeId first_free_ = none;
};

}  // namespace PROOFREEL_PRECISION
}  // namespace proofreel

#include "engine/dynamic_tree_query.h"
