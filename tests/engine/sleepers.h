#pragma once

/// Scenes whose bodies may sleep, and what to ask of them.

#include <optional>

#include "tests/engine/scenes.h"

namespace proofreel::test {

constexpr double g = 9.81;

inline Scene allowing_sleep(Scene scene) {
  scene.sleeping = true;
  return scene;
}

/// A square of 1 m at rest on the floor: body 2. It may sleep.
inline Scene resting_box() { return allowing_sleep(with_floor(body_with(box_shape(1, 1), {0, 0.5}))); }

/// Squares of 1 m on top of each other: bodies 2, 3, ...
inline Scene stack(int boxes) {
  Scene scene = resting_box();
  for (int i = 1; i < boxes; ++i) scene.bodies.push_back(body_with(box_shape(1, 1), {0, 0.5 + i}));
  return scene;
}

/// The first tick at whose end the body sleeps, or nothing within so many seconds.
inline std::optional<std::int64_t> tick_of_sleep(Simulation& simulation, BodyId body, double seconds, int rate = 240) {
  for (int i = 0; i < static_cast<int>(seconds * rate); ++i) {
    if (simulation.asleep(body)) return simulation.tick();
    simulation.step();
  }
  return std::nullopt;
}

inline bool falls_asleep(const Scene& scene, BodyId body, double seconds) {
  return tick_of_sleep(*simulate(scene), body, seconds, scene.rate).has_value();
}

/// Steps until nothing moves any more.
inline std::unique_ptr<Simulation> asleep(const Scene& scene, BodyId body = BodyId{2}, double seconds = 5) {
  auto simulation = simulate(scene);
  tick_of_sleep(*simulation, body, seconds, scene.rate);
  return simulation;
}

inline double distance_to(const Simulation& simulation, const Simulation& other, BodyId body) {
  return length(simulation.body(body).center - other.body(body).center);
}

}  // namespace proofreel::test
