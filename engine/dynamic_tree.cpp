#include "engine/dynamic_tree.h"

#include <algorithm>
#include <cassert>

namespace proofreel {
inline namespace PROOFREEL_PRECISION {

ProxyId DynamicTree::insert(const Aabb& box, std::uint32_t owner) {
  const NodeId leaf = allocate();
  node(leaf).box = box;
  node(leaf).owner = owner;
  link(leaf);
  return leaf;
}

void DynamicTree::remove(ProxyId leaf) {
  assert(node(leaf).is_leaf());
  unlink(leaf);
  free(leaf);
}

void DynamicTree::move(ProxyId leaf, const Aabb& box) {
  assert(node(leaf).is_leaf());
  unlink(leaf);
  node(leaf).box = box;
  link(leaf);
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
void DynamicTree::link(NodeId leaf) {
  if (root_ == none) {
    root_ = leaf;
    node(leaf).parent = none;
    return;
  }
  const NodeId sibling = best_sibling(node(leaf).box);
  const NodeId parent = allocate();
  put_in_place(sibling, parent, node(sibling).parent);
  node(parent).children = {sibling, leaf};
  node(sibling).parent = parent;
  node(leaf).parent = parent;
  repair_upwards(parent);
}

/// Takes a leaf out: its sibling moves up to where their parent was.
void DynamicTree::unlink(NodeId leaf) {
  const NodeId parent = node(leaf).parent;
  if (parent == none) {
    root_ = none;
    return;
  }
  const auto& children = node(parent).children;
  const NodeId sibling = children[0] == leaf ? children[1] : children[0];
  const NodeId grandparent = node(parent).parent;
  put_in_place(parent, sibling, grandparent);
  free(parent);
  repair_upwards(grandparent);
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
DynamicTree::NodeId DynamicTree::best_sibling(const Aabb& box) const {
  const real own = perimeter(box);
  NodeId id = root_;
  NodeId best = root_;
  real inherited = 0;
  real with_box = perimeter(merged(node(id).box, box));
  real best_cost = with_box;
  while (!node(id).is_leaf()) {
    inherited += with_box - perimeter(node(id).box);
    std::array<real, 2> lower_bound{};
    std::array<real, 2> child_with_box{};
    for (std::size_t i = 0; i < 2; ++i) {
      const NodeId child = node(id).children[i];
      child_with_box[i] = perimeter(merged(node(child).box, box));
      const real cost = inherited + child_with_box[i];
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
  return best;
}

void DynamicTree::repair_upwards(NodeId id) {
  for (; id != none; id = node(id).parent) {
    refit(id);
    rotate(id);
  }
}

void DynamicTree::refit(NodeId id) {
  const Node& first = node(node(id).children[0]);
  const Node& second = node(node(id).children[1]);
  node(id).box = merged(first.box, second.box);
  node(id).height = 1 + std::max(first.height, second.height);
}

/// Exchanges a child with a child of the other child where that makes the other child's box smaller; of the up to four
/// ways the one that gains most.
void DynamicTree::rotate(NodeId id) {
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
  if (best_child >= 0) swap_with_grandchild(id, best_child, best_grandchild);
}

/// Exchanges `child` of node `id` with `grandchild` of its other child. The node's own box stays.
void DynamicTree::swap_with_grandchild(NodeId id, int child, int grandchild) {
  NodeId& moved = node(id).children[static_cast<std::size_t>(child)];
  const NodeId other = node(id).children[static_cast<std::size_t>(1 - child)];
  NodeId& raised = node(other).children[static_cast<std::size_t>(grandchild)];
  std::swap(moved, raised);
  node(moved).parent = id;
  node(raised).parent = other;
  refit(other);
  refit(id);
}

real DynamicTree::area_ratio() const {
  if (root_ == none || perimeter(node(root_).box) <= real(0)) return 0;
  real sum = 0;
  for (const Node& each : nodes_) {
    if (each.height > 0) sum += perimeter(each.box);
  }
  return sum / perimeter(node(root_).box);
}

bool DynamicTree::node_is_sound(NodeId id) const {
  const Node& checked = node(id);
  if (checked.is_leaf()) return true;
  const Node& first = node(checked.children[0]);
  const Node& second = node(checked.children[1]);
  const Aabb box = merged(first.box, second.box);
  return first.parent == id && second.parent == id && checked.height == 1 + std::max(first.height, second.height) &&
         checked.box.lower == box.lower && checked.box.upper == box.upper;
}

bool DynamicTree::validate() const {
  std::size_t reached = 0;
  visit([&](const Aabb&, int, bool) { ++reached; });
  std::size_t unused = 0;
  for (NodeId id = first_free_; id != none; id = node(id).parent) ++unused;
  bool sound = reached + unused == nodes_.size() && (root_ == none || node(root_).parent == none);
  for (std::size_t i = 0; i < nodes_.size(); ++i) {
    if (nodes_[i].height >= 0) sound = sound && node_is_sound(static_cast<NodeId>(i));
  }
  return sound;
}

}  // namespace PROOFREEL_PRECISION
}  // namespace proofreel
