#include "engine/dynamic_tree.h"
#include "engine/world.h"

namespace proofreel {
inline namespace PROOFREEL_PRECISION {

/// The shapes of a body that moves hide parts of each other, and of nothing else.
void World::join_shapes_of(BodyIndex index) {
  const Body& body = bodies_[index];
  if (body.type == BodyType::fixed) {
    ground_changed_ = true;
    return;
  }
  for (const ShapeIndex i : body.shapes) {
    std::vector<Hull> others;
    for (const ShapeIndex j : body.shapes) {
      if (j != i) others.push_back(shapes_[j].hull);
    }
    Seam seam;
    shapes_[i].seam = find_seam(shapes_[i].hull, others, seam) ? std::make_shared<Seam>(seam) : nullptr;
  }
}

bool World::is_ground(const Shape& shape) const {
  const Body& body = bodies_[shape.body];
  return shape.alive && body.type == BodyType::fixed && !body.sensor;
}

/// What never moves is one ground, whichever bodies it belongs to; but what does not meet the same bodies hides
/// nothing.
void World::join_fixed_shapes() {
  DynamicTree tree;
  for (ShapeIndex i = 0; i < shapes_.size(); ++i) {
    if (!is_ground(shapes_[i])) continue;
    const Shape& shape = shapes_[i];
    tree.insert(expanded(bounds(shape.hull, center_pose(shape.body)), real(1e-3) * shape.reach), i);
  }
  for (ShapeIndex i = 0; i < shapes_.size(); ++i) {
    if (!is_ground(shapes_[i])) continue;
    Shape& own = shapes_[i];
    const Pose pose = center_pose(own.body);
    std::vector<Hull> others;
    tree.query(bounds(own.hull, pose), [&](ProxyId, std::uint32_t j) {
      const Shape& other = shapes_[j];
      if (j == i || !(bodies_[own.body].filter == bodies_[other.body].filter)) return true;
      others.push_back(transformed(other.hull, relative_pose(pose, center_pose(other.body))));
      return true;
    });
    Seam seam;
    own.seam = find_seam(own.hull, others, seam) ? std::make_shared<Seam>(seam) : nullptr;
  }
}

}  // namespace PROOFREEL_PRECISION
}  // namespace proofreel
