#pragma once

/// Scenes in which, together, everything is that lives from tick to tick: what is forgotten when a simulation is saved
/// shows in one of them sooner or later.

#include <functional>
#include <string>
#include <vector>

#include "tests/engine/scenes.h"

namespace proofreel::test {

struct SavedScene {
  std::string name;
  Scene scene;
  std::function<void(Simulation& simulation, std::int64_t tick)> act;  ///< what happens before the step of a tick
};

const std::vector<SavedScene>& saved_scenes();

inline Scene in_this_precision(Scene scene) {
  scene.method.precision = is_double ? Precision::float64 : Precision::float32;
  return scene;
}

Scene busy_scene();
void act_in_busy_scene(Simulation& simulation, std::int64_t tick);

}  // namespace proofreel::test
