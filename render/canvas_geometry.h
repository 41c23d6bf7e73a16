#pragma once

/// Geometry a canvas needs before it hands shapes to float32: pixels, in double precision.

#include <span>
#include <vector>

#include "engine/aabb.h"

namespace proofreel {

/// Twice the area, positive when the corners run from +x to +y.
double doubled_area(std::span<const Vec2d> corners);

/// The corners with positive area, as they are or reversed.
std::vector<Vec2d> oriented(std::span<const Vec2d> corners);

/// The part of a convex polygon where dot(normal, p) <= offset.
std::vector<Vec2d> cut(const std::vector<Vec2d>& corners, Vec2d normal, double offset);

/// The part of a convex polygon inside the box; empty when there is none (Sutherland and Hodgman 1974).
std::vector<Vec2d> clipped(const std::vector<Vec2d>& corners, const Aabbd& box);

/// The part of a segment inside the box (Liang and Barsky 1984); false when there is none.
bool clip_segment(Vec2d& a, Vec2d& b, const Aabbd& box);

/// A turned rectangle.
struct Quad {
  Vec2d center;
  Vec2d axis{1, 0};  ///< unit; the second axis is a quarter turn from it
  double half_x = 0;
  double half_y = 0;
};

double area(const Quad& quad);
Quad quad_of(const Aabbd& box);
Aabbd bounds_of(const Quad& quad);

/// Whether the two may have a point in common: true unless a side of the quad keeps them apart.
bool may_touch(const Quad& quad, const Aabbd& box);

/// The smallest turned rectangle around a convex polygon; one of its sides lies on an edge (Freeman and Shapira 1975).
Quad smallest_quad(const std::vector<Vec2d>& corners);

/// The rectangle these four corners are; false when they are not one to a thousandth of a pixel.
bool is_rectangle(std::span<const Vec2d> corners, Quad& rectangle);

/// A disc too large for float32, as a polygon that equals it inside the box to a hundredth of a pixel.
std::vector<Vec2d> disc_near(Vec2d center, double radius, const Aabbd& box);

}  // namespace proofreel
