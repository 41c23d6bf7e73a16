#pragma once

/// Two convex shapes A and B as the engine takes them, and as films show them.

#include "engine/polygon.h"
#include "engine/shape.h"
#include "scenarios/demonstrations/storyboard.h"

namespace proofreel {

/// As the engine takes it. Its frame is the world's: what an algorithm tells in A's frame needs no conversion.
inline Hull hull_of(const DemonstrationShape& shape) {
  ShapeDef def;
  def.points = shape.parts.front();
  def.radius = shape.radius;
  return make_hull(def, {0, 0});
}

/// A polygon about its centre of mass, as the shapes of bodies are, and where that is.
struct PlacedHull {
  Hull hull;
  Pose pose;
};
inline PlacedHull placed_hull_of(const DemonstrationShape& shape) {
  const Vec2d middle = centroid_of(shape.parts.front());
  ShapeDef def;
  def.points = shape.parts.front();
  return {make_hull(def, middle), {Vec2(middle), Rot{}}};
}

/// Keeps both shapes in the picture, with their letters.
inline void keep_pair(Storyboard& board, const Demonstration& demonstration, int pane = 0) {
  constexpr Role roles[] = {Role::first, Role::second};
  for (std::size_t i = 0; i < 2; ++i) board.keep(in_pane(shape_mark(roles[i], demonstration.shapes[i]), pane));
  for (std::size_t i = 0; i < 2; ++i) {
    const Vec2d own = middle_of(demonstration.shapes[i].parts.front());
    const Vec2d other = middle_of(demonstration.shapes[1 - i].parts.front());
    const double reach = 0.12 * extent_of(demonstration.shapes[i].parts.front());
    board.keep(in_pane(text_mark(roles[i], own - reach * towards(own, other), {}, letter(i)), pane));
  }
}

}  // namespace proofreel
