#include <algorithm>
#include <array>
#include <limits>
#include <utility>

#include "engine/dynamic_tree.h"

namespace proofreel {
inline namespace PROOFREEL_PRECISION {
namespace {

constexpr std::size_t bin_count = 8;

/// Leaves whose centres lie in one stripe.
struct Bin {
  Aabb box;
  std::size_t count = 0;
};

Bin joined(const Bin& a, const Bin& b) { return {merged(a.box, b.box), a.count + b.count}; }

/// The expected work in one half of a split: boxes to look at, times the chance to have to.
real cost_of(const Bin& half) { return static_cast<real>(half.count) * perimeter(half.box); }

/// How many stripes belong to the first half where the surface-area heuristic is least. The first and the last stripe
/// must not be empty.
std::size_t best_cut(const std::array<Bin, bin_count>& bins) {
  std::array<Bin, bin_count> from_here = bins;
  for (std::size_t i = bin_count - 1; i > 0; --i) from_here[i - 1] = joined(from_here[i - 1], from_here[i]);
  Bin up_to_here = bins[0];
  std::size_t best = 1;
  real least = std::numeric_limits<real>::infinity();
  for (std::size_t cut = 1; cut < bin_count; ++cut) {
    const real cost = cost_of(up_to_here) + cost_of(from_here[cut]);
    if (cost < least) {
      least = cost;
      best = cut;
    }
    up_to_here = joined(up_to_here, bins[cut]);
  }
  return best;
}

/// Stripes across the longer side of the box around all centres.
class Stripes {
 public:
  template <typename Leaf>
  Stripes(const Leaf* first, const Leaf* last) {
    Aabb centers;
    for (const Leaf* leaf = first; leaf != last; ++leaf) centers = merged(centers, center(leaf->box));
    const Vec2 extent = centers.upper - centers.lower;
    along_x_ = extent.x >= extent.y;
    low_ = along_x_ ? centers.lower.x : centers.lower.y;
    per_metre_ = static_cast<real>(bin_count) / (along_x_ ? extent.x : extent.y);
  }
  /// Not so when all centres are the same.
  bool are_distinct() const { return per_metre_ < std::numeric_limits<real>::max(); }
  std::size_t of(const Aabb& box) const {
    const Vec2 middle = center(box);
    const auto stripe = static_cast<std::size_t>(((along_x_ ? middle.x : middle.y) - low_) * per_metre_);
    return std::min(stripe, bin_count - 1);
  }

 private:
  bool along_x_ = true;
  real low_ = 0;
  real per_metre_ = 0;
};

/// Parts the leaves into two sets that are not empty. Returns where the second one begins.
template <typename Leaf>
Leaf* split(Leaf* first, Leaf* last) {
  if (last - first == 2) return first + 1;
  const Stripes stripes(first, last);
  if (!stripes.are_distinct()) return first + (last - first) / 2;
  std::array<Bin, bin_count> bins;
  for (const Leaf* leaf = first; leaf != last; ++leaf) {
    Bin& bin = bins[stripes.of(leaf->box)];
    bin = joined(bin, {leaf->box, 1});
  }
  const std::size_t cut = best_cut(bins);
  Leaf* middle = first;
  for (Leaf* leaf = first; leaf != last; ++leaf) {
    // Exchanged even where both belong to the second set: which one does is a toss-up no branch foretells.
    const bool in_first = stripes.of(leaf->box) < cut;
    std::swap(*leaf, *middle);
    middle += in_first ? 1 : 0;
  }
  return middle;
}

}  // namespace

void DynamicTree::rebuild() {
  struct Task {
    LooseLeaf* first;  ///< to put below one node, up to `last`
    LooseLeaf* last;
    NodeId parent;
    std::size_t side;
  };
  std::vector<LooseLeaf> leaves = take_apart();
  std::vector<NodeId> inner;  // parents before children
  std::vector<Task> tasks;
  if (!leaves.empty()) tasks.push_back({leaves.data(), leaves.data() + leaves.size(), none, 0});
  while (!tasks.empty()) {
    const Task task = tasks.back();
    tasks.pop_back();
    const bool single = task.last - task.first == 1;
    const NodeId id = single ? task.first->id : allocate();
    node(id).parent = task.parent;
    (task.parent == none ? root_ : node(task.parent).children[task.side]) = id;
    if (single) continue;
    inner.push_back(id);
    LooseLeaf* const middle = split(task.first, task.last);
    tasks.push_back({middle, task.last, id, 1});
    tasks.push_back({task.first, middle, id, 0});
  }
  for (std::size_t i = inner.size(); i > 0; --i) fit(inner[i - 1]);
}

/// Frees all inner nodes, so that they are handed out again in the order in which they lie. Returns the leaves.
std::vector<DynamicTree::LooseLeaf> DynamicTree::take_apart() {
  std::vector<LooseLeaf> leaves;
  root_ = none;
  first_free_ = none;
  for (auto id = static_cast<NodeId>(nodes_.size()) - 1; id >= 0; --id) {
    if (node(id).is_leaf()) {
      leaves.push_back({node(id).box, id});
    } else {
      free(id);
    }
  }
  return leaves;
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

std::size_t DynamicTree::count_reached() const {
  std::size_t reached = 0;
  visit([&](const Aabb&, int, bool) { ++reached; });
  return reached;
}

bool DynamicTree::validate() const {
  std::size_t unused = 0;
  for (NodeId id = first_free_; id != none; id = node(id).parent) ++unused;
  bool sound = count_reached() + unused == nodes_.size() && (root_ == none || node(root_).parent == none);
  for (std::size_t i = 0; i < nodes_.size(); ++i) {
    if (nodes_[i].height >= 0) sound = sound && node_is_sound(static_cast<NodeId>(i));
  }
  return sound;
}

}  // namespace PROOFREEL_PRECISION
}  // namespace proofreel
