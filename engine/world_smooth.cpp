// Smooth scenes: what all forces together accelerate the bodies by, for the integrators that ask at several places
// within a step (smooth_motion.h).

#include <array>

#include "engine/attraction.h"
#include "engine/drag.h"
#include "engine/world.h"

namespace proofreel {
inline namespace PROOFREEL_PRECISION {
namespace {

/// Five steps of verlet, the middle one backwards, cancel the errors of third order: p = 1 / (4 - 4^(1/3)) (Suzuki
/// 1990).
constexpr double p = 0.41449077179437573714;
constexpr std::array<double, 5> suzuki_steps{p, p, 1 - 4 * p, p, p};

bool is_spring(const Joint& joint) { return joint.alive && joint.kind == JointKind::spring; }

}  // namespace

void World::advance(real h) {
  switch (method_.integrator) {
    case Integrator::symplectic_euler:
    case Integrator::verlet:
      return substep(h);
    case Integrator::suzuki4:
      for (const double part : suzuki_steps) substep(static_cast<real>(part) * h);
      return;
    case Integrator::rk4:
    case Integrator::implicit_midpoint:
    case Integrator::gauss_legendre6:
      return advance_smoothly(h);
  }
}

void World::advance_smoothly(real h) {
  timed(StepStage::motion, [&] {
    const auto accelerate = [this](real after, Slopes& slopes) { add_accelerations(after, slopes); };
    if (!smooth_integrator_.step(method_.integrator, h, motions_, accelerate)) diverged_ = true;
    booked_work_ += smooth_integrator_.work();
    ++drifts_;
  });
  if (!on(Effect::springs)) return;
  for (Joint& joint : joints_) {
    if (!is_spring(joint)) continue;
    const Vec2 impulse = push_by_spring(joint, bodies_, motions_, pulled_, h);
    joint.impulse += impulse;
    joint.soft_impulse += impulse;
  }
}

/// Forces are written as what they do to velocities in some time: in one second, from rest, that is the acceleration.
void World::add_accelerations(real after, Slopes& slopes) {
  count_evaluations();
  pulled_ = motions_;
  for (Motion& m : pulled_) {
    m.velocity = {};
    m.spin = 0;
  }
  for (BodyIndex i = 0; i < accelerations_.size(); ++i) pulled_[i].velocity = accelerations_[i];
  for (const Push& push : pushed_) pulled_[push.body].spin = motions_[push.body].inv_inertia * push.torque;
  if (on(Effect::attractor)) {
    for (const AttractorDef& attractor : attractors_) {
      const Vec2 force = kick_towards(attractor, bodies_, pulled_, 1);
      slopes[0].power += static_cast<real>(work_of_center(attractor, force));
    }
  }
  if (on(Effect::nbody)) kick_towards_each_other(gravitational_constant_, bodies_, pulled_, 1);
  if (on(Effect::springs)) pull_springs();
  if (on(Effect::buoyancy)) {
    look_at_water();
    float_all(pulled_, 1);
  }
  for (BodyIndex i = 0; i < slopes.size(); ++i) {
    slopes[i].acceleration = pulled_[i].velocity;
    slopes[i].angular_acceleration = pulled_[i].spin;
  }
  for (BodyIndex i = 0; i < drags_.size(); ++i) add_drag(motions_[i], drags_[i], wind_in_force(), slopes[i]);
  if (on(Effect::buoyancy)) add_water(slopes);
  if (on(Effect::field)) add_fields(field_time() + static_cast<double>(after), slopes);
}

void World::add_water(Slopes& slopes) const {
  if (!water_) return;
  for (BodyIndex i = 1; i < slopes.size(); ++i) add_resistance(motions_[i], *water_, wetted_[i], slopes[i]);
}

void World::add_fields(double time, Slopes& slopes) const {
  for (BodyIndex i = 1; i < slopes.size(); ++i) {
    if (bodies_[i].type != BodyType::dynamic) continue;
    const Vec2d velocity(motions_[i].velocity);
    const Vec2d force = fields_.force_on(bodies_[i], motions_[i], velocity, time);
    slopes[i].acceleration += motions_[i].inv_mass * Vec2(force);
    slopes[i].power = static_cast<real>(dot(force, velocity));
  }
}

void World::pull_springs() {
  for (const Joint& joint : joints_) {
    if (is_spring(joint)) push_by_spring(joint, bodies_, motions_, pulled_, 1);
  }
}

}  // namespace PROOFREEL_PRECISION
}  // namespace proofreel
