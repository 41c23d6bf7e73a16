#include "engine/world.h"

#include <algorithm>
#include <cmath>

#include "engine/attraction.h"
#include "engine/drag.h"
#include "engine/impact.h"

namespace proofreel {
inline namespace PROOFREEL_PRECISION {
namespace {

/// Contacts are heavily damped springs: they must drive overlap out, not store energy.
constexpr real contact_damping_ratio = 10;
/// As stiff as a substep can carry, in oscillations per substep. Twice as much (the usual limit) leaves a stack of four
/// boxes rocking for ever when gravity comes in halves; at this value it comes to rest to the last bit.
constexpr real contact_stiffness = real(0.125);

std::uint64_t unordered_key(BodyIndex a, BodyIndex b) {
  return static_cast<std::uint64_t>(std::min(a, b)) << 32 | std::max(a, b);
}

}  // namespace

World::World(const Scene& scene)
    : method_(scene.method),
      rate_(scene.rate),
      dt_(real(1) / static_cast<real>(scene.rate)),
      h_(dt_ / static_cast<real>(scene.method.substeps)),
      gravity_(scene.gravity),
      drag_(scene.drag),
      wind_(scene.wind),
      attractors_(scene.attractors),
      gravitational_constant_(scene.gravitational_constant.value_or(0)),
      listed_effects_(scene.effects),
      census_(scene) {
  bodies_.emplace_back().name = "world";
  motions_.emplace_back();
  for (const BodyDef& def : scene.bodies) add_body(def);
  for (const JointDef& def : scene.joints) add_joint(def);
  for (const RocketDef& def : scene.rockets) add_rocket(def);
  rebuild_if_changed();
}

void World::step() {
  if (failure_) return;
  rebuild_if_changed();
  begin_tick();
  if (on(Effect::contacts)) find_contacts();
  prepare_solvers();
  for (int i = 0; i < method_.substeps; ++i) substep(h_);
  ++tick_;
  book_work();
  end_tick();
  collect_events();
  detect_failure();
}

void World::rebuild_if_changed() {
  if (!structure_changed_) return;
  structure_changed_ = false;
  effects_ = listed_effects_ ? *listed_effects_ : census_.inferred();
  if (on(Effect::joints)) joint_solver_.rebuild(joints_, motions_);
  hinged_.clear();
  for (const Joint& joint : joints_) {
    if (joint.alive && joint.kind == JointKind::revolute) hinged_.insert(unordered_key(joint.body_a, joint.body_b));
  }
  if (!on(Effect::contacts)) return;
  if (ground_changed_) join_fixed_shapes();
  ground_changed_ = false;
  if (has_broad_phase_) return;
  has_broad_phase_ = true;
  for (ShapeIndex i = 0; i < shapes_.size(); ++i) {
    Shape& shape = shapes_[i];
    if (shape.alive) broad_phase_.add(i, shape, bounds(shape.hull, center_pose(shape.body)));
  }
}

void World::begin_tick() {
  for (BodyIndex i = 0; i < bodies_.size(); ++i) {
    Body& body = bodies_[i];
    body.velocity_before = motions_[i].velocity;
    body.angle_before = motions_[i].angle;
    body.acceleration = {};
    body.angular_acceleration = 0;
    if (body.type != BodyType::dynamic) continue;
    body.acceleration = motions_[i].inv_mass * body.force;
    body.acceleration += body.gravity_scale * effective_gravity();
    body.angular_acceleration = motions_[i].inv_inertia * body.torque;
  }
  for (Joint& joint : joints_) joint.impulse = {};
}

void World::find_contacts() {
  update_boxes();
  drop_parted_contacts();
  for (const ShapePair pair : broad_phase_.new_pairs(shapes_, bodies_)) {
    Contact contact;
    contact.shape_a = pair.a;
    contact.shape_b = pair.b;
    contact.body_a = shapes_[pair.a].body;
    contact.body_b = shapes_[pair.b].body;
    contact.sensor = bodies_[contact.body_a].sensor || bodies_[contact.body_b].sensor;
    mix_materials(contact, shapes_[pair.a], shapes_[pair.b]);
    contacts_.push_back(contact);
  }
  for (Contact& contact : contacts_) {
    if (contact.sensor && !on(Effect::sensors)) continue;
    if (hinged_together(contact.body_a, contact.body_b)) {
      contact.manifold.count = 0;
      continue;
    }
    update_manifold(contact, shapes_, bodies_, motions_, dt_, on(Effect::ccd));
  }
}

bool World::hinged_together(BodyIndex a, BodyIndex b) const {
  return on(Effect::joints) && hinged_.contains(unordered_key(a, b));
}

void World::update_boxes() {
  for (ShapeIndex i = 0; i < shapes_.size(); ++i) {
    const Shape& shape = shapes_[i];
    if (!shape.alive || bodies_[shape.body].type == BodyType::fixed) continue;
    const Motion& motion = motions_[shape.body];
    const real turn =
        std::min(dt_ * std::abs(motion.spin), real(2));  // no point moves farther by turning than twice its reach
    const Aabb box = expanded(bounds(shape.hull, center_pose(shape.body)), turn * shape.reach);
    broad_phase_.move(i, shape, box, dt_ * motion.velocity);
  }
}

void World::drop_parted_contacts() {
  std::erase_if(contacts_, [this](const Contact& c) {
    if (broad_phase_.boxes_overlap(shapes_[c.shape_a], shapes_[c.shape_b])) return false;
    broad_phase_.forget({c.shape_a, c.shape_b});
    return true;
  });
}

void World::prepare_solvers() {
  if (on(Effect::contacts)) {
    const real hertz = method_.contact_hz ? static_cast<real>(*method_.contact_hz) : contact_stiffness / h_;
    contact_solver_.prepare(contacts_, shapes_, bodies_, motions_, make_softness(hertz, contact_damping_ratio, h_),
                            on(Effect::friction));
  }
  if (on(Effect::joints)) joint_solver_.linearize(joints_, bodies_, motions_);
}

/// Verlet splits the forces in two halves, one before the drift and one after it; symplectic Euler gives them all
/// before. What changes velocities by a law of its own (burning rockets, drag) lies around all of that, in the same
/// halves: there positions and velocities belong to one time, so that the work done is booked exactly.
void World::substep(real h) {
  const bool verlet = method_.integrator == Integrator::verlet;
  const real share = verlet ? real(0.5) : real(1);
  const bool joints = on(Effect::joints) && !joint_solver_.empty();
  if (on(Effect::restitution)) {
    const real resting_speed = h * length(effective_gravity());
    resolve_impacts(contact_solver_.constraints(), bodies_, motions_, h, resting_speed, on(Effect::friction));
  }
  if (verlet && on(Effect::drag)) drag_all(share * h);
  if (verlet && on(Effect::rocket)) burn_rockets(share * h);
  kick(share * h);
  contact_solver_.begin_substep(motions_, share);
  if (joints) joint_solver_.begin_substep(joints_, motions_);
  for (int i = 0; i < method_.iterations; ++i) {
    contact_solver_.solve(motions_, h);
    if (joints) joint_solver_.solve_positions(joints_, bodies_, motions_, h);
  }
  drift_all(h);
  if (joints) joint_solver_.linearize(joints_, bodies_, motions_);
  if (verlet) {
    kick(share * h);
    contact_solver_.add_share(motions_, share);
  }
  if (on(Effect::rocket)) burn_rockets(share * h);
  if (on(Effect::drag)) drag_all(share * h);
  for (int i = 0; i < method_.iterations; ++i) {
    contact_solver_.relax(motions_, h);
    if (joints) joint_solver_.solve_velocities(joints_, motions_);
  }
  contact_solver_.end_substep();
}

void World::kick(real h) {
  for (BodyIndex i = 0; i < bodies_.size(); ++i) {
    if (bodies_[i].type != BodyType::dynamic) continue;
    motions_[i].velocity += h * bodies_[i].acceleration;
    motions_[i].spin += h * bodies_[i].angular_acceleration;
  }
  if (on(Effect::attractor) || on(Effect::nbody)) kick_by_attraction(h);
  if (!on(Effect::springs)) return;
  for (Joint& joint : joints_) {
    if (joint.alive && joint.kind == JointKind::spring) kick_spring(joint, bodies_, motions_, h);
  }
}

void World::kick_by_attraction(real h) {
  if (on(Effect::attractor)) {
    for (const AttractorDef& attractor : attractors_) kick_towards(attractor, bodies_, motions_, h);
  }
  if (on(Effect::nbody)) kick_towards_each_other(gravitational_constant_, bodies_, motions_, h);
}

/// What a rocket does is work from outside: its fuel holds energy that nobody counts.
void World::burn_rockets(real h) {
  for (Rocket& rocket : rockets_) {
    if (rocket.fuel <= 0) continue;
    const double before = potential_energy();
    booked_work_ += burn(rocket, bodies_[rocket.body], motions_[rocket.body], h);
    booked_work_ += potential_energy() - before;
  }
}

void World::drag_all(real h) {
  const Vec2 wind = on(Effect::wind) ? wind_ : Vec2{};
  for (BodyIndex i = 1; i < bodies_.size(); ++i) {
    const DragDef& drag = bodies_[i].drag ? *bodies_[i].drag : drag_;
    if (bodies_[i].type == BodyType::dynamic && drag.acts()) apply_drag(motions_[i], drag, wind, h);
  }
}

void World::drift_all(real h) {
  for (Motion& motion : motions_) drift(motion, h);
}

void World::end_tick() {
  if (on(Effect::contacts)) contact_solver_.store(contacts_);
  for (BodyIndex i = 0; i < bodies_.size(); ++i) {
    bodies_[i].center += motions_[i].delta;
    motions_[i].delta = {};
    bodies_[i].force = {};
    bodies_[i].torque = 0;
  }
}

/// What went into the bodies from outside during the tick: forces of commands, and whatever a moving kinematic body
/// pushed.
void World::book_work() {
  for (BodyIndex i = 0; i < bodies_.size(); ++i) {
    const real turned_by = motions_[i].angle - bodies_[i].angle_before;
    booked_work_ += static_cast<double>(dot(bodies_[i].force, motions_[i].delta) + bodies_[i].torque * turned_by);
  }
  const auto book = [this](BodyIndex pusher, Vec2 impulse, Vec2 arm) {
    if (bodies_[pusher].type != BodyType::kinematic) return;
    booked_work_ += static_cast<double>(dot(impulse, motions_[pusher].velocity_at(arm)));
  };
  if (on(Effect::contacts)) {
    for (const ContactConstraint& c : contact_solver_.constraints()) {
      for (int k = 0; k < c.count; ++k) {
        const ConstraintPoint& p = c.points[k];
        const Vec2 on_b = p.normal_total * c.normal + p.tangent_total * perp(c.normal);
        book(c.body_a, on_b, p.arm_a);
        book(c.body_b, -on_b, p.arm_b);
      }
    }
  }
  for (const Joint& joint : joints_) {
    if (!joint.alive) continue;
    const AnchorGap g = anchor_gap(joint, bodies_, motions_);
    book(joint.body_a, joint.impulse, g.arm_a);
    book(joint.body_b, -joint.impulse, g.arm_b);
  }
}

void World::collect_events() {
  events_.clear();
  if (!on(Effect::contacts)) return;
  for (Contact& contact : contacts_) {
    const bool before = contact.touching;
    real impulse = 0;
    contact.touching = false;
    for (int k = 0; k < contact.manifold.count; ++k) {
      contact.touching |= contact.manifold.points[k].separation <= 0 || contact.impulses[k].normal_total > 0;
      impulse += contact.impulses[k].normal_total;
    }
    if (!contact.touching || before) continue;
    const ContactView view = view_of(contact);
    events_.push_back({view.a, view.b, view.points[0].point, view.normal, static_cast<double>(impulse)});
  }
}

void World::detect_failure() {
  for (BodyIndex i = 0; i < bodies_.size(); ++i) {
    if (bodies_[i].type != BodyType::dynamic) continue;
    const Motion& m = motions_[i];
    if (is_finite(bodies_[i].center) && is_finite(m.velocity) && std::isfinite(m.angle) && std::isfinite(m.spin))
      continue;
    failure_ = Failure{tick_, static_cast<BodyId>(i), stage_of_failure(i)};
    return;
  }
}

const char* World::stage_of_failure(BodyIndex body) const {
  for (const Joint& joint : joints_) {
    const bool here = joint.body_a == body || joint.body_b == body;
    if (here && !is_finite(joint.impulse)) return joint.kind == JointKind::spring ? "springs" : "joints";
  }
  for (const Contact& contact : contacts_) {
    if (contact.body_a != body && contact.body_b != body) continue;
    for (const PointImpulse& p : contact.impulses) {
      if (!std::isfinite(p.normal) || !std::isfinite(p.tangent)) return "contacts";
    }
  }
  return "integration";
}

std::unique_ptr<Simulation> make_world(const Scene& scene) { return std::make_unique<World>(scene); }

}  // namespace PROOFREEL_PRECISION
}  // namespace proofreel
