// What scripts ask of a peer while it runs.

#include "engine/rot.h"
#include "lab/peers/peer_problems.h"
#include "lab/peers/peer_simulation.h"

namespace proofreel {

/// Whatever a command does to the energy at once is work from outside.
void PeerSimulation::apply(const Command& command) {
  const bool acts_later = std::holds_alternative<ApplyForce>(command) || std::holds_alternative<ApplyTorque>(command);
  const double before = acts_later ? 0 : energy().total();
  std::visit([this](const auto& c) { execute(c); }, command);
  commanded_ = true;
  if (!acts_later) booked_work_ += energy().total() - before;
}

void PeerSimulation::execute(const AllowSleep&) {
  throw UnknownToPeer(std::string("Bodies cannot be told to sleep in ") + name_of(peer_));
}

void PeerSimulation::execute(const CreateBody& command) {
  if (const Problem problem = problem_with(peer_, command.def)) {
    throw UnknownToPeer(sentence(peer_, command.def, bodies_.size(), *problem));
  }
  add_body(command.def);
}

namespace {

/// The definition as it is after the change.
BodyDef changed(BodyDef def, const ChangeBody& change) {
  def.type = change.type.value_or(def.type);
  if (change.shapes) def.shapes = *change.shapes;
  for (ShapeDef& shape : def.shapes) {
    shape.friction = change.friction.value_or(shape.friction);
    shape.restitution = change.restitution.value_or(shape.restitution);
    shape.rolling_resistance = change.rolling_resistance.value_or(shape.rolling_resistance);
    shape.surface_speed = change.surface_speed.value_or(shape.surface_speed);
    shape.density = change.density.value_or(shape.density);
  }
  if (change.mass) def.mass = change.mass;
  if (change.inertia) def.inertia = change.inertia;
  def.gravity_scale = change.gravity_scale.value_or(def.gravity_scale);
  def.fixed_rotation = change.fixed_rotation.value_or(def.fixed_rotation);
  def.bullet = change.bullet.value_or(def.bullet);
  def.sensor = change.sensor.value_or(def.sensor);
  def.filter = change.filter.value_or(def.filter);
  if (change.drag) def.drag = change.drag;
  if (change.color) def.color = change.color;
  return def;
}

/// Whether it asks for more than another motion, color or drag.
bool changes_the_body(const ChangeBody& c) {
  return c.type || c.shapes || c.mass || c.inertia || c.friction || c.restitution || c.rolling_resistance ||
         c.surface_speed || c.density || c.gravity_scale || c.fixed_rotation || c.bullet || c.sensor || c.filter;
}

}  // namespace

void PeerSimulation::execute(const ChangeBody& change) {
  KeptBody& body = kept(change.body);
  const BodyDef def = changed(body.def, change);
  const auto number = static_cast<std::size_t>(change.body);
  if (const Problem problem = problem_with(peer_, def)) throw UnknownToPeer(sentence(peer_, def, number, *problem));
  PeerMotion motion = world_->motion(change.body);
  const Vec2d center_before = body.mass.center;
  body.def = def;
  body_drags_ |= def.drag.has_value();
  if (changes_the_body(change)) {
    body.mass = mass_of(def);
    world_->change_body(change.body, def, body.mass);
  }
  // Every point of the body goes on as before, even where the centre of mass has moved.
  motion.velocity += cross(motion.spin, rotate(Rotd(motion.angle), body.mass.center - center_before));
  motion.position = change.position.value_or(motion.position);
  motion.angle = change.angle.value_or(motion.angle);
  motion.velocity = change.velocity.value_or(motion.velocity);
  motion.spin = change.spin.value_or(motion.spin);
  if (def.type == BodyType::fixed) {
    motion.velocity = {};
    motion.spin = 0;
  }
  world_->set_motion(change.body, motion);
}

void PeerSimulation::execute(const RemoveBody& command) {
  for (std::size_t i = 0; i < joints_.size(); ++i) {
    const JointDef& def = joints_[i].def;
    if (def.a == command.body || def.b == command.body) remove_joint(static_cast<JointId>(i));
  }
  kept(command.body).alive = false;
  world_->remove_body(command.body);
}

void PeerSimulation::execute(const ApplyImpulse& command) {
  if (kept(command.body).def.type != BodyType::dynamic) return;
  world_->push(command.body, command.impulse, command.at.value_or(body(command.body).center));
}

void PeerSimulation::execute(const ApplyForce& command) {
  if (kept(command.body).def.type != BodyType::dynamic) return;
  const Vec2d center = body(command.body).center;
  world_->pull(command.body, command.force, cross(command.at.value_or(center) - center, command.force));
}

void PeerSimulation::execute(const ApplyTorque& command) {
  if (kept(command.body).def.type == BodyType::dynamic) world_->pull(command.body, {}, command.torque);
}

void PeerSimulation::execute(const CreateJoint& command) {
  if (const Problem problem = problem_with(peer_, command.def)) {
    throw UnknownToPeer(sentence(peer_, command.def, joints_.size(), *problem));
  }
  add_joint(command.def);
}

void PeerSimulation::execute(const RemoveJoint& command) { remove_joint(command.joint); }

/// The target of a drag_to and the velocity of a motor joint belong to joints that no peer has.
void PeerSimulation::execute(const ChangeJoint& change) {
  if (!change.speed) return;
  joints_[static_cast<std::size_t>(change.joint)].def.motor->speed = *change.speed;
  world_->set_speed(change.joint, *change.speed);
}

}  // namespace proofreel
