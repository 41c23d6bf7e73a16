#include "lab/peers/chipmunk_world.h"

#include <chipmunk/chipmunk.h>
#include <chipmunk/chipmunk_structs.h>  // the list of all contacts, and each point's impulse
#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <limits>

#include "lab/peers/chipmunk_joints.h"
#include "lab/peers/chipmunk_shapes.h"
#include "lab/peers/peer_contacts.h"

namespace proofreel {
namespace {

int iterations_of(PeerPreset preset) { return preset == PeerPreset::accurate ? 100 : 10; }
constexpr double slop = 0.005;  ///< m: Chipmunk's 0.1 is meant for pixels

/// What Chipmunk's body points back to.
struct KeptBody {
  BodyId id{};
  double gravity_scale = 1;
  cpBody* body = nullptr;
  std::vector<cpShape*> shapes;
};

const KeptBody& kept_of(const cpBody* body) { return *static_cast<const KeptBody*>(cpBodyGetUserData(body)); }

void scaled_gravity(cpBody* body, cpVect gravity, cpFloat damping, cpFloat dt) {
  cpBodyUpdateVelocity(body, cpvmult(gravity, kept_of(body).gravity_scale), damping, dt);
}

cpBodyType type_of(BodyType type) {
  if (type == BodyType::dynamic) return CP_BODY_TYPE_DYNAMIC;
  return type == BodyType::kinematic ? CP_BODY_TYPE_KINEMATIC : CP_BODY_TYPE_STATIC;
}

/// `n` leads from a to b, `r1` and `r2` from their centres of mass to their surfaces.
ContactView view_of(const cpArbiter& arbiter) {
  ContactView view;
  view.a = kept_of(arbiter.body_a).id;
  view.b = kept_of(arbiter.body_b).id;
  view.normal = from_cp(arbiter.n);
  view.point_count = arbiter.count;
  for (int i = 0; i < arbiter.count; ++i) {
    const cpContact& contact = arbiter.contacts[i];
    const Vec2d on_a = from_cp(cpvadd(arbiter.body_a->p, contact.r1));
    const Vec2d on_b = from_cp(cpvadd(arbiter.body_b->p, contact.r2));
    view.points[i] = {0.5 * (on_a + on_b), dot(on_b - on_a, view.normal), contact.jnAcc, contact.jtAcc};
  }
  return in_order(view);
}

/// Debian's Chipmunk, which is built with its assertions, greets on standard output, where only data may go.
cpSpace* silently_made_space() {
  std::fflush(stdout);
  const int kept = dup(STDOUT_FILENO);
  const int nowhere = open("/dev/null", O_WRONLY | O_CLOEXEC);
  if (nowhere >= 0) dup2(nowhere, STDOUT_FILENO);
  cpSpace* space = cpSpaceNew();
  std::fflush(stdout);
  if (kept >= 0) dup2(kept, STDOUT_FILENO);
  for (const int file : {kept, nowhere}) {
    if (file >= 0) close(file);
  }
  return space;
}

class ChipmunkWorld final : public PeerWorld {
 public:
  ChipmunkWorld(Vec2d gravity, int iterations) : space_(silently_made_space()) {
    cpSpaceSetIterations(space_, iterations);
    cpSpaceSetCollisionSlop(space_, slop);
    cpSpaceSetGravity(space_, to_cp(gravity));
    cpCollisionHandler* handler = cpSpaceAddDefaultCollisionHandler(space_);
    handler->userData = this;
    handler->beginFunc = begin;
    handler->separateFunc = separate;
    handler->preSolveFunc = mix;
    keep(cpSpaceGetStaticBody(space_));
  }

  ~ChipmunkWorld() override {
    for (KeptJoint& joint : joints_) drop(joint);
    for (const auto& body : bodies_) {
      drop_shapes(*body);
      if (body->id != BodyId::world && body->body != nullptr) drop(body->body);
    }
    cpSpaceFree(space_);
  }
  ChipmunkWorld(const ChipmunkWorld&) = delete;
  ChipmunkWorld& operator=(const ChipmunkWorld&) = delete;

  void add_body(const BodyDef& def, const MassProperties& mass) override {
    cpBody* body = def.type == BodyType::dynamic     ? cpBodyNew(mass.mass, mass.inertia)
                   : def.type == BodyType::kinematic ? cpBodyNewKinematic()
                                                     : cpBodyNewStatic();
    KeptBody& added = keep(cpSpaceAddBody(space_, body));
    const bool moves = def.type != BodyType::fixed;
    equip(added, def, mass, {def.position, def.angle, moves ? def.velocity : Vec2d{}, moves ? def.spin : 0});
  }

