#include "scenarios/demonstrations/stack.h"

#include "scenarios/demonstrations/weighed.h"

namespace proofreel {
namespace {

constexpr double friction = 0.5;

/// A slab as wide as all shapes and more, with its upper side under the lowest corner.
DemonstrationShape ground_under(const std::vector<DemonstrationShape>& shapes) {
  Aabbd box;
  for (const DemonstrationShape& shape : shapes) box = merged(box, bounds_of(shape.parts[0]));
  const double size = std::max(box.upper.x - box.lower.x, box.upper.y - box.lower.y);
  const double left = box.lower.x - size, right = box.upper.x + size, top = box.lower.y;
  return {{{{left, top - size}, {right, top - size}, {right, top}, {left, top}}}, 0, 1};
}

}  // namespace

Stack::Stack(const std::vector<DemonstrationShape>& shapes) {
  add_body(ground_under(shapes), true);
  for (const DemonstrationShape& shape : shapes) add_body(shape, false);
  for (ShapeIndex i = 0; i < shapes_.size(); ++i) {
    for (ShapeIndex j = i + 1; j < shapes_.size(); ++j) {
      Contact contact;
      contact.shape_a = contact.body_a = i;
      contact.shape_b = contact.body_b = j;
      mix_materials(contact, shapes_[i], shapes_[j]);
      contact.a_to_b = Vec2(centers_[j] - centers_[i]);
      contact.manifold = collide(shapes_[i].hull, {Vec2(centers_[i]), Rot{}}, shapes_[j].hull,
                                 {Vec2(centers_[j]), Rot{}}, near_part * pair_length(shapes_[i], shapes_[j]));
      if (contact.manifold.count > 0) contacts_.push_back(contact);
    }
  }
  solver_.prepare(contacts_, shapes_, motions_, {}, {});
}

void Stack::add_body(const DemonstrationShape& shape, bool fixed) {
  const MassProperties mass = weighed(shape);
  ShapeDef def;
  def.points = shape.parts[0];
  Shape added;
  added.hull = make_hull(def, mass.center);
  added.body = static_cast<BodyIndex>(shapes_.size());
  added.friction_at_rest = added.friction_sliding = friction;
  Motion motion;
  if (!fixed) motion.inv_mass = static_cast<real>(1 / mass.mass);
  if (!fixed) motion.inv_inertia = static_cast<real>(1 / mass.inertia);
  centers_.push_back(mass.center);
  shapes_.push_back(added);
  motions_.push_back(motion);
}

std::string Stack::name(const Contact& contact) const {
  const auto called = [](BodyIndex body) { return body == 0 ? std::string("ground") : std::to_string(body); };
  return filled("%\u2013%", {called(contact.body_a), called(contact.body_b)});
}

Vec2d Stack::at(const Contact& contact, int point) const {
  return centers_[contact.body_a] + Vec2d(contact.manifold.points[point].point);
}

void Stack::begin_substep(double h, bool warm) {
  h_ = static_cast<real>(h);
  for (std::size_t i = 1; i < motions_.size(); ++i) motions_[i].velocity.y -= h_ * static_cast<real>(gravity);
  solver_.begin_substep(motions_, warm ? real(1) : real(0));
}

void Stack::end_substep() {
  for (Motion& motion : motions_) drift(motion, h_);
  solver_.end_substep();
}

std::vector<double> Stack::impulses() const {
  std::vector<double> sums(contacts_.size());
  for (const ContactConstraint& c : solver_.constraints()) {
    for (int k = 0; k < c.count; ++k) sums[c.contact] += static_cast<double>(c.points[k].normal_impulse);
  }
  return sums;
}

}  // namespace proofreel
