#pragma once

/// Broad phase (thesis chapter 4.1): which shapes may touch? Every shape has a box in a dynamic tree, fattened so that
/// it stays valid while the body moves a little; only shapes that left their box are looked at again.

#include <cstdint>
#include <memory>
#include <vector>

#include "engine/body.h"
#include "engine/dynamic_tree.h"
#include "engine/pair_set.h"
#include "engine/seam.h"

namespace proofreel {
inline namespace PROOFREEL_PRECISION {

using ShapeIndex = std::uint32_t;

struct Shape {
  Hull hull;
  std::shared_ptr<const Seam> seam;  ///< null: no neighbour hides anything of it
  BodyIndex body = 0;
  bool alive = true;
  real density = 1;
  real friction_at_rest = 0;
  real friction_sliding = 0;
  real restitution = 0;
  real rolling_resistance = 0;  ///< m
  real surface_speed = 0;       ///< m/s
  real reach = 0;               ///< from the body's centre of mass to the farthest point
  ProxyId proxy = 0;
};

/// The length a pair's margins are measured by: the thickness of the thinner shape. A bare segment has none and leaves
/// it to the other.
real pair_length(const Shape& a, const Shape& b);

struct ShapePair {
  ShapeIndex a = 0;  ///< a < b
  ShapeIndex b = 0;
  friend bool operator==(ShapePair, ShapePair) = default;
};

class BroadPhase {
 public:
  void add(ShapeIndex index, Shape& shape, const Aabb& box);
  void remove(ShapeIndex index, const Shape& shape);
  /// Tells where a shape may be until the end of the tick: `box` now and after `displacement`.
  void move(ShapeIndex index, const Shape& shape, const Aabb& box, Vec2 displacement);
  /// The pairs of overlapping boxes of which at least one shape has moved since the last call, in ascending order,
  /// without those `known` already. Shapes of the same body and of two bodies that nothing moves are left out.
  std::vector<ShapePair> new_pairs(const std::vector<Shape>& shapes, const std::vector<Body>& bodies);
  /// The pair is no contact any more and may be reported again.
  void forget(ShapePair pair) { known_.erase(pair.a, pair.b); }
  bool boxes_overlap(const Shape& a, const Shape& b) const {
    return overlaps(tree_.aabb(a.proxy), tree_.aabb(b.proxy));
  }
  const DynamicTree& tree() const { return tree_; }

  /// For archives (world_archive.cpp).
  template <typename Archive, typename Self>
  static void exchange(Archive& archive, Self& broad_phase);
  /// Whether it holds just the living ones of these shapes; for what comes from outside.
  bool is_sound(const std::vector<Shape>& shapes) const;

 private:
  void mark_as_moved(ShapeIndex index);
  void rebuild_if_worn();

  DynamicTree tree_;
  std::vector<ShapeIndex> moved_;       ///< since the last call of new_pairs; the removed ones may still be listed
  std::vector<std::uint8_t> is_moved_;  ///< by shape: whether it is one of them
  std::size_t moves_since_rebuild_ = 0;
  PairSet known_;
};

}  // namespace PROOFREEL_PRECISION
}  // namespace proofreel
