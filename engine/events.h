#pragma once

/// What the algorithms that are taught can tell about their run (see observer.h). Plain values in double precision; a
/// point is in the frame the algorithm works in: polygons in their own, pairs of shapes in the frame of shape A, the
/// tree in world coordinates.

#include <array>
#include <cstddef>
#include <cstdint>
#include <variant>

#include "engine/aabb.h"
#include "engine/vec2.h"

namespace proofreel {

// Convexity, hull, triangulation, decomposition (polygon.h, decompose.h).

/// The edge walk has looked at a corner. `turn` is twice the signed area of (before, corner, after).
struct CornerTested {
  Vec2d before, corner, after;
  double turn = 0;
  bool convex = false;
};
/// A quadrilateral's diagonal a-c: do the other two corners lie on different sides of it?
struct DiagonalTested {
  Vec2d a, c;
  Vec2d one, other;
  bool separates = false;
};
/// Gift wrapping compares a point with the best one so far, seen from the last corner of the hull.
struct HullCandidate {
  Vec2d from, best, candidate;
  bool better = false;
};
/// Gift wrapping has gone round as far as this corner.
struct HullCorner {
  Vec2d corner;
  std::size_t number = 0;  ///< from 0
};
/// A triangle of the fan whose area and centroid are summed up.
struct TriangleAdded {
  Vec2d a, b, c;
  double signed_area = 0;
  Vec2d centroid;
};
/// A diagonal along which a concave polygon is cut.
struct CutChosen {
  Vec2d a, b;
};

// Separating axes and clipping (collide.h).

/// Both shapes projected on an axis: the intervals they cover, and how far they are apart on it.
struct AxisTested {
  Vec2d axis;  ///< unit, pointing away from the shape that owns it
  bool of_a = true;
  std::array<double, 2> interval_a{};
  std::array<double, 2> interval_b{};
  double separation = 0;
};
/// The axis the manifold is built on: the one of largest separation.
struct AxisChosen {
  Vec2d axis;
  bool of_a = true;
  double separation = 0;
};
/// The reference face, and the face of the other shape that lies most against it.
struct FacesChosen {
  Vec2d reference_a, reference_b;
  Vec2d incident_a, incident_b;
  bool reference_of_a = true;
};
/// An end of the incident face after it was cut at a side plane of the reference face.
struct PointClipped {
  Vec2d before, after;
  double separation = 0;
  bool kept = false;
};

// Support function, GJK and EPA (gjk.h, epa.h).

/// The point of the Minkowski difference B - A farthest in a direction, and the points of the shapes it comes from.
struct SupportFound {
  Vec2d direction;
  Vec2d on_a, on_b;
  Vec2d difference;
};
/// The simplex after it was reduced to what is nearest the origin.
struct SimplexReduced {
  std::array<Vec2d, 3> points;
  int count = 0;
  Vec2d closest;  ///< to the origin
};
/// GJK has ended.
struct DistanceFound {
  Vec2d on_a, on_b;
  double distance = 0;
  int iterations = 0;
};
/// EPA has found the edge of its polytope nearest the origin.
struct ClosestEdge {
  Vec2d a, b;
  Vec2d normal;
  double distance = 0;
};
/// EPA has put a new corner between the ends of that edge.
struct PolytopeExpanded {
  Vec2d corner;
};

// Time of impact (time_of_impact.h).

/// The bodies are moved on to `time` (0..1 of the way), where they are `separation` apart.
struct Advanced {
  double time = 0;
  double separation = 0;
  Vec2d on_a, on_b;
};

// Dynamic tree (dynamic_tree.h).

/// A node was considered as the sibling of a new leaf; `cost` is the perimeter that would be added.
struct SiblingTested {
  Aabbd box;
  double cost = 0;
};
struct SiblingChosen {
  Aabbd box;
  double cost = 0;
};
/// A child and a grandchild have changed places.
struct NodesRotated {
  Aabbd lowered, raised;
};
/// A query or cast has looked at a node; what lies below a pruned one is left out.
struct NodeVisited {
  Aabbd box;
  bool leaf = false;
  bool pruned = false;
};
/// The traversal of the tree against itself has taken a pair of nodes out of its queue.
struct PairVisited {
  Aabbd a, b;
  bool leaves = false;
  bool pruned = false;
};

// Contact solver (contact_solver.h).

/// A sweep has dealt with a contact: the impulses of its points so far in this substep, N s. `contact` is its place in
/// the list the solver was prepared with.
struct ContactSwept {
  std::uint32_t contact = 0;
  int count = 0;
  std::array<double, 2> normal{};
  std::array<double, 2> tangent{};
};

using Event = std::variant<CornerTested, DiagonalTested, HullCandidate, HullCorner, TriangleAdded, CutChosen,
                           AxisTested, AxisChosen, FacesChosen, PointClipped, SupportFound, SimplexReduced,
                           DistanceFound, ClosestEdge, PolytopeExpanded, Advanced, SiblingTested, SiblingChosen,
                           NodesRotated, NodeVisited, PairVisited, ContactSwept>;

}  // namespace proofreel
