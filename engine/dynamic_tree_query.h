#pragma once

/// Everything that looks at a DynamicTree without changing it. Included by dynamic_tree.h.

#include <algorithm>

#include "engine/dynamic_tree.h"

namespace proofreel {
inline namespace PROOFREEL_PRECISION {

template <typename Found, typename Observer>
void DynamicTree::query(const Aabb& box, Found&& found, Observer observer) const {
  if (root_ == none) return;
  const bool entered = overlaps(node(root_).box, box);
  if constexpr (Observer::watches)
    observer([&] { return NodeVisited{Aabbd(node(root_).box), node(root_).is_leaf(), !entered}; });
  if (entered) query_below(root_, box, found, observer);
}

/// The nodes still to be entered wait on a small stack of fixed size; a tree so deep that it overflows goes on in a
/// nested call with the next one. Returns false when `found` has had enough.
///
/// Both children are put on the stack and only those that overlap are counted: a branch would be foretold wrongly
/// every third time.
template <typename Found, typename Observer>
bool DynamicTree::query_below(NodeId id, const Aabb& box, Found& found, Observer observer) const {
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
      const bool overlap = overlaps(node(child).box, box);
      if constexpr (Observer::watches)
        observer([&] { return NodeVisited{Aabbd(node(child).box), node(child).is_leaf(), !overlap}; });
      if (count == waiting.size()) {
        if (overlap && !query_below(child, box, found, observer)) return false;
        continue;
      }
      waiting[count] = child;
      count += overlap ? 1 : 0;
    }
  }
  return true;
}

template <typename Hit, typename Observer>
void DynamicTree::cast_ray(Vec2 origin, Vec2 translation, real max_fraction, Hit&& hit, Observer observer) const {
  struct Waiting {
    NodeId id;
    real entry;  ///< the fraction at which the ray enters the node
  };
  if (root_ == none) return;
  const BasicRay<real> ray(origin, translation);
  const auto look_at = [&](NodeId id) {
    const Waiting seen{id, ray.entry_into(node(id).box, max_fraction)};
    if constexpr (Observer::watches)
      observer([&] { return NodeVisited{Aabbd(node(id).box), node(id).is_leaf(), seen.entry > max_fraction}; });
    return seen;
  };
  std::vector<Waiting> waiting{look_at(root_)};
  while (!waiting.empty()) {
    const Waiting next = waiting.back();
    waiting.pop_back();
    if (next.entry > max_fraction) continue;  // missed, or behind what was hit meanwhile
    const Node& entered = node(next.id);
    if (entered.is_leaf()) {
      max_fraction = hit(next.id, entered.owner, max_fraction);
      if (max_fraction < real(0)) return;
      continue;
    }
    Waiting near = look_at(entered.children[0]);
    Waiting far = look_at(entered.children[1]);
    if (far.entry < near.entry) std::swap(near, far);
    if (far.entry <= max_fraction) waiting.push_back(far);
    if (near.entry <= max_fraction) waiting.push_back(near);
  }
}

/// Branch and bound, the nearer child first: whatever is farther than the best so far is left out.
template <typename DistanceTo, typename Observer>
std::optional<NearestLeaf> DynamicTree::nearest(Vec2 point, real limit, DistanceTo&& distance_to,
                                                Observer observer) const {
  struct Waiting {
    NodeId id;
    real distance;  ///< from the point to the node's box: no leaf below is nearer
  };
  if (root_ == none) return std::nullopt;
  std::optional<NearestLeaf> best;
  const auto look_at = [&](NodeId id) {
    const Waiting seen{id, distance(node(id).box, point)};
    if constexpr (Observer::watches)
      observer([&] { return NodeVisited{Aabbd(node(id).box), node(id).is_leaf(), seen.distance > limit}; });
    return seen;
  };
  std::vector<Waiting> waiting{look_at(root_)};
  while (!waiting.empty()) {
    const Waiting next = waiting.back();
    waiting.pop_back();
    if (next.distance > limit) continue;
    const Node& entered = node(next.id);
    if (entered.is_leaf()) {
      const real found = distance_to(next.id, entered.owner);
      const bool first_of_equals = best && found == best->distance && entered.owner < owner(best->leaf);
      if (found < limit || first_of_equals || (!best && found == limit)) best = NearestLeaf{next.id, found};
      limit = std::min(limit, found);
      continue;
    }
    Waiting near = look_at(entered.children[0]);
    Waiting far = look_at(entered.children[1]);
    if (far.distance < near.distance) std::swap(near, far);
    if (far.distance <= limit) waiting.push_back(far);
    if (near.distance <= limit) waiting.push_back(near);
  }
  return best;
}

