#pragma once

/// The narrow interface between a scene and whatever steps it. The script drives a simulation through commands, the
/// picture is made from snapshots; nobody outside sees bodies or solvers.

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <variant>
#include <vector>

#include "engine/effects.h"
#include "engine/scene.h"
#include "engine/snapshot.h"
#include "engine/stages.h"
#include "engine/state_hash.h"
#include "engine/work.h"

namespace proofreel {

/// The next free body id goes to `def`: ids count up in order of creation.
struct CreateBody {
  BodyDef def;
};
/// Changes what is given, leaves the rest.
struct ChangeBody {
  BodyId body{};
  std::optional<BodyType> type;
  std::optional<Vec2d> position;
  std::optional<double> angle;
  std::optional<Vec2d> velocity;
  std::optional<double> spin;
  std::optional<std::vector<ShapeDef>> shapes;
  std::optional<double> mass;
  std::optional<double> inertia;
  std::optional<FrictionDef> friction;       ///< of all shapes
  std::optional<double> restitution;         ///< of all shapes
  std::optional<double> rolling_resistance;  ///< of all shapes
  std::optional<double> surface_speed;       ///< of all shapes
  std::optional<double> density;             ///< of all shapes
  std::optional<double> gravity_scale;
  std::optional<bool> fixed_rotation;
  std::optional<bool> bullet;
  std::optional<bool> sensor;
  std::optional<FilterDef> filter;
  std::optional<DragDef> drag;
  std::optional<std::uint32_t> color;
};
/// The body's joints go with it.
struct RemoveBody {
  BodyId body{};
};
/// N s at a world point; without one, at the centre of mass.
struct ApplyImpulse {
  BodyId body{};
  Vec2d impulse;
  std::optional<Vec2d> at;
};
/// N during the next tick, at a world point; without one, at the centre of mass.
struct ApplyForce {
  BodyId body{};
  Vec2d force;
  std::optional<Vec2d> at;
};
/// N m during the next tick.
struct ApplyTorque {
  BodyId body{};
  double torque = 0;
};
/// The next free joint id goes to `def`.
struct CreateJoint {
  JointDef def;
};
/// Gears that couple the joint go with it.
struct RemoveJoint {
  JointId joint{};
};
/// Changes what is given, leaves the rest.
struct ChangeJoint {
  JointId joint{};
  std::optional<Vec2d> target;    ///< of a drag_to
  std::optional<double> speed;    ///< of the joint's motor
  std::optional<Vec2d> velocity;  ///< of a motor joint that has a max_force
};

/// Wakes the island the body sleeps in.
struct WakeBody {
  BodyId body{};
};
/// From now on bodies that rest may fall asleep, unless a list of effects has decided.
struct AllowSleep {};

using Command = std::variant<CreateBody, ChangeBody, RemoveBody, ApplyImpulse, ApplyForce, ApplyTorque, CreateJoint,
                             RemoveJoint, ChangeJoint, WakeBody, AllowSleep>;

/// Two shapes that did not touch before the last tick and do now (a sensor counts as touched on overlap).
struct ContactEvent {
  BodyId a = BodyId::world;
  BodyId b = BodyId::world;
  Vec2d point;
  Vec2d normal;        ///< unit, from a to b
  double impulse = 0;  ///< N s along the normal during the tick
  double speed = 0;    ///< m/s at which they met along the normal: at the impact, where that is located, else at the
                       ///< start of the tick
};

/// Two shapes that touched after the tick before and do not any more, or one of them is gone (with its body, perhaps).
/// To every ContactEvent that ends there is one; where impacts are located, one to all the impacts of a tick.
struct SeparationEvent {
  BodyId a = BodyId::world;
  BodyId b = BodyId::world;
  friend bool operator==(const SeparationEvent&, const SeparationEvent&) = default;
};

/// A joint that was loaded beyond its break_force during the last tick and is gone.
struct BreakEvent {
  JointId joint{};
  Vec2d point;     ///< where it held b, world
  Vec2d reaction;  ///< N on b, mean over the tick
};

/// A body that fell asleep or woke.
struct SleepEvent {
  BodyId body{};
  bool asleep = false;
  friend bool operator==(const SleepEvent&, const SleepEvent&) = default;
};

/// Why a simulation stopped: most often a number that is not finite.
struct Failure {
  std::int64_t tick = 0;
  BodyId body{};      ///< the world for all of them
  std::string stage;  ///< of the step, in words
  std::string what = "became infinite or not a number";
};

class Simulation {
 public:
  virtual ~Simulation() = default;
  /// Goes on by one tick (1 / rate seconds). After a failure it does nothing.
  virtual void step() = 0;
  /// Acts at once. The command must make sense: ids exist and are not removed, `problem_with` finds nothing in its
  /// data.
  virtual void apply(const Command& command) = 0;
  virtual std::int64_t tick() const = 0;
  /// Of the last tick, in a fixed order.
  virtual const std::vector<ContactEvent>& contact_events() const = 0;
  /// Of the last tick and the commands before it: first what commands took away, then those that left each other's
  /// surroundings, then the others, each in order of their first meeting. A
  /// simulation that does not tell has none.
  virtual const std::vector<SeparationEvent>& separation_events() const {
    static const std::vector<SeparationEvent> none;
    return none;
  }
  /// Of the last tick, in order of the joints' ids. A simulation whose joints never break has none.
  virtual const std::vector<BreakEvent>& break_events() const {
    static const std::vector<BreakEvent> none;
    return none;
  }
  /// Of the last tick and the commands before it, in the order in which they happened; those of one moment in order of
  /// the bodies' ids. A simulation whose bodies never sleep has none.
  virtual const std::vector<SleepEvent>& sleep_events() const {
    static const std::vector<SleepEvent> none;
    return none;
  }
  virtual bool exists(BodyId body) const = 0;
  virtual bool exists(JointId joint) const = 0;
  virtual BodyState body(BodyId body) const = 0;
  virtual bool asleep(BodyId body) const {
    static_cast<void>(body);
    return false;
  }
  virtual JointView joint(JointId joint) const = 0;
  /// All contacts, speculative ones (separation > 0, no impulse) too. The point impulses are those of the last tick.
  virtual std::vector<ContactView> contacts() const = 0;
  virtual void observe(Snapshot& snapshot) const = 0;
  virtual Energy energy() const = 0;
  /// Whether `Energy::booked_work` holds all that is done on the bodies from outside.
  virtual bool books_work() const { return true; }
  /// Whether bodies that were put inside each other have not come apart yet, or joints have not closed that were made
  /// open: what they release belongs to how the scene was set up.
  virtual bool is_settling() const { return false; }
  /// XXH3 of poses and velocities: equal exactly when all bits of the motion are.
  virtual std::uint64_t state_hash() const = 0;
  virtual const std::optional<Failure>& failure() const = 0;
  /// Which effects act at present, and why. Empty where nobody knows.
  virtual std::vector<EffectDecision> effects() const { return {}; }
  /// From now on `BodyView::force` is kept; until then it is 0, since it takes a look at every body at every tick.
  virtual void keep_forces() {}
  /// All that decides how it goes on and what of it is seen, as bytes that are the same on every machine. Empty where
  /// that is not offered.
  virtual std::vector<std::byte> save() const { return {}; }
  /// Becomes the simulation whose `save` gave these bytes, to the last bit; it must have been made from the same scene,
  /// whose force fields it asks from now on. Otherwise a sentence without a subject, "is damaged", why not, and nothing
  /// has changed.
  virtual std::optional<std::string> restore(std::span<const std::byte> /*bytes*/) {
    return "cannot be taken up by this kind of simulation";
  }
  /// From now on `BodyView::island` is found for every snapshot; until then it is 0.
  virtual void keep_islands() {}
  /// From now on adds to `times` what every stage takes; null ends it. Where nobody measures, all stay zero.
  virtual void time_stages(StageTimes* times) { static_cast<void>(times); }
  /// From now on the work of steps is counted.
  virtual void count_work() {}
  /// In all steps since then; nothing where nobody counts.
  virtual std::optional<WorkDone> work_done() const { return std::nullopt; }
};

/// The engine, in the precision the scene's method names. The scene must be sound: `problem_with` finds nothing in it.
std::unique_ptr<Simulation> make_simulation(const Scene& scene);

/// What is wrong with a body's numbers or geometry and what to change, as a sentence without the body's name;
/// nothing when it is sound.
std::optional<std::string> problem_with(const BodyDef& body);

/// The motion a body starts with.
BodyState initial_state(const BodyDef& body);

}  // namespace proofreel