  void change_body(BodyId id, const BodyDef& def, const MassProperties& mass) override {
    KeptBody& changed = *bodies_[static_cast<std::size_t>(id)];
    const PeerMotion now = motion(id);
    drop_shapes(changed);
    cpBodySetType(changed.body, type_of(def.type));
    equip(changed, def, mass, now);
    for (KeptJoint& joint : joints_) settle(joint);
  }

  void remove_body(BodyId id) override {
    KeptBody& removed = *bodies_[static_cast<std::size_t>(id)];
    drop_shapes(removed);
    drop(removed.body);
    removed.body = nullptr;
  }

  PeerMotion motion(BodyId id) const override {
    const cpBody* body = body_of(id);
    return {from_cp(cpBodyGetPosition(body)), cpBodyGetAngle(body), from_cp(cpBodyGetVelocity(body)),
            cpBodyGetAngularVelocity(body)};
  }

  void set_motion(BodyId id, const PeerMotion& motion) override {
    place(body_of(id), motion);
    cpSpaceReindexShapesForBody(space_, body_of(id));
  }

  void push(BodyId id, Vec2d impulse, Vec2d at) override {
    cpBodyApplyImpulseAtWorldPoint(body_of(id), to_cp(impulse), to_cp(at));
  }

  void pull(BodyId id, Vec2d force, double torque) override {
    cpBody* body = body_of(id);
    cpBodySetForce(body, cpvadd(cpBodyGetForce(body), to_cp(force)));
    cpBodySetTorque(body, cpBodyGetTorque(body) + torque);
  }

  void add_joint(const JointDef& def, double turn) override {
    joints_.push_back({make_joint(def, body_of(def.a), body_of(def.b), turn), false});
    settle(joints_.back());
  }

  void remove_joint(JointId id) override { drop(joints_[static_cast<std::size_t>(id)]); }

  void set_speed(JointId id, double speed) override {
    set_motor_speed(joints_[static_cast<std::size_t>(id)].parts, speed);
  }

  PeerReaction reaction(JointId id) const override {
    return reaction_of(joints_[static_cast<std::size_t>(id)].parts, last_dt_);
  }

  void step(double dt) override {
    last_dt_ = dt;
    begun_.clear();
    events_.clear();
    cpSpaceStep(space_, dt);
    for (const Begun& begun : begun_) {
      ContactEvent event = begun.event;
      if (begun.arbiter->count > 0) event.impulse = event_of(view_of(*begun.arbiter)).impulse;
      events_.push_back(event);
    }
    separation_events_ = std::exchange(ended_, {});
  }

  std::vector<ContactView> contacts() const override {
    std::vector<ContactView> views;
    for (int i = 0; i < space_->arbiters->num; ++i) {
      views.push_back(view_of(*static_cast<const cpArbiter*>(space_->arbiters->arr[i])));
    }
    return views;
  }

  const std::vector<ContactEvent>& contact_events() const override { return events_; }
  const std::vector<SeparationEvent>& separation_events() const override { return separation_events_; }

 private:
  struct KeptJoint {
    ChipmunkParts parts;
    bool acts = false;  ///< its parts are in the space
  };
  struct Begun {
    ContactEvent event;
    const cpArbiter* arbiter = nullptr;  // owned by the space
  };

  cpBody* body_of(BodyId id) const { return bodies_[static_cast<std::size_t>(id)]->body; }

  KeptBody& keep(cpBody* body) {
    bodies_.push_back(std::make_unique<KeptBody>());
    KeptBody& added = *bodies_.back();
    added.id = static_cast<BodyId>(bodies_.size() - 1);
    added.body = body;
    cpBodySetUserData(body, &added);
    return added;
  }

  /// Turning a body turns it about its centre of mass, so the angle comes first.
  static void place(cpBody* body, const PeerMotion& motion) {
    cpBodySetAngle(body, motion.angle);
    cpBodySetPosition(body, to_cp(motion.position));
    cpBodySetVelocity(body, to_cp(motion.velocity));
    cpBodySetAngularVelocity(body, motion.spin);
  }

