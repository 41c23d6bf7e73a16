#pragma once

/// Smooth ground. A floor is often laid of several shapes: a chain of segments, a row of boxes, the convex parts of a
/// concave body. Looked at one by one, each of them has ends, and what slides along the floor catches there, on corners
/// that the floor as a whole does not have (ghost collisions). A seam tells of one shape what its neighbours hide of
/// it: the narrow phase then admits only directions in which the common outline can push.
///
/// Where shapes meet at a corner, the plane around it is divided into sectors, the shapes' own and free ones. An edge
/// that borders on a free sector is exposed; how far the free sector reaches tells whether the common outline is convex
/// there, and which normals lie between its two edges.

#include <span>

#include "engine/shape.h"

namespace proofreel {
inline namespace PROOFREEL_PRECISION {

/// What may push at one corner: the normals counter-clockwise from that of the edge before it to `before_until`, and
/// those from `after_from` to that of the edge after it. Unit vectors in the hull's frame.
struct CornerSeam {
  bool joined = false;         ///< otherwise nothing is hidden here, and the rest does not count
  bool before_exposed = true;  ///< the edge that ends here
  bool after_exposed = true;   ///< the edge that begins here
  bool before_convex = false;  ///< the common outline turns outwards here, seen from the edge before
  bool after_convex = false;
  bool before_concave = false;  ///< it turns inwards here
  bool after_concave = false;
  Vec2 before_until;
  Vec2 after_from;
  Vec2 before_free;  ///< the direction that ends the free sector beside the edge before, and beside the edge after
  Vec2 after_free;
};

struct Seam {
  CornerSeam corners[max_polygon_vertices];
  real hidden_from_start[max_polygon_vertices]{};  ///< m of edge i, from its first corner on
  real hidden_to_end[max_polygon_vertices]{};      ///< m of edge i, up to its second corner

  /// Whether the shape can push along `normal` (unit, hull's frame) at corner `i` of `hull`. At an inner corner of the
  /// common outline only the faces beside it push.
  bool admits(const Hull& hull, int i, Vec2 normal) const;
  /// Whether the common outline sticks out at corner `i`. Where it goes straight on or turns inwards, the faces beside
  /// the corner push, and never the corner.
  bool is_ridge(int i) const;
  /// Whether what touches edge `i` of `hull` at `along` metres from its first corner does so within `reach` of an inner
  /// corner of the common outline, although it has its middle elsewhere than in that corner: it reaches in from the
  /// other side of the neighbour.
  bool reaches_around(const Hull& hull, int i, real along, real reach, Vec2 middle) const;
  /// Whether a neighbour covers the outside of edge `i` of `hull` at `along` metres from its first corner.
  bool hides(const Hull& hull, int i, real along) const;
  /// Whether neighbours cover all of edge `i`.
  bool hides_all(const Hull& hull, int i) const;
};

/// What `others` hide of `own`; all in the frame of `own`. False when they hide nothing. Seams are between sharp
/// shapes, or between capsules of one radius.
bool find_seam(const Hull& own, std::span<const Hull> others, Seam& seam);

Seam transformed(const Seam& seam, const Hull& hull, Rot rotation);

}  // namespace PROOFREEL_PRECISION
}  // namespace proofreel
