#pragma once

/// What scenes, commands and events are made of, for archives (archive.h).

#include "engine/archive.h"
#include "engine/effects.h"
#include "engine/simulation.h"

namespace proofreel {

template <>
struct LastOf<BodyId> {
  static constexpr std::uint32_t value = std::numeric_limits<std::uint32_t>::max();
};
template <>
struct LastOf<JointId> {
  static constexpr std::uint32_t value = std::numeric_limits<std::uint32_t>::max();
};
template <>
struct LastOf<BodyType> {
  static constexpr BodyType value = BodyType::dynamic;
};
template <>
struct LastOf<JointKind> {
  static constexpr JointKind value = JointKind::motor;
};
template <>
struct LastOf<AttractionLaw> {
  static constexpr AttractionLaw value = AttractionLaw::linear;
};
template <>
struct LastOf<Integrator> {
  static constexpr Integrator value = Integrator::gauss_legendre6;
};
template <>
struct LastOf<Precision> {
  static constexpr Precision value = Precision::float64;
};

template <typename Archive, Exchanged<FrictionDef> T>
void exchange(Archive& archive, T& friction) {
  auto& [at_rest, sliding] = friction;
  archive(at_rest, sliding);
}

template <typename Archive, Exchanged<ShapeDef> T>
void exchange(Archive& archive, T& shape) {
  auto& [points, radius, density, friction, restitution, rolling_resistance, surface_speed] = shape;
  archive(points, radius, density, friction, restitution, rolling_resistance, surface_speed);
}

template <typename Archive, Exchanged<FilterDef> T>
void exchange(Archive& archive, T& filter) {
  auto& [group, category, mask] = filter;
  archive(group, category, mask);
}

template <typename Archive, Exchanged<DragDef> T>
void exchange(Archive& archive, T& drag) {
  auto& [linear, quadratic, angular] = drag;
  archive(linear, quadratic, angular);
}

template <typename Archive, Exchanged<BodyDef> T>
void exchange(Archive& archive, T& body) {
  auto& [name, type, position, angle, velocity, spin, shapes, mass, inertia, gravity_scale, fixed_rotation, bullet,
         sensor, filter, drag, color] = body;
  archive(name, type, position, angle, velocity, spin, shapes, mass, inertia, gravity_scale, fixed_rotation, bullet,
          sensor, filter, drag, color);
}

template <typename Archive, Exchanged<LimitsDef> T>
void exchange(Archive& archive, T& limits) {
  auto& [lower, upper] = limits;
  archive(lower, upper);
}

template <typename Archive, Exchanged<MotorDef> T>
void exchange(Archive& archive, T& motor) {
  auto& [speed, strongest] = motor;
  archive(speed, strongest);
}

template <typename Archive, Exchanged<JointDef> T>
void exchange(Archive& archive, T& joint) {
  auto& [kind, a, b, anchor_a, anchor_b, length, stiffness, damping, axis, limits, motor, break_force, ratio, first,
         second, pin_a, pin_b, target, velocity, max_force] = joint;
  archive(kind, a, b, anchor_a, anchor_b, length, stiffness, damping, axis, limits, motor, break_force, ratio, first,
          second, pin_a, pin_b, target, velocity, max_force);
}

template <typename Archive, Exchanged<AttractorDef> T>
void exchange(Archive& archive, T& attractor) {
  auto& [body, at, strength, law] = attractor;
  archive(body, at, strength, law);
}

template <typename Archive, Exchanged<RocketDef> T>
void exchange(Archive& archive, T& rocket) {
  auto& [body, thrust, burn_rate, fuel, at] = rocket;
  archive(body, thrust, burn_rate, fuel, at);
}

template <typename Archive, Exchanged<WaterDef> T>
void exchange(Archive& archive, T& water) {
  auto& [level, density, drag] = water;
  archive(level, density, drag);
}

template <typename Archive, Exchanged<Method> T>
void exchange(Archive& archive, T& method) {
  auto& [integrator, contact_solver, joint_solver, substeps, iterations, contact_hz, precision] = method;
  archive(integrator, contact_solver, joint_solver, substeps, iterations, contact_hz, precision);
}

/// Force fields are functions and only counted.
template <typename Archive>
void exchange(Archive& archive, const Scene& scene) {
  const auto& [rate, gravity, method, effects, sleeping, bodies, joints, drag, wind, attractors, constant, rockets,
               water, fields] = scene;
  archive(rate, gravity, method, effects, sleeping, bodies, joints, drag, wind, attractors, constant, rockets, water,
          fields.size());
}

template <typename Archive, Exchanged<CreateBody> T>
void exchange(Archive& archive, T& command) {
  auto& [def] = command;
  archive(def);
}

template <typename Archive, Exchanged<ChangeBody> T>
void exchange(Archive& archive, T& command) {
  auto& [body, type, position, angle, velocity, spin, shapes, mass, inertia, friction, restitution, rolling_resistance,
         surface_speed, density, gravity_scale, fixed_rotation, bullet, sensor, filter, drag, color] = command;
  archive(body, type, position, angle, velocity, spin, shapes, mass, inertia, friction, restitution, rolling_resistance,
          surface_speed, density, gravity_scale, fixed_rotation, bullet, sensor, filter, drag, color);
}

template <typename Archive, Exchanged<RemoveBody> T>
void exchange(Archive& archive, T& command) {
  auto& [body] = command;
  archive(body);
}

template <typename Archive, Exchanged<ApplyImpulse> T>
void exchange(Archive& archive, T& command) {
  auto& [body, impulse, at] = command;
  archive(body, impulse, at);
}

template <typename Archive, Exchanged<ApplyForce> T>
void exchange(Archive& archive, T& command) {
  auto& [body, force, at] = command;
  archive(body, force, at);
}

template <typename Archive, Exchanged<ApplyTorque> T>
void exchange(Archive& archive, T& command) {
  auto& [body, torque] = command;
  archive(body, torque);
}

template <typename Archive, Exchanged<CreateJoint> T>
void exchange(Archive& archive, T& command) {
  auto& [def] = command;
  archive(def);
}

template <typename Archive, Exchanged<RemoveJoint> T>
void exchange(Archive& archive, T& command) {
  auto& [joint] = command;
  archive(joint);
}

template <typename Archive, Exchanged<ChangeJoint> T>
void exchange(Archive& archive, T& command) {
  auto& [joint, target, speed, velocity] = command;
  archive(joint, target, speed, velocity);
}

template <typename Archive, Exchanged<WakeBody> T>
void exchange(Archive& archive, T& command) {
  auto& [body] = command;
  archive(body);
}

template <typename Archive, Exchanged<AllowSleep> T>
void exchange(Archive&, T&) {}

template <typename Archive, Exchanged<SleepEvent> T>
void exchange(Archive& archive, T& event) {
  auto& [body, asleep] = event;
  archive(body, asleep);
}

template <typename Archive, Exchanged<ContactEvent> T>
void exchange(Archive& archive, T& event) {
  auto& [a, b, point, normal, impulse, speed] = event;
  archive(a, b, point, normal, impulse, speed);
}

template <typename Archive, Exchanged<SeparationEvent> T>
void exchange(Archive& archive, T& event) {
  auto& [a, b] = event;
  archive(a, b);
}

template <typename Archive, Exchanged<BreakEvent> T>
void exchange(Archive& archive, T& event) {
  auto& [joint, point, reaction] = event;
  archive(joint, point, reaction);
}

template <typename Archive, Exchanged<Failure> T>
void exchange(Archive& archive, T& failure) {
  auto& [tick, body, stage, what] = failure;
  archive(tick, body, stage, what);
}

template <typename Archive, Exchanged<Energy> T>
void exchange(Archive& archive, T& energy) {
  auto& [kinetic, potential, booked_work] = energy;
  archive(kinetic, potential, booked_work);
}

template <typename Archive, typename Self>
void EffectCensus::exchange(Archive& archive, Self& census) {
  auto& [gravity, drag, wind, attractor, nbody, rocket, buoyancy, field, classes, friction, rolling_resistance,
         restitution, surface_speed, sensor, spring, rigid_joint, limit, motor, breakable, sleeping] = census;
  archive(gravity, drag, wind, attractor, nbody, rocket, buoyancy, field, classes, friction, rolling_resistance,
          restitution, surface_speed, sensor, spring, rigid_joint, limit, motor, breakable, sleeping);
}

/// Equal for two scenes only when they are alike in everything but what their force fields do.
std::uint64_t hash_of(const Scene& scene);

}  // namespace proofreel
