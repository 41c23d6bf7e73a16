#include "engine/world.h"

#include <algorithm>
#include <cmath>

#include "engine/attraction.h"
#include "engine/scene_archive.h"

namespace proofreel {
inline namespace PROOFREEL_PRECISION {
namespace {

/// Contacts are heavily damped springs: they must drive overlap out, not store energy.
constexpr real contact_damping_ratio = 10;
/// As stiff as a substep can carry, in oscillations per substep. At 0.3 a pyramid of fifteen rows keeps rocking when
/// gravity comes in halves, and at 0.25, the usual limit, discs that are packed too tightly are thrown.
constexpr real contact_stiffness = real(0.2);

/// Each body moves by itself under these. Those that only change what contacts do are among them.
constexpr EffectSet effects_of_free_bodies{Effect::gravity,     Effect::drag, Effect::wind,    Effect::friction,
                                           Effect::restitution, Effect::ccd,  Effect::sensors, Effect::sleeping};

}  // namespace

World::World(const Scene& scene)
    : scene_hash_(hash_of(scene)),
      method_(scene.method),
      rate_(scene.rate),
      dt_(real(1) / static_cast<real>(scene.rate)),
      h_(dt_ / static_cast<real>(scene.method.substeps)),
      substeps_(scene.method.substeps),
      most_substeps_(scene.method.substeps),
      gravity_(scene.gravity),
      drag_(scene.drag),
      wind_(scene.wind),
      attractors_(scene.attractors),
      gravitational_constant_(scene.gravitational_constant.value_or(0)),
      listed_effects_(scene.effects),
      census_(scene),
      contact_solver_(scene.method.contact_solver),
      joint_solver_(scene.method.joint_solver),
      water_(scene.water),
      fields_(scene.fields) {
  bodies_.emplace_back().name = "world";
  motions_.emplace_back();
  for (const BodyDef& def : scene.bodies) add_body(def);
  for (const JointDef& def : scene.joints) add_joint(def);
  for (const RocketDef& def : scene.rockets) add_rocket(def);
  rebuild_if_changed();
}

void World::step() {
  if (failure_) return;
  const CountingWork counting(work_ ? &*work_ : nullptr);
  rebuild_if_changed();
  choose_substeps();
  begin_tick();
  if (bodies_are_free_ && pushed_.empty()) {
    timed(StepStage::motion, [this] { fly_all(); });
    for (int i = 0; i < substeps_; ++i) count_evaluations();
    if (commanded_) detect_failure();  // nothing else can make a number infinite here
  } else {
    step_in_stages();
  }
  commanded_ = false;
}

/// Of all bodies that forces move.
void World::count_evaluations() const {
  if (counted_work == nullptr) return;
  for (const Body& body : bodies_) counted_work->evaluations += body.alive && body.acts_as == BodyType::dynamic ? 1 : 0;
}

void World::step_in_stages() {
  if (on(Effect::contacts)) find_contacts();
  prepare_solvers();
  for (int i = 0; i < substeps_; ++i) locates_impacts() ? pass_impacts(h_) : advance(h_);
  if (!locates_impacts()) timed(StepStage::motion, [this] { book_work(); });
  timed(StepStage::motion, [this] { end_tick(); });
  break_joints();
  collect_events();
  if (on(Effect::sleeping)) timed(StepStage::sleeping, [this] { look_for_rest(); });
  detect_failure();
}

void World::rebuild_if_changed() {
  if (!structure_changed_) return;
  structure_changed_ = false;
  effects_ = listed_effects_ ? *listed_effects_ : census_.inferred();
  bodies_are_free_ = steps_everything(method_.integrator) && effects_.has_only(effects_of_free_bodies);
  gather_free_forces();
  rebuild_joints();
  if (on(Effect::sleeping)) prepare_sleep();
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

void World::rebuild_joints() {
  if (on(Effect::joints)) joint_solver_.rebuild(joints_, motions_, {on(Effect::limits), on(Effect::motors)});
  hinged_ = PairSet();
  for (const Joint& joint : joints_) {
    if (joint.alive && lets_overlap(joint.kind)) {
      hinged_.insert(std::min(joint.body_a, joint.body_b), std::max(joint.body_a, joint.body_b));
    }
  }
}

/// What acts on every body by itself, in arrays as the loops over all bodies want it.
void World::gather_free_forces() {
  accelerations_.assign(on(Effect::gravity) ? bodies_.size() : 0, Vec2{});
  for (BodyIndex i = 0; i < accelerations_.size(); ++i) accelerations_[i] = acceleration_of(i);
  drags_.assign(on(Effect::drag) ? bodies_.size() : 0, DragDef{});
  for (BodyIndex i = 0; i < drags_.size(); ++i) {
    drags_[i] = drag_of(i);
  }
}

Vec2 World::acceleration_of(BodyIndex i) const {
  return bodies_[i].acts_as == BodyType::dynamic ? bodies_[i].gravity_scale * effective_gravity() : Vec2{};
}

DragDef World::drag_of(BodyIndex i) const {
  return bodies_[i].acts_as == BodyType::dynamic ? bodies_[i].drag.value_or(drag_) : DragDef{};
}

void World::begin_tick() {
  ++tick_;
  drifts_ = 0;
  events_.clear();
  separation_events_ = std::move(separated_by_commands_);
  separated_by_commands_.clear();
  if (forces_kept_) {
    velocities_before_.clear();
    for (const Motion& motion : motions_) velocities_before_.push_back(motion.velocity);
  }
  if (!pushed_.empty()) accelerations_.resize(bodies_.size());
  for (Push& push : pushed_) {
    push.angle_before = motions_[push.body].angle;
    accelerations_[push.body] = motions_[push.body].inv_mass * push.force + acceleration_of(push.body);
  }
  if (on(Effect::sleeping)) return begin_tick_of_sleepers();
  for (Joint& joint : joints_) forget_reaction(joint);
}

void World::find_contacts() {
  if (watches_runaways()) note_paces();
  timed(StepStage::broad_phase, [this] { find_pairs(); });
  timed(StepStage::narrow_phase, [this] { update_manifolds(contacts_); });
  if (on(Effect::sleeping)) timed(StepStage::sleeping, [this] { wake_what_is_touched(); });
}

void World::prepare_solvers() {
  if (on(Effect::contacts)) {
    timed(StepStage::contact_solver, [this] {
      const real hertz = method_.contact_hz ? static_cast<real>(*method_.contact_hz) : contact_stiffness / h_;
      contact_solver_.prepare(contacts_, shapes_, motions_, make_softness(hertz, contact_damping_ratio, h_),
                              {on(Effect::friction), on(Effect::rolling_resistance), on(Effect::surface_speed)});
      if (contact_solver_.parts_overlaps() && on(Effect::joints)) part_jointed_by_velocity();
      if (may_be_exact()) prepare_exact_contacts();
    });
  }
  if (on(Effect::joints)) {
    timed(StepStage::joint_solver, [this] {
      std::vector<std::uint8_t> overlapping;
      if (on(Effect::contacts)) overlapping = contact_solver_.overlapping_bodies(contacts_, bodies_.size());
      joint_solver_.begin_tick(jointed(), overlapping);
    });
  }
}

void World::prepare_exact_contacts() {
  for (ContactConstraint& c : contact_solver_.constraints()) c.closed = closed_gap(contacts_[c.contact]);
  const ExactContacts::Share share = is_exact() ? ExactContacts::Share::all : ExactContacts::Share::affordable;
  exact_contacts_.prepare(contact_solver_, has_rigid_joints() ? &joint_solver_ : nullptr, motions_, h_, share);
}

/// Verlet splits the forces in two halves, one before the drift and one after it; symplectic Euler gives them all
/// before. Drag, dampers, pulls and rockets change velocities by laws of their own and lie around the kicks, in the
/// same halves and in mirrored order: there positions and velocities belong to one time, so that the work done is
/// booked exactly.
void World::substep(real h) {
  count_evaluations();
  const bool verlet = is_verlet();
  const real share = verlet ? real(0.5) : real(1);
  if (on(Effect::restitution) && !locates_impacts()) timed(StepStage::restitution, [&] { bounce(h); });
  if (on(Effect::buoyancy)) timed(StepStage::buoyancy, [&] { look_at_water(); });
  if (verlet) pull_and_damp(share * h);
  if (verlet) slow_down(share * h);
  if (verlet) wade(share * h);
  if (verlet) thrust(share * h);
  if (on(Effect::field))
    timed(StepStage::field, [&] { fields_.kick_at_begin(bodies_, motions_, field_time(), share * h); });
  kick(share * h);
  solve(h, share);
  timed(StepStage::motion, [&] { drift_all(h); });
  push_out();
  if (watches_runaways()) timed(StepStage::narrow_phase, [&] { catch_runaways(h); });
  if (on(Effect::buoyancy)) timed(StepStage::buoyancy, [&] { look_at_water(); });
  if (on(Effect::field)) timed(StepStage::field, [&] { book_fields(h, share); });
  if (on(Effect::joints)) timed(StepStage::joint_solver, [&] { joint_solver_.linearize(jointed()); });
  if (verlet) kick(share * h);
  if (on(Effect::field) && verlet) timed(StepStage::field, [&] { finish_fields(h); });
  if (verlet) add_shares(share);
  thrust(share * h);
  wade(share * h);
  slow_down(share * h);
  pull_and_damp(share * h);
  relax(h);
}

void World::pull_and_damp(real h) {
  if (on(Effect::springs)) timed(StepStage::springs, [&] { damp_springs(h); });
  if (on(Effect::motors)) timed(StepStage::joint_solver, [&] { pull_all(h); });
}

/// Under verlet loads come in two halves: before they are relaxed contacts and motors get the second half of what held
/// them in the substep before, all at once, since neither could hold its load while the other has not begun to.
void World::add_shares(real share) {
  const bool in_turns = on(Effect::contacts) || joint_solver_.sweeps();
  if (on(Effect::contacts)) contact_solver_.add_share(motions_, share);
  if (on(Effect::joints) && in_turns) joint_solver_.add_share(jointed(), share);
}

void World::slow_down(real h) {
  if (on(Effect::drag)) timed(StepStage::drag, [&] { drag_all(h); });
}

void World::wade(real h) {
  if (on(Effect::buoyancy)) timed(StepStage::buoyancy, [&] { wade_all(h); });
}

void World::thrust(real h) {
  if (on(Effect::rocket)) timed(StepStage::rocket, [&] { burn_rockets(h); });
}

void World::kick(real h) {
  timed(on(Effect::gravity) ? StepStage::gravity : StepStage::motion, [&] { accelerate(h); });
  if (on(Effect::attractor)) {
    timed(StepStage::attractor, [&] {
      for (const AttractorDef& attractor : attractors_) {
        booked_work_ += work_of_center(attractor, kick_towards(attractor, bodies_, motions_, h));
      }
    });
  }
  if (on(Effect::nbody)) {
    timed(StepStage::nbody, [&] { kick_towards_each_other(gravitational_constant_, bodies_, motions_, h); });
  }
  if (on(Effect::buoyancy)) timed(StepStage::buoyancy, [&] { float_all(motions_, h); });
  if (on(Effect::springs)) timed(StepStage::springs, [&] { kick_springs(h); });
}

/// Velocities that lead to where contacts and joints want the bodies after the drift.
void World::solve(real h, real share) {
  contact_solver_.begin_substep(motions_, share);
  if (has_rigid_joints()) joint_solver_.begin_substep(jointed(), h, share);
  for (int i = 0; i < sweeps_per_substep(method_); ++i) {
    if (on(Effect::contacts) && !is_exact()) {
      timed(StepStage::contact_solver, [&] { contact_solver_.solve(motions_, h); });
    }
    if (has_rigid_joints()) timed(StepStage::joint_solver, [&] { place_on_joints(h); });
  }
  if (on(Effect::contacts) && !exact_contacts_.empty()) solve_exactly(h);
}

/// Joints that were torn apart are closed by moving bodies: what that lifts them by is work from outside.
void World::place_on_joints(real h) {
  if (!joint_solver_.solve_positions(jointed(), h)) return;
  const std::vector<Motion> moved = motions_;
  booked_work_ += potential_energy();
  joint_solver_.take_back_moves(motions_);
  booked_work_ -= potential_energy();
  motions_ = moved;
}

/// Joints answer to the contacts within the solution; what turning leaves open of both is closed by going round again.
void World::solve_exactly(real h) {
  JointSolver* joints = has_rigid_joints() ? &joint_solver_ : nullptr;
  for (int round = 0; round < 2; ++round) {
    timed(StepStage::contact_solver,
          [&] { exact_contacts_.solve_positions(contact_solver_, joints, jointed(), h, reach_of_contacts()); });
    if (!exact_contacts_.moves_joints()) return;
    timed(StepStage::joint_solver, [&] { place_on_joints(h); });
  }
}

void World::push_out() {
  if (!on(Effect::contacts)) return;
  if (contact_solver_.parts_overlaps()) timed(StepStage::contact_solver, [&] { part_overlaps(h_); });
  if (method_.contact_solver != ContactMethod::ngs) return;
  timed(StepStage::contact_solver, [&] {
    for (int i = 0; i < sweeps_per_substep(method_); ++i) contact_solver_.push_out(motions_);
  });
}

/// Takes out of the velocities what was only there to correct positions, and under verlet what the second half of the
/// forces has put in.
void World::relax(real h) {
  const bool soft = is_soft(method_.contact_solver);
  for (int i = 0; i < sweeps_per_substep(method_); ++i) {
    if (on(Effect::contacts) && (soft || (is_verlet() && !is_exact()))) {
      timed(StepStage::contact_solver, [&] { contact_solver_.relax(motions_, h); });
    }
    if (has_rigid_joints()) timed(StepStage::joint_solver, [&] { joint_solver_.solve_velocities(jointed(), h); });
  }
  if (on(Effect::contacts) && !exact_contacts_.empty()) relax_exactly(h);
  contact_solver_.end_substep();
  if (on(Effect::contacts) && has_rigid_joints()) joint_solver_.end_substep(jointed());
}

void World::relax_exactly(real h) {
  JointSolver* joints = has_rigid_joints() ? &joint_solver_ : nullptr;
  for (int round = 0; round < 2; ++round) {
    timed(StepStage::contact_solver,
          [&] { exact_contacts_.solve_velocities(contact_solver_, joints, jointed(), reach_of_contacts()); });
    if (!exact_contacts_.moves_joints()) return;
    timed(StepStage::joint_solver, [&] { joint_solver_.solve_velocities(jointed(), h); });
  }
}

void World::end_tick() {
  if (on(Effect::contacts) && !is_exact() && may_be_exact()) exact_contacts_.end_tick(contact_solver_, motions_);
  if (on(Effect::contacts)) contact_solver_.store(contacts_);
  if (locates_impacts()) show_touches();
  take_positions();
  for (const Push& push : pushed_) accelerations_[push.body] = acceleration_of(push.body);
  if (!on(Effect::gravity)) accelerations_.clear();
  pushed_.clear();
}

void World::take_positions() {
  for (BodyIndex i = 0; i < bodies_.size(); ++i) {
    bodies_[i].center += motions_[i].delta;
    motions_[i].delta = {};
  }
}

bool World::hinged_together(BodyIndex a, BodyIndex b) const {
  return on(Effect::joints) && hinged_.contains(std::min(a, b), std::max(a, b));
}

std::unique_ptr<Simulation> make_world(const Scene& scene) { return std::make_unique<World>(scene); }

}  // namespace PROOFREEL_PRECISION
}  // namespace proofreel