  void equip(KeptBody& kept, const BodyDef& def, const MassProperties& mass, const PeerMotion& motion) {
    kept.gravity_scale = def.gravity_scale;
    if (def.type == BodyType::dynamic) {
      cpBodySetMass(kept.body, mass.mass);
      cpBodySetMoment(kept.body, def.fixed_rotation ? std::numeric_limits<double>::infinity() : mass.inertia);
      cpBodySetVelocityUpdateFunc(kept.body, def.gravity_scale == 1 ? cpBodyUpdateVelocity : scaled_gravity);
    }
    cpBodySetCenterOfGravity(kept.body, to_cp(mass.center));
    place(kept.body, motion);
    kept.shapes = make_shapes(kept.body, def);
    for (cpShape* shape : kept.shapes) cpSpaceAddShape(space_, shape);
    for (const ShapeDef& shape : def.shapes) mixes_ |= shape.restitution > 0 || shape.surface_speed != 0;
  }

  void drop_shapes(KeptBody& kept) {
    for (cpShape* shape : kept.shapes) {
      cpSpaceRemoveShape(space_, shape);
      cpShapeFree(shape);
    }
    kept.shapes.clear();
  }

  void drop(cpBody* body) {
    cpSpaceRemoveBody(space_, body);
    cpBodyFree(body);
  }

  void drop(KeptJoint& joint) {
    for (cpConstraint* part : joint.parts) {
      if (joint.acts) cpSpaceRemoveConstraint(space_, part);
      cpConstraintFree(part);
    }
    joint = {};
  }

  /// A joint between two bodies that nothing moves has no solution, and Chipmunk ends the program over it.
  void settle(KeptJoint& joint) {
    for (cpConstraint* part : joint.parts) {
      const bool acts = cpBodyGetType(cpConstraintGetBodyA(part)) == CP_BODY_TYPE_DYNAMIC ||
                        cpBodyGetType(cpConstraintGetBodyB(part)) == CP_BODY_TYPE_DYNAMIC;
      if (acts && !joint.acts) cpSpaceAddConstraint(space_, part);
      if (!acts && joint.acts) cpSpaceRemoveConstraint(space_, part);
      if (part == joint.parts.back()) joint.acts = acts;
    }
  }

  static cpBool begin(cpArbiter* arbiter, cpSpace*, cpDataPointer world) {
    ContactEvent event = event_of(view_of(*arbiter));
    cpBody* a = nullptr;
    cpBody* b = nullptr;
    cpArbiterGetBodies(arbiter, &a, &b);
    const cpVect point = to_cp(event.point);
    const cpVect meeting = cpvsub(cpBodyGetVelocityAtWorldPoint(a, point), cpBodyGetVelocityAtWorldPoint(b, point));
    event.speed = std::max(cpvdot(meeting, cpArbiterGetNormal(arbiter)), 0.0);
    static_cast<ChipmunkWorld*>(world)->begun_.push_back({event, arbiter});
    return cpTrue;
  }

  static void separate(cpArbiter* arbiter, cpSpace*, cpDataPointer world) {
    static_cast<ChipmunkWorld*>(world)->ended_.push_back(separation_of(view_of(*arbiter)));
  }

  /// Restitution max(a, b); surfaces move counter-clockwise round their bodies. Friction mixes by itself.
  static cpBool mix(cpArbiter* arbiter, cpSpace*, cpDataPointer world) {
    if (!static_cast<ChipmunkWorld*>(world)->mixes_) return cpTrue;
    cpShape* a = nullptr;
    cpShape* b = nullptr;
    cpArbiterGetShapes(arbiter, &a, &b);
    cpArbiterSetRestitution(arbiter, std::max(cpShapeGetElasticity(a), cpShapeGetElasticity(b)));
    const double speed = cpShapeGetSurfaceVelocity(a).x + cpShapeGetSurfaceVelocity(b).x;
    cpArbiterSetSurfaceVelocity(arbiter, cpvmult(cpvperp(cpArbiterGetNormal(arbiter)), -speed));
    return cpTrue;
  }

  cpSpace* space_;
  std::vector<std::unique_ptr<KeptBody>> bodies_;
  std::vector<KeptJoint> joints_;
  double last_dt_ = 0;
  bool mixes_ = false;  ///< some contact's coefficients are not those Chipmunk makes by itself
  std::vector<Begun> begun_;
  std::vector<ContactEvent> events_;
  std::vector<SeparationEvent> ended_;  ///< since the last step began, or by commands before it
  std::vector<SeparationEvent> separation_events_;
};

}  // namespace

std::unique_ptr<PeerWorld> make_chipmunk_world(Vec2d gravity, PeerPreset preset) {
  return std::make_unique<ChipmunkWorld>(gravity, iterations_of(preset));
}

PeerFacts chipmunk_facts(PeerPreset preset) {
  return {cpVersionString, Precision::float64, {{"iterations", iterations_of(preset)}, {"collision_slop", slop}}};
}

}  // namespace proofreel
