#include "engine/dynamic_tree.h"

#include <algorithm>
#include <cassert>

namespace proofreel {
inline namespace PROOFREEL_PRECISION {

template <typename Observer>
ProxyId DynamicTree::insert(const Aabb& box, std::uint32_t owner, Observer observer) {
  const NodeId leaf = allocate();
  node(leaf).box = box;
  node(leaf).owner = owner;
  link(leaf, observer);
  return leaf;
}

template <typename Observer>
void DynamicTree::remove(ProxyId leaf, Observer observer) {
  assert(node(leaf).is_leaf());
  unlink(leaf, observer);
  free(leaf);
}

/// A place suits as long as one box around the leaf and its sibling is no larger than two boxes, one around each. Boxes
/// side by side are just within that.
template <typename Observer>
void DynamicTree::move(ProxyId leaf, const Aabb& box, Observer observer) {
  assert(node(leaf).is_leaf());
  if (leaf != root_) {
    const Aabb& beside = node(sibling_of(leaf)).box;
    if (perimeter(merged(box, beside)) <= perimeter(box) + perimeter(beside)) return refit(leaf, box, observer);
  }
  unlink(leaf, observer);
  node(leaf).box = box;
  link(leaf, observer);
}

template <typename Observer>
void DynamicTree::refit(ProxyId leaf, const Aabb& box, Observer observer) {
  assert(node(leaf).is_leaf());
  node(leaf).box = box;
  for (NodeId id = node(leaf).parent; id != none; id = node(id).parent) {
    const bool changed = fit(id);
    const bool rotated = rotate(id, observer);
    if (!changed && !rotated) break;
  }
}

DynamicTree::NodeId DynamicTree::allocate() {
  if (first_free_ == none) {
    nodes_.emplace_back();
    return static_cast<NodeId>(nodes_.size() - 1);
  }
  const NodeId id = first_free_;
  first_free_ = node(id).parent;
  node(id) = Node{};
  return id;
}

void DynamicTree::free(NodeId id) {
  node(id).parent = first_free_;
  node(id).height = -1;
  first_free_ = id;
}

/// Hangs a leaf into the tree: a new inner node takes the place of the best sibling and gets both as children.
template <typename Observer>
void DynamicTree::link(NodeId leaf, Observer observer) {
  if (root_ == none) {
    root_ = leaf;
    node(leaf).parent = none;
    return;
  }
  const NodeId sibling = best_sibling(node(leaf).box, observer);
  const NodeId parent = allocate();
  put_in_place(sibling, parent, node(sibling).parent);
  node(parent).children = {sibling, leaf};
  node(sibling).parent = parent;
  node(leaf).parent = parent;
  repair_upwards(parent, observer);
}

/// Takes a leaf out: its sibling moves up to where their parent was.
template <typename Observer>
void DynamicTree::unlink(NodeId leaf, Observer observer) {
  const NodeId parent = node(leaf).parent;
  if (parent == none) {
    root_ = none;
    return;
  }
  const NodeId sibling = sibling_of(leaf);
  const NodeId grandparent = node(parent).parent;
  put_in_place(parent, sibling, grandparent);
  free(parent);
  repair_upwards(grandparent, observer);
}

void DynamicTree::put_in_place(NodeId old_child, NodeId new_child, NodeId parent) {
  node(new_child).parent = parent;
  if (parent == none) {
    root_ = new_child;
  } else {
    auto& children = node(parent).children;
    children[children[0] == old_child ? 0 : 1] = new_child;
  }
}

/// The node beside which a new leaf adds least to the sum of perimeters: that of their common parent, and what the
/// boxes above grow by (`inherited`). Goes down to the child that can still do best, as long as one can.
template <typename Observer>
DynamicTree::NodeId DynamicTree::best_sibling(const Aabb& box, Observer observer) const {
  const real own = perimeter(box);
  NodeId id = root_;
  NodeId best = root_;
  real inherited = 0;
  real with_box = perimeter(merged(node(id).box, box));
  real best_cost = with_box;
  if constexpr (Observer::watches)
    observer([&] { return SiblingTested{Aabbd(node(id).box), static_cast<double>(best_cost)}; });
  while (!node(id).is_leaf()) {
    inherited += with_box - perimeter(node(id).box);
    std::array<real, 2> lower_bound{};
    std::array<real, 2> child_with_box{};
    for (std::size_t i = 0; i < 2; ++i) {
      const NodeId child = node(id).children[i];
      child_with_box[i] = perimeter(merged(node(child).box, box));
      const real cost = inherited + child_with_box[i];
      if constexpr (Observer::watches)
        observer([&] { return SiblingTested{Aabbd(node(child).box), static_cast<double>(cost)}; });
      // Below the child at least `own` is added, instead of the child's own box.
      const real saved = node(child).is_leaf() ? real(0) : std::max(perimeter(node(child).box) - own, real(0));
      lower_bound[i] = cost - saved;
      if (cost < best_cost) {
        best_cost = cost;
        best = child;
      }
    }
    const std::size_t side = lower_bound[1] < lower_bound[0] ? 1 : 0;
    if (lower_bound[side] >= best_cost) break;
    id = node(id).children[side];
    with_box = child_with_box[side];
  }
  if constexpr (Observer::watches)
    observer([&] { return SiblingChosen{Aabbd(node(best).box), static_cast<double>(best_cost)}; });
  return best;
}

template <typename Observer>
void DynamicTree::repair_upwards(NodeId id, Observer observer) {
  for (; id != none; id = node(id).parent) {
    fit(id);
    rotate(id, observer);
  }
}

/// Draws the node's box and height from its children. Returns whether that changed them.
bool DynamicTree::fit(NodeId id) {
  Node& fitted = node(id);
  const Node& first = node(fitted.children[0]);
  const Node& second = node(fitted.children[1]);
  const Aabb box = merged(first.box, second.box);
  const int height = 1 + std::max(first.height, second.height);
  const bool same = box.lower == fitted.box.lower && box.upper == fitted.box.upper && height == fitted.height;
  fitted.box = box;
  fitted.height = height;
  return !same;
}

/// Exchanges a child with a child of the other child where that makes the other child's box smaller; of the up to four
/// ways the one that gains most. Returns whether there was one.
template <typename Observer>
bool DynamicTree::rotate(NodeId id, Observer observer) {
  real most = 0;
  int best_child = -1;
  int best_grandchild = -1;
  for (int i = 0; i < 2; ++i) {
    const auto& children = node(id).children;
    const Node& moved = node(children[static_cast<std::size_t>(i)]);
    const Node& other = node(children[static_cast<std::size_t>(1 - i)]);
    if (other.is_leaf()) continue;
    for (int j = 0; j < 2; ++j) {
      const Node& staying = node(other.children[static_cast<std::size_t>(1 - j)]);
      const real gain = perimeter(other.box) - perimeter(merged(moved.box, staying.box));
      if (gain > most) {
        most = gain;
        best_child = i;
        best_grandchild = j;
      }
    }
  }
  if (best_child < 0) return false;
  const NodeId lowered = node(id).children[static_cast<std::size_t>(best_child)];
  const NodeId other = sibling_of(lowered);
  const NodeId raised = node(other).children[static_cast<std::size_t>(best_grandchild)];
  if constexpr (Observer::watches)
    observer([&] { return NodesRotated{Aabbd(node(lowered).box), Aabbd(node(raised).box)}; });
  swap_with_grandchild(id, best_child, best_grandchild);
  return true;
}

/// Exchanges `child` of node `id` with `grandchild` of its other child. The node's own box stays.
void DynamicTree::swap_with_grandchild(NodeId id, int child, int grandchild) {
  NodeId& moved = node(id).children[static_cast<std::size_t>(child)];
  const NodeId other = node(id).children[static_cast<std::size_t>(1 - child)];
  NodeId& raised = node(other).children[static_cast<std::size_t>(grandchild)];
  std::swap(moved, raised);
  node(moved).parent = id;
  node(raised).parent = other;
  fit(other);
  fit(id);
}

template ProxyId DynamicTree::insert<NoObserver>(const Aabb&, std::uint32_t, NoObserver);
template ProxyId DynamicTree::insert<Observer>(const Aabb&, std::uint32_t, Observer);
template void DynamicTree::remove<NoObserver>(ProxyId, NoObserver);
template void DynamicTree::remove<Observer>(ProxyId, Observer);
template void DynamicTree::move<NoObserver>(ProxyId, const Aabb&, NoObserver);
template void DynamicTree::move<Observer>(ProxyId, const Aabb&, Observer);
template void DynamicTree::refit<NoObserver>(ProxyId, const Aabb&, NoObserver);
template void DynamicTree::refit<Observer>(ProxyId, const Aabb&, Observer);

}  // namespace PROOFREEL_PRECISION
}  // namespace proofreel
