#pragma once

/// Small scenes for the tests of the engine, built the way a scenario would build them.

#include <algorithm>
#include <cmath>
#include <memory>

#include "engine/simulation.h"
#include "engine/world.h"
#include "tests/engine/bodies.h"

namespace proofreel::test {

inline JointDef joint_between(JointKind kind, BodyId a, Vec2d anchor_a, BodyId b, Vec2d anchor_b, double length = 0) {
  JointDef joint;
  joint.kind = kind;
  joint.a = a;
  joint.b = b;
  joint.anchor_a = anchor_a;
  joint.anchor_b = anchor_b;
  joint.length = length;
  return joint;
}

/// The engine in the precision this test program is built in.
inline std::unique_ptr<Simulation> simulate(const Scene& scene) { return make_world(scene); }

/// A body above the floor: body 2.
inline Scene with_floor(const BodyDef& body) {
  Scene scene;
  scene.bodies = {floor_body(), body};
  return scene;
}

inline void run(Simulation& simulation, double seconds, int rate = 240) {
  for (int i = 0; i < static_cast<int>(seconds * rate + 0.5); ++i) simulation.step();
}

inline constexpr bool is_double = sizeof(real) == sizeof(double);
/// The tolerance to use: one for double, one for float.
inline constexpr double pick(double for_double, double for_float) { return is_double ? for_double : for_float; }

/// The largest change of the energy less booked work within so many seconds.
inline double energy_drift(const Scene& scene, double seconds) {
  const auto simulation = simulate(scene);
  const double before = simulation->energy().total();
  double drift = 0;
  for (int i = 0; i < static_cast<int>(seconds * scene.rate); ++i) {
    simulation->step();
    const Energy energy = simulation->energy();
    drift = std::max(drift, std::abs(energy.total() - energy.booked_work - before));
  }
  return drift;
}

}  // namespace proofreel::test
