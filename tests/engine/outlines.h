#pragma once

/// Outlines that the tests of hulls and polygons are made of.

#include <numbers>
#include <vector>

#include "engine/elementary.h"
#include "engine/vec2.h"
#include "tests/engine/random.h"

namespace proofreel::test {

using Points = std::vector<Vec2d>;

inline const Points square{{0, 0}, {1, 0}, {1, 1}, {0, 1}};

/// The first corner is to the right of the centre, the others follow counter-clockwise.
inline Points regular(int sides, double radius, Vec2d center = {}) {
  Points corners;
  for (int i = 0; i < sides; ++i) {
    const double angle = 2 * std::numbers::pi * i / sides;
    corners.push_back(center + radius * Vec2d{elementary::cos(angle), elementary::sin(angle)});
  }
  return corners;
}

inline Points moved(Points corners, Vec2d by) {
  for (Vec2d& p : corners) p += by;
  return corners;
}

/// So many points in a square of twice the size around the origin.
inline Points scattered(Random& random, int count, double size) {
  Points points;
  for (int i = 0; i < count; ++i) points.push_back({random.between(-size, size), random.between(-size, size)});
  return points;
}

}  // namespace proofreel::test
