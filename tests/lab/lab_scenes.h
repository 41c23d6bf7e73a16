#pragma once

/// Small scenes for what is asked of any engine.

#include <cmath>

#include "engine/simulation.h"
#include "tests/engine/bodies.h"

namespace proofreel::test {

/// 60 ticks per second.
inline Scene scene_of(std::vector<BodyDef> bodies) {
  Scene scene;
  scene.rate = 60;
  scene.bodies = std::move(bodies);
  return scene;
}

/// Between the world and body 1, where the world's anchor is.
inline JointDef joint_of(JointKind kind, Vec2d anchor_a, Vec2d anchor_b) {
  JointDef joint;
  joint.kind = kind;
  joint.b = static_cast<BodyId>(1);
  joint.anchor_a = anchor_a;
  joint.anchor_b = anchor_b;
  return joint;
}

inline void run(Simulation& simulation, double seconds) {
  for (int i = 0; i < static_cast<int>(std::lround(60 * seconds)); ++i) simulation.step();
}

}  // namespace proofreel::test
