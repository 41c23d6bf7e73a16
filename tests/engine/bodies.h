#pragma once

/// What scenes are made of in the tests of any engine.

#include "engine/scene.h"

namespace proofreel::test {

inline ShapeDef box_shape(double width, double height) {
  ShapeDef shape;
  shape.points = {
      {-width / 2, -height / 2}, {width / 2, -height / 2}, {width / 2, height / 2}, {-width / 2, height / 2}};
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

}  // namespace proofreel::test
