/// Compiled with the engine in double precision, whatever is measured.

#include "lab/measures.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <set>

#include "engine/collide.h"

namespace proofreel {
namespace {

using BodyPair = std::pair<BodyId, BodyId>;

/// One shape where it is.
struct PlacedShape {
  const BodyView* body = nullptr;
  Hull hull;
  Pose pose;
  Aabb box;
};

std::vector<PlacedShape> placed_shapes(const Snapshot& snapshot) {
  std::vector<PlacedShape> placed;
  for (const BodyView& body : snapshot.bodies) {
    if (body.sensor) continue;
    const Posed pose{body.state.center, body.pose.rotation};
    for (std::uint32_t i = 0; i < body.shape_count; ++i) {
      const ShapeView& view = snapshot.shapes[body.first_shape + i];
      const auto first = snapshot.points.begin() + view.first_point;
      ShapeDef def;
      def.points.assign(first, first + view.point_count);
      def.radius = view.radius;
      const Hull hull = make_hull(def, to_local(body.pose, body.state.center));
      placed.push_back({&body, hull, Pose(pose), bounds(hull, Pose(pose))});
    }
  }
  return placed;
}

FilterDef filter_of(BodyId id, const std::vector<FilterDef>& filters) {
  const std::size_t index = static_cast<std::size_t>(id) - 1;
  return index < filters.size() ? filters[index] : FilterDef{};
}

std::set<BodyPair> jointed_pairs(const Snapshot& snapshot) {
  std::set<BodyPair> pairs;
  for (const JointView& joint : snapshot.joints) {
    if (lets_overlap(joint.kind)) pairs.insert(std::minmax(joint.a, joint.b));
  }
  return pairs;
}

/// Calls `act` with the places of any two shapes whose boxes are within `margin`, sweeping along x.
template <typename Act>
void for_each_near(const std::vector<PlacedShape>& shapes, double margin, const Act& act) {
  std::vector<std::size_t> order(shapes.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::sort(order.begin(), order.end(), [&](std::size_t i, std::size_t j) {
    return std::pair(shapes[i].box.lower.x, i) < std::pair(shapes[j].box.lower.x, j);
  });
  for (std::size_t i = 0; i < order.size(); ++i) {
    const Aabb reach = expanded(shapes[order[i]].box, margin);
    for (std::size_t j = i + 1; j < order.size() && shapes[order[j]].box.lower.x <= reach.upper.x; ++j) {
      if (overlaps(reach, shapes[order[j]].box)) act(shapes[order[i]], shapes[order[j]]);
    }
  }
}

/// Pairs of bodies whose contacts carry something.
std::set<BodyPair> loaded_pairs(const Snapshot& snapshot) {
  std::set<BodyPair> pairs;
  for (const ContactView& contact : snapshot.contacts) {
    for (int i = 0; i < contact.point_count; ++i) {
      if (contact.points[i].normal_impulse > 0) pairs.insert(std::minmax(contact.a, contact.b));
    }
  }
  return pairs;
}

}  // namespace

std::vector<PairFit> fit_of_pairs(const Snapshot& snapshot, const std::vector<FilterDef>& filters, double margin) {
  const std::vector<PlacedShape> shapes = placed_shapes(snapshot);
  const std::set<BodyPair> jointed = jointed_pairs(snapshot);
  std::map<BodyPair, PairFit> fits;
  for_each_near(shapes, margin, [&](const PlacedShape& s, const PlacedShape& t) {
    const bool in_order = s.body->id < t.body->id;
    const PlacedShape& a = in_order ? s : t;
    const PlacedShape& b = in_order ? t : s;
    const BodyPair pair{a.body->id, b.body->id};
    const bool one_moves = a.body->type == BodyType::dynamic || b.body->type == BodyType::dynamic;
    if (pair.first == pair.second || !one_moves || jointed.contains(pair)) return;
    if (!filters_agree(filter_of(pair.first, filters), filter_of(pair.second, filters))) return;
    const Manifold manifold = collide(a.hull, a.pose, b.hull, b.pose, margin);
    if (manifold.count == 0) return;
    const PairFit fit{pair.first, pair.second, deepest(manifold), std::min(a.hull.thickness, b.hull.thickness)};
    const auto [known, is_new] = fits.emplace(pair, fit);
    if (!is_new && fit.separation < known->second.separation) known->second = fit;
  });
  std::vector<PairFit> sorted;
  for (const auto& [pair, fit] : fits) sorted.push_back(fit);
  return sorted;
}

Penetration penetration_of(const Snapshot& snapshot, const std::vector<FilterDef>& filters) {
  constexpr double margin = 0.05;  // more than the skin of any engine
  const std::set<BodyPair> loaded = loaded_pairs(snapshot);
  Penetration sum;
  int carrying = 0;
  for (const PairFit& fit : fit_of_pairs(snapshot, filters, margin)) {
    const double depth = std::max(0.0, -fit.separation);
    const bool carries = loaded.contains({fit.a, fit.b});
    if (depth <= 0 && !carries) continue;
    ++sum.pairs;
    sum.largest = std::max(sum.largest, depth);
    sum.mean += depth;
    if (fit.thickness > 0) sum.of_smaller = std::max(sum.of_smaller, depth / fit.thickness);
    if (!carries) continue;
    ++carrying;
    sum.largest_air = std::max(sum.largest_air, fit.separation);
    sum.mean_air += std::max(0.0, fit.separation);
  }
  if (sum.pairs > 0) sum.mean /= sum.pairs;
  if (carrying > 0) sum.mean_air /= carrying;
  return sum;
}

double joint_gap(const JointView& joint) {
  const Vec2d way = joint.anchor_b - joint.anchor_a;
  switch (joint.kind) {
    case JointKind::revolute:
    case JointKind::weld:
      return length(way);
    case JointKind::distance:
      return std::abs(length(way) - joint.length);
    case JointKind::rope:
      return std::max(0.0, length(way) - joint.length);
    case JointKind::prismatic:
    case JointKind::wheel:
      return std::abs(cross(joint.axis, way));
    case JointKind::spring:
    case JointKind::gear:
    case JointKind::pulley:
    case JointKind::drag_to:
    case JointKind::motor:
      return 0;
  }
  return 0;
}

JointGaps joint_gaps(const Snapshot& snapshot) {
  JointGaps sum;
  int rigid = 0;
  for (const JointView& joint : snapshot.joints) {
    if (is_soft(joint.kind)) continue;
    ++rigid;
    sum.largest = std::max(sum.largest, joint_gap(joint));
    sum.mean += joint_gap(joint);
  }
  if (rigid > 0) sum.mean /= rigid;
  return sum;
}

}  // namespace proofreel
