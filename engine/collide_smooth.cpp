#include "engine/collide_smooth.h"

#include <algorithm>
#include <limits>

#include "engine/clip.h"

namespace proofreel {
inline namespace PROOFREEL_PRECISION {
namespace {

/// Separations that differ by less than this part of the smaller detail are equal.
constexpr real tie = real(1e-4);

/// A face, and the corner of the other shape that lies farthest back along its normal.
struct Axis {
  bool of_a = true;
  int face = 0;
  real separation = std::numeric_limits<real>::lowest();
};

/// The corner of `hull` farthest back along `normal`.
int farthest_back(const Hull& hull, Vec2 normal) {
  int best = 0;
  for (int i = 1; i < hull.count; ++i) {
    if (dot(normal, hull.points[i] - hull.points[best]) < 0) best = i;
  }
  return best;
}

/// How a face may push a corner of the other shape.
enum class Admission {
  none,
  beyond,  ///< where the corner is, a neighbour covers the face, but not all of it
  full
};

/// Whether all corners that lie farthest back along the normal may be pushed against: of a parallel face both do, and
/// which of them is touched nobody knows yet.
bool corners_admit(const SeamedHull& inc, Vec2 normal, int farthest) {
  if (inc.seam == nullptr) return true;
  const real level = dot(normal, inc.hull.points[farthest]) + tie * inc.hull.detail;
  for (int i = 0; i < inc.hull.count; ++i) {
    if (dot(normal, inc.hull.points[i]) > level) continue;
    if (!inc.seam->is_ridge(i) || !inc.seam->admits(inc.hull, i, -normal)) return false;
  }
  return true;
}

Admission admission(const SeamedHull& ref, int face, const SeamedHull& inc, int corner) {
  const Vec2 normal = ref.hull.normals[face];
  if (!corners_admit(inc, normal, corner)) return Admission::none;
  if (ref.seam == nullptr) return Admission::full;
  const real along = dot(inc.hull.points[corner] - ref.hull.points[face], perp(normal));
  if (!ref.seam->hides(ref.hull, face, along)) return Admission::full;
  return ref.seam->hides_all(ref.hull, face) ? Admission::none : Admission::beyond;
}

/// The best axis of all, and the best ones that may push.
struct AxisSearch {
  real largest = std::numeric_limits<real>::lowest();
  Axis best;
  Axis beyond;
};

void keep_better(Axis& best, const Axis& axis, real advantage) {
  if (axis.separation > best.separation + (best.of_a == axis.of_a ? real(0) : advantage)) best = axis;
}

/// `advantage` is by how much a face of this shape must be better than what was found before.
void search(const SeamedHull& ref, const SeamedHull& inc, bool of_a, real advantage, AxisSearch& found) {
  for (int i = 0; i < ref.hull.count && ref.hull.count > 1; ++i) {
    const int corner = farthest_back(inc.hull, ref.hull.normals[i]);
    const Axis axis{of_a, i, dot(ref.hull.normals[i], inc.hull.points[corner] - ref.hull.points[i])};
    found.largest = std::max(found.largest, axis.separation);
    const Admission admitted = admission(ref, i, inc, corner);
    if (admitted == Admission::full) keep_better(found.best, axis, advantage);
    if (admitted == Admission::beyond) keep_better(found.beyond, axis, advantage);
  }
}

/// A point on the outline of a core.
struct OutlinePoint {
  Vec2 point;
  int edge = 0;  ///< or the corner it begins with
  real along = 0;
  bool is_corner = true;
};

OutlinePoint nearest_on_edge(const Hull& hull, int edge, Vec2 p) {
  const Vec2 from = hull.points[edge];
  const int next = next_index(hull, edge);
  const Vec2 way = hull.points[next] - from;
  const real whole = length(way);
  const real along = whole > 0 ? dot(p - from, way) / whole : real(0);
  if (along <= 0) return {from, edge, 0, true};
  if (along >= whole) return {hull.points[next], next, 0, true};
  return {from + (along / whole) * way, edge, along, false};
}

struct NearestPoints {
  OutlinePoint on_a;
  OutlinePoint on_b;
};

/// Of two shapes that are apart a corner of one and some point of the other are nearest.
NearestPoints nearest_points(const Hull& a, const Hull& b) {
  NearestPoints nearest;
  real least = std::numeric_limits<real>::max();
  const auto keep = [&](const OutlinePoint& on_a, const OutlinePoint& on_b) {
    const real squared = length_squared(on_b.point - on_a.point);
    if (squared >= least) return;
    least = squared;
    nearest = {on_a, on_b};
  };
  for (int i = 0; i < a.count; ++i) {
    for (int j = 0; j < b.count; ++j) {
      keep({a.points[i], i, 0, true}, nearest_on_edge(b, j, a.points[i]));
      keep(nearest_on_edge(a, i, b.points[j]), {b.points[j], j, 0, true});
    }
  }
  return nearest;
}

Vec2 middle_of(const Hull& hull) {
  Vec2 sum;
  for (int i = 0; i < hull.count; ++i) sum += hull.points[i];
  return real(1) / static_cast<real>(hull.count) * sum;
}

/// Whether `other` may touch the edge there: it is hidden where a neighbour covers it, and at an inner corner for what
/// comes from elsewhere. Resting on a floor a body sinks in a little, and would catch on what hangs below.
bool is_open(const SeamedHull& shape, const Hull& other, int edge, real along) {
  if (shape.seam == nullptr) return true;
  const real reach = real(0.1) * std::min(shape.hull.detail, other.detail);
  return !shape.seam->hides(shape.hull, edge, along) &&
         !shape.seam->reaches_around(shape.hull, edge, along, reach, middle_of(other));
}

bool admits(const SeamedHull& shape, const Hull& other, const OutlinePoint& at, Vec2 normal) {
  if (!at.is_corner) return is_open(shape, other, at.edge, at.along);
  return shape.seam == nullptr || shape.seam->admits(shape.hull, at.edge, normal);
}

/// Cores apart, a corner nearest to a corner or to a place on an edge that clipping does not reach.
Manifold collide_corners(const SeamedHull& a, const SeamedHull& b, real margin) {
  const NearestPoints near = nearest_points(a.hull, b.hull);
  const Vec2 normal = normalized(near.on_b.point - near.on_a.point);
  if (!admits(a, b.hull, near.on_a, normal) || !admits(b, a.hull, near.on_b, -normal)) return {};
  const std::uint32_t feature =
      8U | static_cast<std::uint32_t>(near.on_a.edge) << 12 | static_cast<std::uint32_t>(near.on_b.edge) << 4;
  return collide_points(near.on_a.point, near.on_b.point, a.hull.radius, b.hull.radius, normal, margin, feature);
}

/// Drops the points at which the reference face may not be touched.
void drop_closed(const SeamedHull& ref, const Hull& other, int face, Manifold& m) {
  const int count = m.count;
  m.count = 0;
  for (int k = 0; k < count; ++k) {
    const real along = dot(m.points[k].point - ref.hull.points[face], perp(ref.hull.normals[face]));
    if (is_open(ref, other, face, along)) m.points[m.count++] = m.points[k];
  }
}

/// The manifold on a face: clipped, or for a disc the one point below its centre.
Manifold collide_face(const SeamedHull& a, const SeamedHull& b, const Axis& axis, bool keep_hidden, real margin) {
  const SeamedHull& ref = axis.of_a ? a : b;
  const SeamedHull& inc = axis.of_a ? b : a;
  const Face face = face_of(ref.hull, axis.face);
  const std::uint32_t own = (axis.of_a ? 0U : 1U << 20) | static_cast<std::uint32_t>(axis.face) << 12;
  Manifold m;
  if (inc.hull.count > 1) {
    const int inc_face = incident_edge(inc.hull, face.normal);
    m = clip(face, ref.hull.radius, face_of(inc.hull, inc_face), inc.hull.radius, margin,
             own | static_cast<std::uint32_t>(inc_face) << 4);
    if (!keep_hidden) drop_closed(ref, inc.hull, axis.face, m);
  } else {
    const Vec2 c = inc.hull.points[0];
    const real along = dot(c - face.from, perp(face.normal));
    if (along >= 0 && along <= distance(face.from, face.to)) {
      m = single_point(c - axis.separation * face.normal, c, face.normal, ref.hull.radius, inc.hull.radius,
                       axis.separation, margin, own);
    }
  }
  if (!axis.of_a) flip(m);
  return m;
}

/// The length small amounts are measured by: the thickness of the thinner shape that has one.
real thinner(const Hull& a, const Hull& b) {
  if (a.thickness <= 0 || b.thickness <= 0) return std::max(a.thickness, b.thickness);
  return std::min(a.thickness, b.thickness);
}

/// Both in A's frame. An admitted axis that is far worse than a hidden one belongs to another side of the shape: then
/// the neighbour has the contact. Only in an inner corner of the common outline, behind the faces of both shapes, each
/// face is covered there by the other; then both push.
Manifold collide_local(const SeamedHull& a, const SeamedHull& b, real margin) {
  const real slack = tie * std::min(a.hull.detail, b.hull.detail);
  AxisSearch found;
  search(a, b, true, 0, found);
  search(b, a, false, slack, found);
  if (found.largest > margin + a.hull.radius + b.hull.radius) return {};
  const real worst = found.largest - real(0.25) * thinner(a.hull, b.hull);
  Manifold m;
  if (found.best.separation > worst) {
    m = collide_face(a, b, found.best, false, margin);
  } else if (found.beyond.separation > worst) {
    m = collide_face(a, b, found.beyond, true, margin);
  }
  const bool apart = found.largest > slack;
  if (!apart) return m;
  const Manifold corners = collide_corners(a, b, margin);
  return deepest(corners) < deepest(m) - real(0.01) * slack ? corners : m;
}

}  // namespace

Manifold collide_smooth(const SeamedHull& a, const Pose& pose_a, const SeamedHull& b, const Pose& pose_b, real margin) {
  const Pose b_in_a = relative_pose(pose_a, pose_b);
  const Hull hull_b = transformed(b.hull, b_in_a);
  Seam seam_b;
  if (b.seam != nullptr) seam_b = transformed(*b.seam, b.hull, b_in_a.rotation);
  Manifold m = collide_local(a, {hull_b, b.seam != nullptr ? &seam_b : nullptr}, margin);
  m.normal = rotate(pose_a.rotation, m.normal);
  for (int i = 0; i < m.count; ++i) m.points[i].point = rotate(pose_a.rotation, m.points[i].point);
  return m;
}

}  // namespace PROOFREEL_PRECISION
}  // namespace proofreel
