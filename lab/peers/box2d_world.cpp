#include "lab/peers/box2d_world.h"

#include <algorithm>

#include "lab/peers/box2d_joints.h"
#include "lab/peers/box2d_shapes.h"
#include "lab/peers/peer_contacts.h"

namespace proofreel {
namespace {

struct Iterations {
  int velocity = 8;
  int position = 3;
};

Iterations iterations_of(PeerPreset preset) {
  return preset == PeerPreset::accurate ? Iterations{64, 24} : Iterations{};
}

b2BodyType type_of(BodyType type) {
  if (type == BodyType::dynamic) return b2_dynamicBody;
  return type == BodyType::kinematic ? b2_kinematicBody : b2_staticBody;
}

BodyId id_of(b2Fixture* fixture) { return static_cast<BodyId>(fixture->GetBody()->GetUserData().pointer); }

class Box2dWorld final : public PeerWorld, b2ContactFilter, b2ContactListener {
 public:
  Box2dWorld(Vec2d gravity, Iterations iterations) : world_(to_b2(gravity)), iterations_(iterations) {
    world_.SetAllowSleeping(false);
    world_.SetContactFilter(this);
    world_.SetContactListener(this);
    bodies_.push_back({world_.CreateBody(&world_body_), {}, {}});
  }

  void add_body(const BodyDef& def, const MassProperties& mass) override {
    b2BodyDef body;
    body.type = type_of(def.type);
    body.position = to_b2(def.position);
    body.angle = static_cast<float>(def.angle);
    body.userData.pointer = bodies_.size();
    bodies_.push_back({world_.CreateBody(&body), {}, {}});
    const auto id = static_cast<BodyId>(bodies_.size() - 1);
    equip(id, def, mass);
    if (def.type != BodyType::fixed) set_motion(id, {def.position, def.angle, def.velocity, def.spin});
  }

  void change_body(BodyId id, const BodyDef& def, const MassProperties& mass) override {
    b2Body& body = *at(id).body;
    while (b2Fixture* fixture = body.GetFixtureList()) body.DestroyFixture(fixture);
    at(id).fixtures.clear();
    body.SetType(type_of(def.type));
    equip(id, def, mass);
  }

  void remove_body(BodyId id) override {
    world_.DestroyBody(at(id).body);
    at(id).body = nullptr;
  }

  PeerMotion motion(BodyId id) const override {
    const b2Body& body = *at(id).body;
    return {from_b2(body.GetPosition()), static_cast<double>(body.GetAngle()), from_b2(body.GetLinearVelocity()),
            static_cast<double>(body.GetAngularVelocity())};
  }

  void set_motion(BodyId id, const PeerMotion& motion) override {
    b2Body& body = *at(id).body;
    body.SetTransform(to_b2(motion.position), static_cast<float>(motion.angle));
    body.SetLinearVelocity(to_b2(motion.velocity));
    body.SetAngularVelocity(static_cast<float>(motion.spin));
  }

  void push(BodyId id, Vec2d impulse, Vec2d point) override {
    at(id).body->ApplyLinearImpulse(to_b2(impulse), to_b2(point), true);
  }

  void pull(BodyId id, Vec2d force, double torque) override {
    at(id).body->ApplyForceToCenter(to_b2(force), true);
    at(id).body->ApplyTorque(static_cast<float>(torque), true);
  }

  void add_joint(const JointDef& def, double turn) override {
    Box2dJointEnds ends{at(def.a).body, at(def.b).body, turn, nullptr, nullptr};
    if (def.kind == JointKind::gear) {
      ends.first = joints_[static_cast<std::size_t>(def.first)];
      ends.second = joints_[static_cast<std::size_t>(def.second)];
    }
    joints_.push_back(proofreel::add_joint(world_, def, ends));
  }

  void remove_joint(JointId id) override { world_.DestroyJoint(joints_[static_cast<std::size_t>(id)]); }

  void set_speed(JointId id, double speed) override { set_motor_speed(*joints_[static_cast<std::size_t>(id)], speed); }

