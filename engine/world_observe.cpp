#include "engine/attraction.h"
#include "engine/state_hash.h"
#include "engine/world.h"

namespace proofreel {
inline namespace PROOFREEL_PRECISION {

bool World::exists(BodyId id) const {
  const auto index = static_cast<std::size_t>(id);
  return index < bodies_.size() && bodies_[index].alive;
}

bool World::exists(JointId id) const {
  const auto index = static_cast<std::size_t>(id);
  return index < joints_.size() && joints_[index].alive;
}

std::vector<EffectDecision> World::effects() const {
  std::vector<EffectDecision> decisions = listed_effects_ ? census_.decisions(*listed_effects_) : census_.decisions();
  for (EffectDecision& decision : decisions) {
    if (!decision.on) continue;
    if (decision.effect == Effect::contacts && may_be_exact() && !is_exact()) decision.how = exact_contacts_.told();
    if (decision.effect == Effect::joints) decision.how = told_of_joints();
  }
  return decisions;
}

std::string World::told_of_joints() const {
  std::string text;
  if (most_substeps_ > method_.substeps)
    text = "swings too fast for " + std::to_string(method_.substeps) + " substeps got up to " +
           std::to_string(most_substeps_);
  const std::size_t rows = joint_solver_.rows_of_nets();
  if (rows > 0) text += (text.empty() ? "" : "; ") + std::to_string(rows) + " rows of large nets are solved one by one";
  return text;
}

Pose World::center_pose(BodyIndex index) const { return {bodies_[index].center, motions_[index].rotation}; }

Vec2d World::origin_of(BodyIndex index) const {
  return Vec2d(bodies_[index].center) - rotate(Rotd(motions_[index].rotation), Vec2d(bodies_[index].local_center));
}

BodyState World::body(BodyId id) const {
  const auto index = static_cast<BodyIndex>(id);
  const Motion& motion = motions_[index];
  return {origin_of(index),
          Vec2d(bodies_[index].center),
          static_cast<double>(motion.angle),
          Vec2d(motion.velocity),
          static_cast<double>(motion.spin),
          static_cast<double>(bodies_[index].mass),
          static_cast<double>(bodies_[index].inertia)};
}

JointView World::joint(JointId id) const {
  const Joint& joint = joints_[static_cast<std::size_t>(id)];
  const JointPlace place = place_of(joint, bodies_, motions_);
  JointView view;
  view.id = id;
  view.kind = joint.kind;
  view.a = static_cast<BodyId>(joint.body_a);
  view.b = static_cast<BodyId>(joint.body_b);
  view.anchor_a =
      joint.kind == JointKind::drag_to ? Vec2d(joint.target) : Vec2d(bodies_[joint.body_a].center + place.arm_a);
  view.anchor_b = Vec2d(bodies_[joint.body_b].center + place.arm_b);
  view.reaction = static_cast<double>(rate_) * Vec2d(joint.impulse);
  view.torque = rate_ * static_cast<double>(joint.twist);
  view.gap = static_cast<double>(violation(joint, joints_, bodies_, motions_));
  view.axis = Vec2d(place.axis);
  view.length = static_cast<double>(joint.length);
  view.ratio = static_cast<double>(joint.ratio);
  view.pin_a = Vec2d(joint.pin_a);
  view.pin_b = Vec2d(joint.pin_b);
  view.broken = joint.broken;
  return view;
}

ContactView World::view_of(const Contact& contact) const {
  ContactView view;
  view.a = static_cast<BodyId>(contact.body_a);
  view.b = static_cast<BodyId>(contact.body_b);
  view.normal = Vec2d(contact.manifold.normal);
  view.point_count = contact.manifold.count;
  for (int k = 0; k < view.point_count; ++k) {
    const ManifoldPoint& p = contact.manifold.points[k];
    view.points[k] = {Vec2d(bodies_[contact.body_a].center + p.point), static_cast<double>(p.separation),
                      static_cast<double>(contact.impulses[k].normal_total),
                      static_cast<double>(contact.impulses[k].tangent_total)};
  }
  return view;
}

std::vector<ContactView> World::contacts() const {
  std::vector<ContactView> views;
  auto sleeping = sleep_.contacts.begin();
  const auto add = [&](const Contact& contact) {
    if (contact.manifold.count > 0) views.push_back(view_of(contact));
  };
  for (const Contact& contact : contacts_) {
    for (; sleeping != sleep_.contacts.end() && sleeping->number < contact.number; ++sleeping) add(*sleeping);
    add(contact);
  }
  for (; sleeping != sleep_.contacts.end(); ++sleeping) add(*sleeping);
  return views;
}

void World::observe_bodies(Snapshot& snapshot) const {
  const std::vector<std::uint32_t> islands = islands_kept_ ? find_islands(true) : std::vector<std::uint32_t>{};
  for (BodyIndex i = 1; i < bodies_.size(); ++i) {
    const Body& body_i = bodies_[i];
    if (!body_i.alive) continue;
    BodyView& view = snapshot.bodies.emplace_back();
    view.id = static_cast<BodyId>(i);
    view.type = body_i.type;
    view.state = body(view.id);
    view.pose = {view.state.position, Rotd(motions_[i].rotation)};
    if (i < velocities_before_.size()) {
      const Vec2 gain = motions_[i].velocity - velocities_before_[i];
      view.force = view.state.mass * static_cast<double>(rate_) * Vec2d(gain);
    }
    view.asleep = body_i.asleep();
    if (islands_kept_) view.island = islands[i];
    view.sensor = body_i.sensor;
    view.has_color = body_i.color.has_value();
    view.color = body_i.color.value_or(0);
    view.first_shape = static_cast<std::uint32_t>(snapshot.shapes.size());
    view.shape_count = static_cast<std::uint32_t>(body_i.defs.size());
    for (const ShapeDef& def : body_i.defs) {
      snapshot.shapes.push_back({static_cast<std::uint32_t>(snapshot.points.size()),
                                 static_cast<std::uint32_t>(def.points.size()), def.radius});
      snapshot.points.insert(snapshot.points.end(), def.points.begin(), def.points.end());
    }
  }
}

void World::observe(Snapshot& snapshot) const {
  snapshot = {};
  snapshot.tick = tick_;
  snapshot.time = static_cast<double>(tick_) / rate_;
  snapshot.energy = energy();
  if (on(Effect::buoyancy) && water_) snapshot.water_level = water_->level;
  observe_bodies(snapshot);
  snapshot.contacts = contacts();
  for (std::uint32_t i = 0; i < joints_.size(); ++i) {
    if (joints_[i].alive) snapshot.joints.push_back(joint(static_cast<JointId>(i)));
  }
  if (!has_broad_phase_) return;
  broad_phase_.tree().visit([&](const Aabb& box, int depth, bool leaf) {
    snapshot.tree.push_back({Aabbd(box), depth, leaf});
  });
  for (const Shape& shape : shapes_) {
    if (shape.alive) snapshot.aabbs.push_back(Aabbd(bounds(shape.hull, center_pose(shape.body))));
  }
}

double World::potential_energy() const {
  double potential = 0;
  for (BodyIndex i = 0; i < bodies_.size(); ++i) {
    if (bodies_[i].type != BodyType::dynamic) continue;
    const double weight = static_cast<double>(bodies_[i].mass) * static_cast<double>(bodies_[i].gravity_scale);
    potential -= weight * dot(Vec2d(effective_gravity()), Vec2d(bodies_[i].center + motions_[i].delta));
  }
  for (const Joint& joint : joints_) {
    if (!on(Effect::springs) || !joint.alive || !is_springy(joint.kind)) continue;
    potential += stored_energy(joint, bodies_, motions_);
  }
  if (on(Effect::attractor)) {
    for (const AttractorDef& attractor : attractors_) potential += potential_of(attractor, bodies_, motions_);
  }
  if (on(Effect::buoyancy)) potential += potential_of_water();
  if (on(Effect::nbody)) potential += mutual_potential(gravitational_constant_, bodies_, motions_);
  return potential;
}

Energy World::energy() const {
  Energy e;
  for (BodyIndex i = 0; i < bodies_.size(); ++i) {
    if (bodies_[i].type != BodyType::dynamic) continue;
    const auto spin = static_cast<double>(motions_[i].spin);
    e.kinetic += 0.5 * (static_cast<double>(bodies_[i].mass) * length_squared(Vec2d(motions_[i].velocity)) +
                        static_cast<double>(bodies_[i].inertia) * spin * spin);
  }
  e.potential = potential_energy();
  e.booked_work = booked_work_;
  return e;
}

std::uint64_t World::state_hash() const {
  std::vector<real> numbers;
  numbers.reserve(8 * bodies_.size());
  for (BodyIndex i = 1; i < bodies_.size(); ++i) {
    if (!bodies_[i].alive) continue;
    const Motion& m = motions_[i];
    for (const real x : {bodies_[i].center.x, bodies_[i].center.y, m.rotation.c, m.rotation.s, m.angle, m.velocity.x,
                         m.velocity.y, m.spin}) {
      numbers.push_back(x);
    }
  }
  return hash_of(numbers.data(), numbers.size() * sizeof(real));
}

}  // namespace PROOFREEL_PRECISION
}  // namespace proofreel