template <typename Found, typename Observer>
void DynamicTree::for_each_pair(Found&& found, Observer observer) const {
  traverse([](NodeId, NodeId) { return true; }, found, observer);
}

template <typename Found, typename Observer>
void DynamicTree::for_each_pair_of(const std::vector<ProxyId>& leaves, Found&& found, Observer observer) const {
  std::vector<std::uint8_t> marked(nodes_.size(), 0);  // the leaves and all nodes above them
  const auto mark = [&](NodeId id) -> std::uint8_t& { return marked[static_cast<std::size_t>(id)]; };
  for (const ProxyId leaf : leaves) {
    for (NodeId id = leaf; id != none && mark(id) == 0; id = node(id).parent) mark(id) = 1;
  }
  traverse([&](NodeId a, NodeId b) { return (mark(a) | mark(b)) != 0; }, found, observer);
}

/// The queue is worked off level by level: while one generation of pairs is looked at, the next one lines up. A pair
/// is looked at only if `wanted`. Those that overlap are first gathered at the front, which needs no branch.
template <typename Wanted, typename Found, typename Observer>
void DynamicTree::traverse(const Wanted& wanted, Found& found, Observer observer) const {
  std::vector<NodePair> queue;
  std::vector<NodePair> next;
  std::size_t count = 0;
  if (root_ != none && !node(root_).is_leaf()) {
    queue.emplace_back(root_, root_);
    count = 1;
  }
  while (count > 0) {
    std::size_t entered = 0;
    for (std::size_t i = 0; i < count; ++i) {
      const NodePair pair = queue[i];
      const Node& a = node(pair.first);
      const Node& b = node(pair.second);
      const bool overlap = overlaps(a.box, b.box);
      const bool asked_for = wanted(pair.first, pair.second);
      const bool enter = overlap & asked_for;
      if constexpr (Observer::watches)
        observer([&] { return PairVisited{Aabbd(a.box), Aabbd(b.box), a.is_leaf() && b.is_leaf(), !enter}; });
      queue[entered] = pair;
      entered += enter ? 1 : 0;
    }
    if (next.size() < 4 * entered) next.resize(4 * entered);
    count = 0;
    for (std::size_t i = 0; i < entered; ++i) count += line_up_children(queue[i], &next[count], found);
    queue.swap(next);
  }
}

/// Writes the pairs of children to look at instead of this one, at most four, or tells `found` about two leaves.
/// Returns how many it wrote.
template <typename Found>
std::size_t DynamicTree::line_up_children(NodePair pair, NodePair* next, Found& found) const {
  const auto [a, b] = pair;
  const Node& first = node(a);
  const Node& second = node(b);
  if (first.is_leaf() && second.is_leaf()) {
    found(a, b);
    return 0;
  }
  if (first.is_leaf()) {
    for (std::size_t i = 0; i < 2; ++i) next[i] = {a, second.children[i]};
    return 2;
  }
  const auto [left, right] = first.children;
  if (second.is_leaf()) {
    next[0] = {left, b};
    next[1] = {right, b};
    return 2;
  }
  if (a != b) {
    next[0] = {left, second.children[0]};
    next[1] = {left, second.children[1]};
    next[2] = {right, second.children[1]};
    next[3] = {right, second.children[0]};
    return 4;
  }
  std::size_t count = 0;
  next[count++] = {left, right};
  for (const NodeId child : first.children) {
    next[count] = {child, child};
    count += node(child).is_leaf() ? 0 : 1;  // a leaf cannot collide with itself
  }
  return count;
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