  PeerReaction reaction(JointId id) const override {
    const b2Joint& joint = *joints_[static_cast<std::size_t>(id)];
    return {from_b2(joint.GetReactionForce(steps_per_second_)),
            static_cast<double>(joint.GetReactionTorque(steps_per_second_))};
  }

  void step(double dt) override {
    events_.clear();
    late_impulses_.clear();
    steps_per_second_ = static_cast<float>(1 / dt);
    world_.Step(static_cast<float>(dt), iterations_.velocity, iterations_.position);
    for (const Begun& begun : begun_) tell(begun);
    begun_.clear();
    separation_events_ = std::exchange(ended_, {});
  }

  std::vector<ContactView> contacts() const override {
    std::vector<ContactView> views;
    for (b2Contact* contact = const_cast<b2World&>(world_).GetContactList(); contact; contact = contact->GetNext()) {
      if (contact->IsTouching()) views.push_back(view_of(*contact));
    }
    return views;
  }

  const std::vector<ContactEvent>& contact_events() const override { return events_; }
  const std::vector<SeparationEvent>& separation_events() const override { return separation_events_; }

 private:
  struct KeptBody {
    b2Body* body = nullptr;  // owned by the world
    FilterDef filter;
    std::vector<Box2dFixture> fixtures;
  };

  struct Begun {
    b2Contact* contact = nullptr;
    double speed = 0;  ///< m/s
  };

  struct LateImpulse {
    b2Contact* contact = nullptr;
    b2ContactImpulse impulse;
  };

  KeptBody& at(BodyId id) { return bodies_[static_cast<std::size_t>(id)]; }
  const KeptBody& at(BodyId id) const { return bodies_[static_cast<std::size_t>(id)]; }
  const Box2dFixture& kept(b2Fixture* fixture) const {
    return at(id_of(fixture)).fixtures[fixture->GetUserData().pointer];
  }

  /// Shapes, mass and the rest, but for its motion.
  void equip(BodyId id, const BodyDef& def, const MassProperties& mass) {
    KeptBody& kept_body = at(id);
    b2Body& body = *kept_body.body;
    kept_body.filter = def.filter;
    add_fixtures(body, def, kept_body.fixtures);
    for (const ShapeDef& shape : def.shapes) surfaces_move_ |= shape.surface_speed != 0;
    body.SetBullet(def.bullet);
    body.SetGravityScale(static_cast<float>(def.gravity_scale));
    body.SetFixedRotation(def.fixed_rotation);
    if (def.type != BodyType::dynamic) return;
    b2MassData data;
    data.mass = static_cast<float>(mass.mass);
    data.center = to_b2(mass.center);
    data.I = static_cast<float>(mass.inertia + mass.mass * length_squared(mass.center));  // about the origin
    body.SetMassData(&data);
  }

  bool ShouldCollide(b2Fixture* a, b2Fixture* b) override {
    return filters_agree(at(id_of(a)).filter, at(id_of(b)).filter);
  }

  /// Told after the step, when the impulse is known; the speed is that before it.
  void BeginContact(b2Contact* contact) override { begun_.push_back({contact, approach_speed(*contact)}); }

  double approach_speed(b2Contact& contact) const {
    const ContactView view = view_of(contact);
    if (view.point_count == 0) return 0;
    const b2Vec2 point = to_b2(view.points[0].point);
    const auto velocity = [&](BodyId id) { return from_b2(at(id).body->GetLinearVelocityFromWorldPoint(point)); };
    return std::max(dot(velocity(view.a) - velocity(view.b), view.normal), 0.0);
  }

  void tell(const Begun& begun) {
    ContactEvent& event = events_.emplace_back(event_of(view_of(*begun.contact)));
    event.speed = begun.speed;
  }

