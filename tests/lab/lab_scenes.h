#pragma once

/// Small scenes for what is asked of any engine.

#include <cmath>

#include "engine/simulation.h"

namespace proofreel::test {

inline ShapeDef box_shape(double width, double height) {
  const double x = width / 2;
  const double y = height / 2;
  ShapeDef shape;
  shape.points = {{-x, -y}, {x, -y}, {x, y}, {-x, y}};
  return shape;
}

inline ShapeDef disc_shape(double radius) {
  ShapeDef shape;
  shape.points = {{0, 0}};
  shape.radius = radius;
  return shape;
}

inline BodyDef body_with(const ShapeDef& shape, Vec2d position, BodyType type = BodyType::dynamic) {
  BodyDef body;
  body.type = type;
  body.position = position;
  body.shapes = {shape};
  return body;
}

/// A floor whose top is y = 0.
inline BodyDef floor_body() { return body_with(box_shape(100, 1), {0, -0.5}, BodyType::fixed); }

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
