#include <algorithm>

#include "engine/mass.h"
#include "engine/world.h"

namespace proofreel {
inline namespace PROOFREEL_PRECISION {
namespace {

BodyIndex index_of(BodyId id) { return static_cast<BodyIndex>(id); }

double inverse_or_zero(double x) { return x > 0 ? 1 / x : 0; }

}  // namespace

/// Whatever a command does to the energy is work from outside. Forces do theirs during the tick (`book_work`).
void World::apply(const Command& command) {
  const bool acts_later = std::holds_alternative<ApplyForce>(command) || std::holds_alternative<ApplyTorque>(command);
  if (sleep_.sleepers > 0) std::visit([this](const auto& c) { wake_for(c); }, command);
  const double before = acts_later ? 0 : energy().total();
  std::visit([this](const auto& c) { execute(c); }, command);
  commanded_ = true;
  if (!acts_later) booked_work_ += energy().total() - before;
}

void World::add_body(const BodyDef& def) {
  const auto index = static_cast<BodyIndex>(bodies_.size());
  Body& body = bodies_.emplace_back();
  Motion& motion = motions_.emplace_back();
  body.name = def.name;
  body.type = body.acts_as = def.type;
  body.fixed_rotation = def.fixed_rotation;
  body.bullet = def.bullet;
  body.sensor = def.sensor;
  body.gravity_scale = static_cast<real>(def.gravity_scale);
  body.filter = def.filter;
  body.drag = def.drag;
  body.color = def.color;
  body.defs = def.shapes;
  body.given_mass = def.mass;
  body.given_inertia = def.inertia;
  motion.angle = static_cast<real>(def.angle);
  motion.rotation = Rot(Rotd(def.angle));
  reshape(index, def.position);
  if (def.type != BodyType::fixed) {
    motion.velocity = Vec2(def.velocity);
    motion.spin = static_cast<real>(def.spin);
  }
  census_.add(def);
}

/// Makes shapes and mass from the body's definitions, with its origin at `origin`.
void World::reshape(BodyIndex index, Vec2d origin) {
  Body& body = bodies_[index];
  Motion& motion = motions_[index];
  BodyDef def;
  def.type = body.type;
  def.shapes = body.defs;
  def.mass = body.given_mass;
  def.inertia = body.given_inertia;
  const MassProperties mass = mass_of(def);
  body.mass = static_cast<real>(mass.mass);
  body.inertia = static_cast<real>(mass.inertia);
  move_center(index, Vec2(mass.center) - body.local_center);
  body.center = Vec2(origin + rotate(Rotd(motion.rotation), mass.center));
  motion.inv_mass = static_cast<real>(inverse_or_zero(mass.mass));
  motion.inv_inertia = body.fixed_rotation ? real(0) : static_cast<real>(inverse_or_zero(mass.inertia));
  make_room_for_shapes(index);
  for (std::size_t i = 0; i < body.defs.size(); ++i) {
    const ShapeDef& shape_def = body.defs[i];
    Shape& shape = shapes_[body.shapes[i]];
    shape.hull = make_hull(shape_def, mass.center);
    shape.friction_at_rest = static_cast<real>(shape_def.friction.at_rest);
    shape.friction_sliding = static_cast<real>(shape_def.friction.sliding);
    shape.restitution = static_cast<real>(shape_def.restitution);
    shape.rolling_resistance = static_cast<real>(shape_def.rolling_resistance);
    shape.surface_speed = static_cast<real>(shape_def.surface_speed);
    shape.reach = reach(shape.hull);
    if (has_broad_phase_) broad_phase_.add(body.shapes[i], shape, bounds(shape.hull, center_pose(index)));
  }
  for (Contact& contact : contacts_) {
    if (contact.body_a != index && contact.body_b != index) continue;
    mix_materials(contact, shapes_[contact.shape_a], shapes_[contact.shape_b]);
  }
  join_shapes_of(index);
  structure_changed_ = true;
}

/// Anchors and velocity are told relative to the centre of mass: when that moves within the body, they are told anew,
/// so that joints hold where they held and every point of the body goes on as before.
void World::move_center(BodyIndex index, Vec2 way) {
  bodies_[index].local_center += way;
  Motion& motion = motions_[index];
  motion.velocity += cross(motion.spin, rotate(motion.rotation, way));
  for (Joint& joint : joints_) {
    if (joint.body_a == index) joint.local_a -= way;
    if (joint.body_b == index) joint.local_b -= way;
  }
}

/// As many shapes as there are definitions, out of the broad phase. The same number as before stays the same shapes, so
/// that their contacts live on.
void World::make_room_for_shapes(BodyIndex index) {
  Body& body = bodies_[index];
  if (body.shapes.size() == body.defs.size()) {
    for (const ShapeIndex i : body.shapes) {
      if (has_broad_phase_) broad_phase_.remove(i, shapes_[i]);
    }
    return;
  }
  remove_shapes(index);
  for (std::size_t i = 0; i < body.defs.size(); ++i) {
    body.shapes.push_back(place_for_shape());
    shapes_[body.shapes.back()].body = index;
  }
}

/// Places of shapes that are gone are used again, so that scenes in which things come and go do not grow.
ShapeIndex World::place_for_shape() {
  if (free_shapes_.empty()) {
    shapes_.emplace_back();
    return static_cast<ShapeIndex>(shapes_.size() - 1);
  }
  const ShapeIndex place = free_shapes_.back();
  free_shapes_.pop_back();
  shapes_[place] = {};
  return place;
}

void World::remove_shapes(BodyIndex index) {
  drop_contacts_of(index);
  for (const ShapeIndex i : bodies_[index].shapes) {
    if (has_broad_phase_) broad_phase_.remove(i, shapes_[i]);
    shapes_[i].alive = false;
    free_shapes_.push_back(i);
  }
  bodies_[index].shapes.clear();
}

void World::drop_contacts_of(BodyIndex index) {
  std::erase_if(contacts_, [this, index](const Contact& c) {
    if (c.body_a != index && c.body_b != index) return false;
    broad_phase_.forget({c.shape_a, c.shape_b});
    if (c.touching) separated_by_commands_.push_back(separation_of(c));
    return true;
  });
}

void World::execute(const CreateBody& command) { add_body(command.def); }

void World::execute(const ChangeBody& change) {
  const BodyIndex index = index_of(change.body);
  Body& body = bodies_[index];
  Motion& motion = motions_[index];
  const Vec2d origin = change.position.value_or(origin_of(index));
  ground_changed_ |= body.type == BodyType::fixed;
  if (change.type) body.type = body.acts_as = *change.type;
  if (change.angle) {
    motion.angle = static_cast<real>(*change.angle);
    motion.rotation = Rot(Rotd(*change.angle));
  }
  if (change.shapes) body.defs = *change.shapes;
  for (ShapeDef& shape : body.defs) {
    if (change.friction) shape.friction = *change.friction;
    if (change.restitution) shape.restitution = *change.restitution;
    if (change.rolling_resistance) shape.rolling_resistance = *change.rolling_resistance;
    if (change.surface_speed) shape.surface_speed = *change.surface_speed;
    if (change.density) shape.density = *change.density;
  }
  if (change.mass) body.given_mass = change.mass;
  if (change.inertia) body.given_inertia = change.inertia;
  if (change.gravity_scale) body.gravity_scale = static_cast<real>(*change.gravity_scale);
  body.fixed_rotation = change.fixed_rotation.value_or(body.fixed_rotation);
  body.bullet = change.bullet.value_or(body.bullet);
  body.sensor = change.sensor.value_or(body.sensor);
  if (change.filter) body.filter = *change.filter;
  if (change.drag) body.drag = change.drag;
  if (change.color) body.color = change.color;
  const bool same_body = !change.type && !change.position && !change.angle && !change.shapes && !change.friction &&
                         !change.restitution && !change.rolling_resistance && !change.surface_speed &&
                         !change.density && !change.mass && !change.inertia && !change.fixed_rotation &&
                         !change.sensor && !change.filter;
  if (change.shapes || change.type || change.sensor || change.filter) drop_contacts_of(index);
  if (!same_body) reshape(index, origin);
  if (change.velocity) motion.velocity = Vec2(*change.velocity);
  if (change.spin) motion.spin = static_cast<real>(*change.spin);
  if (body.type == BodyType::fixed) {
    motion.velocity = {};
    motion.spin = 0;
  }
  if (!change.type && !change.shapes && !change.friction && !change.restitution && !change.rolling_resistance &&
      !change.surface_speed && !change.sensor && !change.filter && !change.drag && !change.gravity_scale)
    return;
  structure_changed_ = true;
  BodyDef def;
  def.drag = body.drag;
  def.type = body.type;
  def.sensor = body.sensor;
  def.filter = body.filter;
  def.shapes = body.defs;
  census_.add(def);
}

void World::execute(const RemoveBody& command) {
  const BodyIndex index = index_of(command.body);
  ground_changed_ |= bodies_[index].type == BodyType::fixed;
  remove_shapes(index);
  for (std::size_t i = 0; i < joints_.size(); ++i) {
    if (joints_[i].body_a == index || joints_[i].body_b == index) remove_joint(i);
  }
  bodies_[index].alive = false;
  bodies_[index].name = {};
  bodies_[index].defs = {};
  bodies_[index].shapes = {};
  bodies_[index].type = bodies_[index].acts_as = BodyType::fixed;
  motions_[index].velocity = {};
  motions_[index].spin = 0;
  motions_[index].inv_mass = 0;
  motions_[index].inv_inertia = 0;
  std::erase_if(pushed_, [index](const Push& push) { return push.body == index; });
  bodies_[index].mass = 0;
  bodies_[index].inertia = 0;
  structure_changed_ = true;
}

void World::execute(const ApplyImpulse& command) {
  const BodyIndex index = index_of(command.body);
  const Vec2 arm = command.at ? Vec2(*command.at) - bodies_[index].center : Vec2{};
  motions_[index].push(Vec2(command.impulse), arm);
}

World::Push& World::push_on(BodyIndex index) {
  const auto at = std::lower_bound(pushed_.begin(), pushed_.end(), index,
                                   [](const Push& push, BodyIndex body) { return push.body < body; });
  return at != pushed_.end() && at->body == index ? *at : *pushed_.insert(at, Push{index, {}, 0, 0});
}

void World::execute(const ApplyForce& command) {
  const BodyIndex index = index_of(command.body);
  if (bodies_[index].type != BodyType::dynamic) return;
  Push& push = push_on(index);
  const Vec2 force(command.force);
  push.force += force;
  if (command.at) push.torque += cross(Vec2(*command.at) - bodies_[index].center, force);
}

void World::execute(const ApplyTorque& command) {
  const BodyIndex index = index_of(command.body);
  if (bodies_[index].type == BodyType::dynamic) push_on(index).torque += static_cast<real>(command.torque);
}

/// What a joint's errors are measured by: its own length, or where it has none that of the bodies it holds.
real World::size_of(const Joint& joint) const {
  real size = length(joint.local_a) + length(joint.local_b) + joint.length;
  for (const BodyIndex body : {joint.body_a, joint.body_b}) {
    if (joint.body_a == 0 && body == 0) continue;
    for (const ShapeIndex i : bodies_[body].shapes) size = std::max(size, real(0.1) * shapes_[i].reach);
  }
  return size > 0 ? size : real(1);
}

void World::add_joint(const JointDef& def) {
  Joint joint = make_joint(def);
  joint.local_a = Vec2(def.anchor_a) - bodies_[joint.body_a].local_center;
  joint.local_b = Vec2(def.anchor_b) - bodies_[joint.body_b].local_center;
  joint.angle = motions_[joint.body_b].angle - motions_[joint.body_a].angle;
  joint.size = size_of(joint);
  joint.offset = joint_offset(joint, joints_, bodies_, motions_);
  joints_.push_back(joint);
  census_.add(def);
  structure_changed_ = true;
}

void World::add_rocket(const RocketDef& def) {
  const BodyIndex body = index_of(def.body);
  rockets_.push_back({body, def.thrust, def.burn_rate, def.fuel, def.at - Vec2d(bodies_[body].local_center)});
}

void World::execute(const CreateJoint& command) { add_joint(command.def); }

void World::execute(const RemoveJoint& command) { remove_joint(static_cast<std::size_t>(command.joint)); }

void World::remove_joint(std::size_t index) {
  joints_[index].alive = joints_[index].acts = false;
  structure_changed_ = true;
  for (std::size_t i = 0; i < joints_.size(); ++i) {
    const Joint& gear = joints_[i];
    if (!gear.alive || gear.kind != JointKind::gear) continue;
    if (gear.first == index || gear.second == index) remove_joint(i);
  }
}

void World::execute(const ChangeJoint& change) {
  Joint& joint = joints_[static_cast<std::size_t>(change.joint)];
  if (change.target) joint.target = Vec2(*change.target);
  if (change.velocity) joint.velocity = Vec2(*change.velocity);
  if (change.speed) joint.motor->speed = static_cast<real>(*change.speed);
}

/// `wake_for` has done it.
void World::execute(const WakeBody&) {}

void World::execute(const AllowSleep&) {
  census_.allow_sleep();
  structure_changed_ = true;
}

}  // namespace PROOFREEL_PRECISION
}  // namespace proofreel
