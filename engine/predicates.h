#pragma once

/// Questions about points that have a yes or no, answered as exact arithmetic would: an algorithm that trusts them
/// never meets a contradiction, such as a hull that does not close or a cut that crosses another. The coordinates are
/// taken as they are; what rounding did to them before is not undone.

#include "engine/vec2.h"

namespace proofreel {

/// Twice the signed area of the triangle (a, b, c): positive when c lies left of the way from a to b, negative when
/// right of it, zero when the three are on one line. The sign is right for all finite coordinates, whatever their
/// sizes. Where the error bound of the plain formula (Shewchuk 1997, stage A) leaves it open, all six products are
/// added up without any rounding. The value itself is good to 2^-51 of the products it is the difference of.
double orientation(Vec2d a, Vec2d b, Vec2d c);

/// Whether p, known to be on the line through a and b, lies between them or is one of them.
bool is_between(Vec2d p, Vec2d a, Vec2d b);

/// Whether a point of the segment from a to b, ends included, is also one of that from c to d.
bool segments_meet(Vec2d a, Vec2d b, Vec2d c, Vec2d d);

/// Whether they cross: each has its ends on both sides of the other. No end lies on the other segment.
bool segments_cross(Vec2d a, Vec2d b, Vec2d c, Vec2d d);

}  // namespace proofreel
