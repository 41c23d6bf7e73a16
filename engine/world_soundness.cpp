// Whether a world that was read from bytes hangs together: every index leads somewhere, every list is as long as the
// step expects it, and every number is one. Whoever made the bytes may have meant ill.

#include <algorithm>
#include <cmath>

#include "engine/world.h"

namespace proofreel {
inline namespace PROOFREEL_PRECISION {
namespace {

bool can_be(const Hull& hull) {
  if (hull.count < 1 || hull.count > max_polygon_vertices) return false;
  for (int i = 0; i < max_polygon_vertices; ++i) {
    if (!is_finite(hull.points[i]) || !is_finite(hull.normals[i])) return false;
  }
  return std::isfinite(hull.radius) && std::isfinite(hull.thickness) && std::isfinite(hull.detail);
}

bool can_be(const ShapeDef& def) { return !def.points.empty() && def.points.size() <= max_polygon_vertices; }

/// Commands may have asked for too much: then the next tick fails.
bool can_be(const Motion& m, bool commanded) {
  const bool moves = commanded || (is_finite(m.velocity) && std::isfinite(m.spin));
  return moves && is_finite(m.delta) && std::isfinite(m.angle) && std::isfinite(m.rotation.c) &&
         std::isfinite(m.rotation.s) && std::isfinite(m.inv_mass) && std::isfinite(m.inv_inertia);
}

/// Of what a gear couples.
bool has_coordinate(const Joint& joint) {
  return joint.kind == JointKind::revolute || joint.kind == JointKind::prismatic;
}

}  // namespace

/// Every node is reached once, from the root or along the free ones.
bool DynamicTree::links_are_sound() const {
  const auto count = static_cast<NodeId>(nodes_.size());
  std::vector<NodeId> next;
  std::vector<bool> seen(nodes_.size(), false);
  const auto reach = [&](NodeId id) {
    if (id < 0 || id >= count || seen[static_cast<std::size_t>(id)]) return false;
    seen[static_cast<std::size_t>(id)] = true;
    return true;
  };
  for (NodeId id = first_free_; id != none; id = node(id).parent) {
    if (!reach(id) || node(id).height != -1) return false;
  }
  if (root_ != none) next.push_back(root_);
  while (!next.empty()) {
    const NodeId id = next.back();
    next.pop_back();
    if (!reach(id) || node(id).height < 0) return false;
    if (!node(id).is_leaf()) next.insert(next.end(), node(id).children.begin(), node(id).children.end());
  }
  return std::find(seen.begin(), seen.end(), false) == seen.end();
}

bool DynamicTree::is_sound() const {
  const bool boxes = std::all_of(nodes_.begin(), nodes_.end(), [](const Node& n) {
    return n.height < 0 || (is_finite(n.box.lower) && is_finite(n.box.upper));
  });
  return boxes && links_are_sound() && validate();
}

std::size_t DynamicTree::leaf_count() const {
  return static_cast<std::size_t>(
      std::count_if(nodes_.begin(), nodes_.end(), [](const Node& n) { return n.is_leaf(); }));
}

bool BroadPhase::is_sound(const std::vector<Shape>& shapes) const {
  if (!tree_.is_sound() || is_moved_.size() > shapes.size()) return false;
  std::size_t alive = 0;
  for (ShapeIndex i = 0; i < shapes.size(); ++i) {
    if (!shapes[i].alive) continue;
    ++alive;
    if (!tree_.has_leaf(shapes[i].proxy) || tree_.owner(shapes[i].proxy) != i || i >= is_moved_.size()) return false;
  }
  const bool listed = std::all_of(moved_.begin(), moved_.end(), [&](ShapeIndex i) {
    return i < is_moved_.size() && (is_moved_[i] == 0 || shapes[i].alive);
  });
  return listed && alive == tree_.leaf_count();
}

bool World::bodies_are_sound() const {
  if (motions_.size() != bodies_.size() || bodies_[0].type != BodyType::fixed) return false;
  for (BodyIndex i = 0; i < bodies_.size(); ++i) {
    const Body& body = bodies_[i];
    if (!failure_ && (!is_finite(body.center) || !can_be(motions_[i], commanded_))) return false;
    for (const ShapeDef& def : body.defs) {
      if (!can_be(def)) return false;
    }
    for (const ShapeIndex shape : body.shapes) {
      if (shape >= shapes_.size() || !shapes_[shape].alive || shapes_[shape].body != i) return false;
    }
  }
  const auto is_a_body = [this](const auto& one) { return one.body < bodies_.size(); };
  return std::all_of(pushed_.begin(), pushed_.end(), is_a_body) &&
         std::all_of(rockets_.begin(), rockets_.end(), is_a_body);
}

bool World::shapes_are_sound() const {
  const bool alone = std::all_of(shapes_.begin(), shapes_.end(), [this](const Shape& shape) {
    return shape.body < bodies_.size() && can_be(shape.hull) && std::isfinite(shape.reach);
  });
  const bool free_ones = std::all_of(free_shapes_.begin(), free_shapes_.end(),
                                     [this](ShapeIndex i) { return i < shapes_.size() && !shapes_[i].alive; });
  return alone && free_ones && (!has_broad_phase_ || broad_phase_.is_sound(shapes_));
}

bool World::joints_are_sound() const {
  return std::all_of(joints_.begin(), joints_.end(), [this](const Joint& joint) {
    if (joint.body_a >= motions_.size() || joint.body_b >= motions_.size()) return false;
    if (joint.kind != JointKind::gear) return true;
    return joint.first < joints_.size() && joint.second < joints_.size() && has_coordinate(joints_[joint.first]) &&
           has_coordinate(joints_[joint.second]);
  });
}

bool World::contacts_are_sound() const {
  if ((!contacts_.empty() || !sleep_.contacts.empty()) && !has_broad_phase_) return false;
  const auto is_sound = [this](const Contact& c) {
    if (c.shape_a >= shapes_.size() || c.shape_b >= shapes_.size()) return false;
    const Shape& a = shapes_[c.shape_a];
    const Shape& b = shapes_[c.shape_b];
    return a.alive && b.alive && a.body == c.body_a && b.body == c.body_b && c.manifold.count >= 0 &&
           c.manifold.count <= 2;
  };
  return std::all_of(contacts_.begin(), contacts_.end(), is_sound) &&
         std::all_of(sleep_.contacts.begin(), sleep_.contacts.end(), is_sound);
}

/// Who sleeps belongs to an island of sleepers, and nobody else does.
bool World::sleep_is_sound() const {
  const std::size_t watched = sleep_.islands.size();
  if (watched > bodies_.size() || sleep_.clocks.size() != watched || sleep_.forces.size() != watched ||
      sleep_.scales.size() != watched)
    return false;
  if (on(Effect::sleeping) && !structure_changed_ && watched != bodies_.size()) return false;
  int sleepers = 0;
  for (BodyIndex i = 0; i < bodies_.size(); ++i) {
    const BodyIndex island = i < watched ? sleep_.islands[i] : 0;
    if (island >= bodies_.size() || (island != 0) != bodies_[i].asleep()) return false;
    sleepers += bodies_[i].asleep() ? 1 : 0;
  }
  return sleepers == sleep_.sleepers;
}

/// `least_bodies` are those of the scene, which attractors may name.
bool World::is_sound(std::size_t least_bodies) const {
  if (bodies_.size() < std::max<std::size_t>(least_bodies, 1) || tick_ < 0) return false;
  if (substeps_ < method_.substeps || most_substeps_ < substeps_) return false;
  if (!bodies_are_sound() || !shapes_are_sound() || !joints_are_sound() || !contacts_are_sound() || !sleep_is_sound())
    return false;
  const std::size_t count = bodies_.size();
  if (structure_changed_) return accelerations_.size() <= count && drags_.size() <= count;
  return accelerations_.size() == (on(Effect::gravity) ? count : 0) &&
         drags_.size() == (on(Effect::drag) ? count : 0) && (has_broad_phase_ || !on(Effect::contacts));
}

}  // namespace PROOFREEL_PRECISION
}  // namespace proofreel
