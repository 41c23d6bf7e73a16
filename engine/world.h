#pragma once

/// The engine behind the Simulation interface: owns all bodies, contacts and joints and steps them.

#include <chrono>
#include <memory>
#include <vector>

#include "engine/broad_phase.h"
#include "engine/buoyancy.h"
#include "engine/closing.h"
#include "engine/contact.h"
#include "engine/contact_solver.h"
#include "engine/effects.h"
#include "engine/exact_contacts.h"
#include "engine/field.h"
#include "engine/free_motion.h"
#include "engine/islands.h"
#include "engine/joint.h"
#include "engine/joint_solver.h"
#include "engine/pair_set.h"
#include "engine/rocket.h"
#include "engine/simulation.h"
#include "engine/sleep.h"
#include "engine/smooth_motion.h"

namespace proofreel {
inline namespace PROOFREEL_PRECISION {

class World final : public Simulation {
 public:
  explicit World(const Scene& scene);

  void step() override;
  void apply(const Command& command) override;
  std::int64_t tick() const override { return tick_; }
  const std::vector<ContactEvent>& contact_events() const override { return events_; }
  const std::vector<SeparationEvent>& separation_events() const override { return separation_events_; }
  const std::vector<BreakEvent>& break_events() const override { return break_events_; }
  const std::vector<SleepEvent>& sleep_events() const override { return sleep_.events; }
  bool exists(BodyId id) const override;
  bool exists(JointId id) const override;
  bool asleep(BodyId id) const override { return bodies_[static_cast<std::size_t>(id)].asleep(); }
  BodyState body(BodyId id) const override;
  JointView joint(JointId id) const override;
  std::vector<ContactView> contacts() const override;
  void observe(Snapshot& snapshot) const override;
  Energy energy() const override;
  bool is_settling() const override;
  std::uint64_t state_hash() const override;
  const std::optional<Failure>& failure() const override { return failure_; }
  std::vector<EffectDecision> effects() const override;
  void time_stages(StageTimes* times) override { times_ = times; }
  void count_work() override { work_.emplace(); }
  std::optional<WorkDone> work_done() const override { return work_; }
  void keep_forces() override { forces_kept_ = true; }
  std::vector<std::byte> save() const override;
  std::optional<std::string> restore(std::span<const std::byte> bytes) override;
  /// For archives (world_archive.cpp).
  template <typename Archive, typename Self>
  static void exchange(Archive& archive, Self& world);
  void keep_islands() override { islands_kept_ = true; }

 private:
  /// What commands push a body with during the next tick.
  struct Push {
    BodyIndex body = 0;
    Vec2 force;  ///< N
    real torque = 0;
    real angle_before = 0;  ///< at the start of that tick
    template <typename Archive, typename Self>
    static void exchange(Archive& archive, Self& push);
  };

  /// How a body moved when the tick's pairs were looked for.
  struct Pace {
    Vec2 velocity;
    real spin = 0;
    real reach = 0;     ///< from the centre of mass to the farthest point, m
    real harmless = 0;  ///< speed that takes it no deeper into anything within a tick than can be put right, m/s
  };

  /// Of a tick.
  enum class Moment : std::uint8_t { before, amid, after };

  // A tick (world.cpp), in order.
  void rebuild_if_changed();
  void choose_substeps();
  void gather_free_forces();
  Vec2 acceleration_of(BodyIndex index) const;
  DragDef drag_of(BodyIndex index) const;
  void begin_tick();
  void step_in_stages();
  void count_evaluations() const;
  void find_contacts();
  void prepare_solvers();
  void prepare_exact_contacts();
  void part_jointed_by_velocity();
  void advance(real h);
  void substep(real h);
  void pull_and_damp(real h);
  void slow_down(real h);
  void wade(real h);
  void thrust(real h);
  void kick(real h);
  void solve(real h, real share);
  void add_shares(real share);
  void place_on_joints(real h);
  void solve_exactly(real h);
  void push_out();
  void relax(real h);
  void relax_exactly(real h);
  void end_tick();
  void take_positions();
  void book_work();
  double work_of_center(const AttractorDef& attractor, Vec2 impulse) const;
  void break_joints();
  void collect_events();
  ContactEvent event_of(const Contact& contact, real impulse) const;
  void detect_failure();
  const char* stage_of_failure(BodyIndex body) const;

  // What the stages do (world_stages.cpp).
  void find_pairs();
  void update_boxes();
  real fall_of(BodyIndex index) const;
  void drop_parted_contacts();
  void add_new_pairs();
  void update_manifolds(std::vector<Contact>& contacts);
  void fly_all();
  void bounce(real h);
  void accelerate(real h);
  void kick_springs(real h);
  void damp_springs(real h);
  void pull_all(real h);
  void burn_rockets(real h);
  void drag_all(real h);
  void drift_all(real h);

  // Smooth scenes (world_smooth.cpp).
  void advance_smoothly(real h);
  void add_accelerations(real after, Slopes& slopes);
  void add_fields(double time, Slopes& slopes) const;
  void add_water(Slopes& slopes) const;
  void pull_springs();

  // Water, force fields, moving and resisting surfaces (world_effects.cpp).
  void look_at_water();
  void float_all(std::vector<Motion>& motions, real h) const;
  void wade_all(real h);
  void book_fields(real h, real share);
  void finish_fields(real h);
  /// The time the fields are asked about, s: that of the next or the last drift.
  double field_time() const;
  void book_surfaces();
  double potential_of_water() const;

  // Impacts at their own times (world_impacts.cpp).
  /// What a substep changes and nobody can compute back.
  struct Trial {
    std::vector<Motion> motions;
    std::vector<Joint> joints;
    JointSolver joint_solver;
    ContactSolver contact_solver;
    double booked_work = 0;
  };
  /// What a contact has pressed with during a tick, and where.
  struct Touch {
    Manifold manifold;
    PointImpulse impulses[2];
  };
  void pass_impacts(real h);
  void begin_portion();
  void look_ahead();
  real closed_gap(const Contact& contact) const;
  void end_portion();
  Trial keep_state() const;
  void go_back_to(const Trial& trial);
  void bounce_what_touches(real h);
  real first_impact(const std::vector<Motion>& before, real span) const;
  real time_of_contact(const Contact& contact, const ContactConstraint* constraint, const Flight& a, const Flight& b,
                       real span) const;
  static void add_touch(Touch& touch, const Contact& contact);
  void show_touches();

  // What nobody foresaw (world_runaways.cpp).
  void note_paces();
  bool is_fast(BodyIndex index) const;
  bool runs_away(BodyIndex index) const;
  void catch_runaways(real h);
  std::vector<std::uint8_t> jointed_bodies() const;
  void keep_out_of_walls(const std::vector<std::uint8_t>& jointed, real h);
  void look_again(const std::vector<BodyIndex>& runaways, const std::vector<std::uint8_t>& jointed, real h);
  std::vector<std::uint32_t> unforeseen_contacts(const std::vector<std::uint8_t>& runs) const;
  void hold_back(const std::vector<std::uint32_t>& unforeseen, const std::vector<std::uint8_t>& runs, real h);

  // Bodies that start inside each other (world_overlap.cpp).
  void part_overlaps(real h);
  real speed_limit_of_parting(const std::vector<Motion>& before, real h) const;

  // Islands (world_islands.cpp).
  std::vector<std::uint32_t> find_islands(bool sleepers_too) const;
  void add_links(const Joint& joint, std::vector<Link>& links) const;
  bool is_solved(const Joint& joint) const;
  bool is_driven(const Joint& joint) const;
  bool moves_unpushed(BodyIndex index) const;
  std::vector<IslandState> judge_islands(const std::vector<std::uint32_t>& islands, const Resting& rests) const;

  // Sleep (world_sleep.cpp).
  void prepare_sleep();
  void begin_tick_of_sleepers();
  void wake_what_is_touched();
  void look_for_rest();
  void put_to_sleep(const Resting& rests);
  void fall_asleep(BodyIndex index, BodyIndex island);
  void set_acting(BodyIndex index, BodyType acts_as);
  void lay_aside_sleepers();
  void sort_out_joints();
  void wake(const std::vector<BodyIndex>& bodies, Moment moment);
  void settle_met_sleepers();
  bool field_changes(BodyIndex index);
  void wake_in_changed_fields();
  bool will_press(const Contact& contact) const;
  bool anything_pulls_that_moves() const;

  // Whom a command wakes (world_wake.cpp).
  void wake_for(const CreateBody&) {}
  void wake_for(const ChangeBody& command);
  void wake_for(const RemoveBody& command);
  void wake_for(const ApplyImpulse& command);
  void wake_for(const ApplyForce& command);
  void wake_for(const ApplyTorque& command);
  void wake_for(const CreateJoint& command);
  void wake_for(const RemoveJoint& command);
  void wake_for(const ChangeJoint& command);
  void wake_for(const WakeBody& command);
  void wake_for(const AllowSleep&) {}
  void wake_at(BodyIndex index);
  void wake_at(const Joint& joint);

  // Commands (world_commands.cpp).
  void execute(const CreateBody& command);
  void execute(const ChangeBody& command);
  void execute(const RemoveBody& command);
  void execute(const ApplyImpulse& command);
  void execute(const ApplyForce& command);
  void execute(const ApplyTorque& command);
  void execute(const CreateJoint& command);
  void execute(const RemoveJoint& command);
  void execute(const ChangeJoint& command);
  void execute(const WakeBody& command);
  void execute(const AllowSleep& command);
  void add_body(const BodyDef& def);
  void add_joint(const JointDef& def);
  void remove_joint(std::size_t index);
  void add_rocket(const RocketDef& def);
  real size_of(const Joint& joint) const;
  void reshape(BodyIndex index, Vec2d origin);
  void move_center(BodyIndex index, Vec2 way);
  void make_room_for_shapes(BodyIndex index);
  ShapeIndex place_for_shape();
  Push& push_on(BodyIndex index);
  void remove_shapes(BodyIndex index);
  void drop_contacts_of(BodyIndex index);

  // Smooth ground (world_seams.cpp).
  void join_shapes_of(BodyIndex index);
  void join_fixed_shapes();
  bool is_ground(const Shape& shape) const;

  // Looking (world_observe.cpp).
  Pose center_pose(BodyIndex index) const;
  Vec2d origin_of(BodyIndex index) const;
  ContactView view_of(const Contact& contact) const;
  void observe_bodies(Snapshot& snapshot) const;
  double potential_energy() const;
  JointedBodies jointed() { return {joints_, bodies_, motions_}; }

  // Saving (world_archive.cpp, world_soundness.cpp).
  void rebuild_joints();
  bool is_sound(std::size_t least_bodies) const;
  bool bodies_are_sound() const;
  bool shapes_are_sound() const;
  bool joints_are_sound() const;
  bool contacts_are_sound() const;
  bool sleep_is_sound() const;

  bool hinged_together(BodyIndex a, BodyIndex b) const;
  std::string told_of_joints() const;
  Vec2 wind_in_force() const { return on(Effect::wind) ? wind_ : Vec2{}; }
  Vec2 effective_gravity() const { return on(Effect::gravity) ? gravity_ : Vec2{}; }
  bool is_verlet() const { return method_.integrator != Integrator::symplectic_euler; }
  bool locates_impacts() const { return method_.contact_solver == ContactMethod::event && on(Effect::contacts); }
  bool watches_runaways() const { return on(Effect::ccd) && on(Effect::contacts) && !locates_impacts(); }
  bool is_exact() const {
    return method_.contact_solver == ContactMethod::exact || method_.contact_solver == ContactMethod::event;
  }
  /// Some islands may be, others not.
  bool may_be_exact() const {
    return is_exact() || (method_.contact_solver == ContactMethod::automatic && !method_.contact_hz);
  }
  ExactContacts::Reach reach_of_contacts() const {
    return locating_ ? ExactContacts::Reach::closed : ExactContacts::Reach::all;
  }
  bool has_rigid_joints() const { return on(Effect::joints) && !joint_solver_.empty(); }
  bool on(Effect effect) const { return effects_.has(effect); }
  /// Runs a part of the step; somebody may want to know how long it takes.
  template <typename Part>
  void timed(StepStage stage, const Part& part);

  std::uint64_t scene_hash_;  ///< of what it was made from
  Method method_;
  int rate_;
  real dt_;            ///< a tick, s
  real h_;             ///< a substep of this tick, s
  int substeps_;       ///< of this tick: the method's, or more
  int most_substeps_;  ///< of any tick so far
  Vec2 gravity_;
  DragDef drag_;
  Vec2 wind_;
  std::vector<AttractorDef> attractors_;
  double gravitational_constant_;
  std::optional<EffectSet> listed_effects_;
  EffectCensus census_;
  EffectSet effects_;
  bool structure_changed_ = true;
  bool ground_changed_ = true;  ///< a shape of a fixed body has come, gone or changed
  bool has_broad_phase_ = false;
  bool bodies_are_free_ = false;  ///< nothing that is on lets one body act on another
  bool forces_kept_ = false;
  bool islands_kept_ = false;
  bool commanded_ = false;  ///< since the last tick

  std::vector<Body> bodies_;
  std::vector<Motion> motions_;      ///< parallel to bodies_
  std::vector<Vec2> accelerations_;  ///< from gravity and pushes, constant during a tick; empty where nothing does
  std::vector<DragDef> drags_;       ///< of each body, or empty
  std::vector<Push> pushed_;         ///< each body once, in order
  std::vector<Vec2> velocities_before_;
  std::vector<Pace> paces_;  ///< by body, of the present tick
  std::vector<Shape> shapes_;
  std::vector<ShapeIndex> free_shapes_;  ///< places in it whose shapes are gone
  std::vector<Joint> joints_;
  std::vector<Rocket> rockets_;
  BroadPhase broad_phase_;
  std::vector<Contact> contacts_;
  std::uint32_t contacts_made_ = 0;
  ContactSolver contact_solver_;
  ExactContacts exact_contacts_;
  JointSolver joint_solver_;
  SmoothIntegrator smooth_integrator_;
  std::vector<Motion> pulled_;  ///< scratch: places of now, velocities that forces would give in a second
  bool diverged_ = false;       ///< an implicit integrator found no solution
  PairSet hinged_;              ///< pairs of bodies whose joint lets them overlap
  std::vector<Touch> touches_;  ///< by contact, during a tick
  bool locating_ = false;       ///< impacts are located: nothing is held back before it touches
  std::vector<ContactEvent> events_;
  std::vector<SeparationEvent> separation_events_;
  std::vector<SeparationEvent> separated_by_commands_;  ///< told after the next tick
  std::vector<BreakEvent> break_events_;
  std::optional<WaterDef> water_;
  std::vector<Wetted> wetted_;  ///< by body, since the bodies were last moved
  FieldForces fields_;
  Sleep sleep_;
  std::int64_t drifts_ = 0;  ///< substeps of this tick so far, counted where their fields are asked
  double booked_work_ = 0;
  std::int64_t tick_ = 0;
  std::optional<Failure> failure_;
  StageTimes* times_ = nullptr;
  std::optional<WorkDone> work_;  ///< where it is counted
};

template <typename Part>
void World::timed(StepStage stage, const Part& part) {
  if (times_ == nullptr) return part();
  const auto start = std::chrono::steady_clock::now();
  part();
  times_->of(stage) += std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

/// The engine in this precision.
std::unique_ptr<Simulation> make_world(const Scene& scene);

}  // namespace PROOFREEL_PRECISION
}  // namespace proofreel