  void EndContact(b2Contact* contact) override {
    const BodyId one = id_of(contact->GetFixtureA());
    const BodyId other = id_of(contact->GetFixtureB());
    ended_.push_back({std::min(one, other), std::max(one, other)});
    const auto begun =
        std::find_if(begun_.begin(), begun_.end(), [&](const Begun& entry) { return entry.contact == contact; });
    if (begun != begun_.end()) {
      tell(*begun);
      begun_.erase(begun);
    }
    std::erase_if(late_impulses_, [contact](const LateImpulse& late) { return late.contact == contact; });
  }

  /// Box2D's tangent is the normal turned clockwise, ours counter-clockwise.
  void PreSolve(b2Contact* contact, const b2Manifold*) override {
    if (!surfaces_move_) return;
    const double sum = kept(contact->GetFixtureA()).surface_speed + kept(contact->GetFixtureB()).surface_speed;
    contact->SetTangentSpeed(static_cast<float>(-sum));
  }

  /// What stops a body in mid-step (continuous collision) is told only here, and in no manifold.
  void PostSolve(b2Contact* contact, const b2ContactImpulse* impulse) override {
    if (impulse->normalImpulses[0] == contact->GetManifold()->points[0].normalImpulse) return;
    late_impulses_.push_back({contact, *impulse});
  }

  void add_late_impulses(b2Contact& contact, ContactView& view) const {
    for (const LateImpulse& late : late_impulses_) {
      if (late.contact != &contact) continue;
      for (int i = 0; i < std::min(view.point_count, late.impulse.count); ++i) {
        view.points[i].normal_impulse += static_cast<double>(late.impulse.normalImpulses[i]);
        view.points[i].tangent_impulse -= static_cast<double>(late.impulse.tangentImpulses[i]);
      }
    }
  }

  ContactView view_of(b2Contact& contact) const {
    b2Fixture* a = contact.GetFixtureA();
    b2Fixture* b = contact.GetFixtureB();
    const b2Transform& pose_a = a->GetBody()->GetTransform();
    const b2Transform& pose_b = b->GetBody()->GetTransform();
    b2Manifold manifold = *contact.GetManifold();
    if (a->IsSensor() || b->IsSensor()) contact.Evaluate(&manifold, pose_a, pose_b);  // Box2D makes none by itself
    b2WorldManifold world;
    world.Initialize(&manifold, pose_a, a->GetShape()->m_radius, pose_b, b->GetShape()->m_radius);
    ContactView view;
    view.a = id_of(a);
    view.b = id_of(b);
    view.normal = from_b2(world.normal);
    view.point_count = manifold.pointCount;
    for (int i = 0; i < manifold.pointCount; ++i) {
      const b2ManifoldPoint& point = manifold.points[i];
      view.points[i] = {from_b2(world.points[i]),
                        static_cast<double>(world.separations[i]) + kept(a).skin + kept(b).skin,
                        static_cast<double>(point.normalImpulse), -static_cast<double>(point.tangentImpulse)};
    }
    add_late_impulses(contact, view);
    return in_order(view);
  }

  b2World world_;
  Iterations iterations_;
  b2BodyDef world_body_;
  std::vector<KeptBody> bodies_;
  std::vector<b2Joint*> joints_;  // owned by the world
  float steps_per_second_ = 0;
  bool surfaces_move_ = false;
  std::vector<Begun> begun_;                ///< in this step
  std::vector<LateImpulse> late_impulses_;  ///< in this step
  std::vector<ContactEvent> events_;
  std::vector<SeparationEvent> ended_;  ///< since the last step began, or by commands before it
  std::vector<SeparationEvent> separation_events_;
};

}  // namespace

std::unique_ptr<PeerWorld> make_box2d_world(Vec2d gravity, PeerPreset preset) {
  return std::make_unique<Box2dWorld>(gravity, iterations_of(preset));
}

PeerFacts box2d_facts(PeerPreset preset) {
  const Iterations iterations = iterations_of(preset);
  const auto number = [](int32 part) { return std::to_string(part); };
  return {number(b2_version.major) + "." + number(b2_version.minor) + "." + number(b2_version.revision),
          Precision::float32,
          {{"velocity_iterations", iterations.velocity}, {"position_iterations", iterations.position}}};
}

}  // namespace proofreel
