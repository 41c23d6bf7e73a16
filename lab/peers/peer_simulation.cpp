#include "lab/peers/peer_simulation.h"

#include <cmath>
#include <utility>

#include "engine/rot.h"
#include "engine/state_hash.h"
#include "lab/measures.h"
#include "lab/peers/peer_problems.h"

namespace proofreel {

PeerSimulation::PeerSimulation(Peer peer, const Scene& scene, std::unique_ptr<PeerWorld> world)
    : peer_(peer), rate_(scene.rate), gravity_(scene.gravity), forces_(scene), world_(std::move(world)) {
  bodies_.emplace_back().def.type = BodyType::fixed;
  for (const BodyDef& body : scene.bodies) add_body(body);
  for (const JointDef& joint : scene.joints) add_joint(joint);
}

void PeerSimulation::add_body(const BodyDef& def) {
  KeptBody& added = bodies_.emplace_back();
  added.def = def;
  added.mass = mass_of(def);
  body_drags_ |= def.drag.has_value();
  world_->add_body(def, added.mass);
}

void PeerSimulation::add_joint(const JointDef& def) {
  joints_.push_back({def});
  breakable_ |= def.break_force.has_value();
  world_->add_joint(def, body(def.b).angle - body(def.a).angle);
}

/// Gears that couple it go first, since the peer's gear holds on to it.
void PeerSimulation::remove_joint(JointId id) {
  KeptJoint& joint = joints_[static_cast<std::size_t>(id)];
  if (!joint.alive) return;
  joint.alive = false;
  for (std::size_t i = 0; i < joints_.size(); ++i) {
    const JointDef& gear = joints_[i].def;
    if (gear.kind == JointKind::gear && (gear.first == id || gear.second == id)) remove_joint(static_cast<JointId>(i));
  }
  world_->remove_joint(id);
}

void PeerSimulation::step() {
  if (failure_) return;
  ++tick_;
  if (commanded_) detect_failure();  // before the peer's own checks, which end the program
  commanded_ = false;
  if (failure_) return;
  if (forces_kept_) {
    for (std::size_t i = 1; i < bodies_.size(); ++i) {
      if (bodies_[i].alive) bodies_[i].velocity_before = world_->motion(static_cast<BodyId>(i)).velocity;
    }
  }
  if (forces_.act() || body_drags_) pull_all();
  world_->step(1.0 / rate_);
  break_joints();
  detect_failure();
}

void PeerSimulation::pull_all() {
  std::vector<LoadedBody> bodies = loaded_bodies(forces_.need_places());
  forces_.add_to(bodies, static_cast<double>(tick_ - 1) / rate_);
  for (const LoadedBody& body : bodies) {
    if (body.type == BodyType::dynamic) world_->pull(body.id, body.force, body.torque);
  }
}

/// Without places no sines and cosines are taken: drag alone shall cost a peer what its users would pay.
std::vector<LoadedBody> PeerSimulation::loaded_bodies(bool with_places) const {
  std::vector<LoadedBody> loaded;
  loaded.reserve(bodies_.size());
  for (std::size_t i = 1; i < bodies_.size(); ++i) {
    if (!bodies_[i].alive) continue;
    const auto id = static_cast<BodyId>(i);
    LoadedBody& added = loaded.emplace_back();
    added.id = id;
    added.type = bodies_[i].def.type;
    added.drag = bodies_[i].def.drag;
    if (with_places) {
      added.state = body(id);
    } else {
      const PeerMotion m = world_->motion(id);
      added.state.velocity = m.velocity;
      added.state.spin = m.spin;
    }
  }
  return loaded;
}

void PeerSimulation::break_joints() {
  break_events_.clear();
  if (!breakable_) return;
  for (std::size_t i = 0; i < joints_.size(); ++i) {
    KeptJoint& joint = joints_[i];
    const auto id = static_cast<JointId>(i);
    if (!joint.alive || !joint.def.break_force) continue;
    const Vec2d force = world_->reaction(id).force;
    if (length(force) <= *joint.def.break_force) continue;
    break_events_.push_back({id, anchor(joint.def.b, joint.def.anchor_b), force});
    remove_joint(id);
    joint.broken = true;
  }
}

void PeerSimulation::detect_failure() {
  for (std::size_t i = 1; i < bodies_.size(); ++i) {
    if (!bodies_[i].alive || bodies_[i].def.type != BodyType::dynamic) continue;
    const PeerMotion m = world_->motion(static_cast<BodyId>(i));
    if (is_finite(m.position) && is_finite(m.velocity) && std::isfinite(m.angle) && std::isfinite(m.spin)) continue;
    failure_ = Failure{tick_, static_cast<BodyId>(i), std::string("a step of ") + name_of(peer_)};
    return;
  }
}

bool PeerSimulation::exists(BodyId body) const {
  const auto index = static_cast<std::size_t>(body);
  return index < bodies_.size() && bodies_[index].alive;
}

bool PeerSimulation::exists(JointId joint) const {
  const auto index = static_cast<std::size_t>(joint);
  return index < joints_.size() && joints_[index].alive;
}

BodyState PeerSimulation::body(BodyId id) const {
  const MassProperties& mass = kept(id).mass;
  if (!exists(id)) return {};
  const PeerMotion m = world_->motion(id);
  const Vec2d center = m.position + rotate(Rotd(m.angle), mass.center);
  return {m.position, center, m.angle, m.velocity, m.spin, mass.mass, mass.inertia};
}

Vec2d PeerSimulation::anchor(BodyId body, Vec2d local) const {
  const PeerMotion m = exists(body) ? world_->motion(body) : PeerMotion{};
  return m.position + rotate(Rotd(m.angle), local);
}

JointView PeerSimulation::joint(JointId id) const {
  const KeptJoint& joint = joints_[static_cast<std::size_t>(id)];
  const JointDef& def = joint.def;
  JointView view;
  view.id = id;
  view.kind = def.kind;
  view.a = def.a;
  view.b = def.b;
  view.anchor_a = anchor(def.a, def.anchor_a);
  view.anchor_b = anchor(def.b, def.anchor_b);
  if (joint.alive) {
    const PeerReaction reaction = world_->reaction(id);
    view.reaction = reaction.force;
    view.torque = reaction.torque;
  }
  view.ratio = def.ratio;
  view.axis = rotate(Rotd(exists(def.a) ? world_->motion(def.a).angle : 0), def.axis);
  view.length = def.length;
  view.pin_a = def.pin_a;
  view.pin_b = def.pin_b;
  view.broken = joint.broken;
  view.gap = joint_gap(view);
  return view;
}

void PeerSimulation::observe_body(BodyId id, Snapshot& snapshot) const {
  const BodyDef& def = kept(id).def;
  BodyView& view = snapshot.bodies.emplace_back();
  view.id = id;
  view.type = def.type;
  view.state = body(id);
  view.pose = {view.state.position, Rotd(view.state.angle)};
  if (forces_kept_ && tick_ > 0) {
    view.force = view.state.mass * rate_ * (view.state.velocity - kept(id).velocity_before);
  }
  view.sensor = def.sensor;
  view.has_color = def.color.has_value();
  view.color = def.color.value_or(0);
  view.first_shape = static_cast<std::uint32_t>(snapshot.shapes.size());
  view.shape_count = static_cast<std::uint32_t>(def.shapes.size());
  for (const ShapeDef& shape : def.shapes) {
    snapshot.shapes.push_back({static_cast<std::uint32_t>(snapshot.points.size()),
                               static_cast<std::uint32_t>(shape.points.size()), shape.radius});
    snapshot.points.insert(snapshot.points.end(), shape.points.begin(), shape.points.end());
  }
}

void PeerSimulation::observe(Snapshot& snapshot) const {
  snapshot = {};
  snapshot.tick = tick_;
  snapshot.time = static_cast<double>(tick_) / rate_;
  snapshot.energy = energy();
  for (std::size_t i = 1; i < bodies_.size(); ++i) {
    if (bodies_[i].alive) observe_body(static_cast<BodyId>(i), snapshot);
  }
  snapshot.contacts = contacts();
  for (std::size_t i = 0; i < joints_.size(); ++i) {
    if (joints_[i].alive) snapshot.joints.push_back(joint(static_cast<JointId>(i)));
  }
}

double PeerSimulation::potential_energy() const {
  const std::vector<LoadedBody> bodies = loaded_bodies(true);
  double sum = forces_.potential(bodies);
  for (const LoadedBody& body : bodies) {
    sum -= body.state.mass * kept(body.id).def.gravity_scale * dot(gravity_, body.state.center);
  }
  for (std::size_t i = 0; i < joints_.size(); ++i) {
    if (!joints_[i].alive || !is_springy(joints_[i].def.kind)) continue;
    const JointView view = joint(static_cast<JointId>(i));
    const Vec2d way = view.anchor_b - view.anchor_a;
    const double stretch = view.kind == JointKind::wheel ? dot(way, view.axis) : length(way) - view.length;
    sum += 0.5 * joints_[i].def.stiffness * stretch * stretch;
  }
  return sum;
}

Energy PeerSimulation::energy() const {
  Energy e;
  for (const LoadedBody& body : loaded_bodies(true)) {
    const BodyState& s = body.state;
    e.kinetic += 0.5 * (s.mass * length_squared(s.velocity) + s.inertia * s.spin * s.spin);
  }
  e.potential = potential_energy();
  e.booked_work = booked_work_;
  return e;
}

std::uint64_t PeerSimulation::state_hash() const {
  std::vector<double> numbers;
  for (std::size_t i = 1; i < bodies_.size(); ++i) {
    if (!bodies_[i].alive) continue;
    const PeerMotion m = world_->motion(static_cast<BodyId>(i));
    for (const double x : {m.position.x, m.position.y, m.angle, m.velocity.x, m.velocity.y, m.spin}) {
      numbers.push_back(x);
    }
  }
  return hash_of(numbers.data(), numbers.size() * sizeof(double));
}

}  // namespace proofreel
