#include "engine/collide.h"

#include <algorithm>
#include <limits>

#include "engine/collide_gjk.h"
#include "engine/corners.h"

namespace proofreel {
inline namespace PROOFREEL_PRECISION {
namespace {

struct FaceQuery {
  int face = 0;
  real separation = std::numeric_limits<real>::lowest();
};

/// For each face of `a`, how far in front of it the nearest of b's first `corners` corners is.
template <int faces, int corners>
Row face_separations(const Corners& a, const Corners& b) {
  Row separations;
  for (int i = 0; i < faces; i += lanes) {
    const Lanes x = a.x.at(i);
    const Lanes y = a.y.at(i);
    const Lanes normal_x = a.normal_x.at(i);
    const Lanes normal_y = a.normal_y.at(i);
    Lanes nearest = normal_x * (b.x.of[0] - x) + normal_y * (b.y.of[0] - y);
    for (int j = 1; j < corners; ++j) {
      const Lanes s = normal_x * (b.x.of[j] - x) + normal_y * (b.y.of[j] - y);
      nearest = s < nearest ? s : nearest;
    }
    separations.set(i, nearest);
  }
  return separations;
}

/// What a hull covers of an axis, its rounding included.
std::array<double, 2> interval(const Corners& hull, Vec2 axis) {
  std::array<double, 2> covered{std::numeric_limits<double>::max(), std::numeric_limits<double>::lowest()};
  for (int i = 0; i < hull.count; ++i) {
    const double at = dot(Vec2d(axis), Vec2d(hull.point(i)));
    covered = {std::min(covered[0], at - static_cast<double>(hull.radius)),
               std::max(covered[1], at + static_cast<double>(hull.radius))};
  }
  return covered;
}

AxisTested axis_tested(const Corners& own, const Corners& other, int face, real separation, bool of_a) {
  const Vec2 axis = own.normal(face);
  const std::array<double, 2> owned = interval(own, axis);
  const std::array<double, 2> others = interval(other, axis);
  return {Vec2d(axis), of_a, of_a ? owned : others, of_a ? others : owned,
          static_cast<double>(separation - own.radius - other.radius)};
}

template <typename Observer>
void tell_axes(const Corners& own, const Corners& other, const Row& separations, bool of_a, Observer observer) {
  for (int i = 0; i < own.count; ++i) {
    if constexpr (Observer::watches) observer([&] { return axis_tested(own, other, i, separations.of[i], of_a); });
  }
}

/// The face of `a` that `b` is farthest in front of, by the separating axis theorem: if that is positive, the hulls are
/// apart; otherwise it is the axis of least penetration among a's normals.
template <int faces, int corners, typename Observer>
[[gnu::always_inline]] inline FaceQuery farthest_face(const Corners& a, const Corners& b, bool of_a,
                                                      Observer observer) {
  const Row separations = face_separations<faces, corners>(a, b);
  tell_axes(a, b, separations, of_a, observer);
  FaceQuery best;
  best.face = place_of_largest<faces>(separations, best.separation);
  return best;
}

/// A place on an outline: face `index`, or the corner it begins with.
struct Place {
  int index = 0;
  bool corner = false;
};

/// What of the hull a point outside is nearest to, going on from a face that is almost so: of faces that are almost
/// parallel, rounding may take one for the farthest although the point is beside another.
Place nearest_place(const Corners& hull, int face, Vec2 p) {
  for (int steps = 0; steps < hull.count; ++steps) {
    const Face f = hull.face(face);
    if (dot(p - f.from, f.to - f.from) <= 0) {
      const int before = hull.before(face);
      if (dot(p - f.from, hull.point(before) - f.from) <= 0) return {face, true};
      face = before;
    } else if (dot(p - f.to, f.from - f.to) <= 0) {
      face = hull.next(face);
      if (dot(p - f.to, hull.point(hull.next(face)) - f.to) <= 0) return {face, true};
    } else {
      break;
    }
  }
  return {face, false};
}

/// A disc's centre against a hull; the manifold's normal points from the hull to the disc.
template <int size, typename Observer>
Manifold collide_hull_disc(const Corners& hull, const Corners& disc, real margin, bool hull_is_a, Observer observer) {
  const Vec2 c = disc.point(0);
  const FaceQuery q = farthest_face<size, 1>(hull, disc, hull_is_a, observer);
  if (q.separation - hull.radius - disc.radius > margin) return {};
  if constexpr (Observer::watches)
    observer([&] {
      const real separation = q.separation - hull.radius - disc.radius;
      return AxisChosen{Vec2d(hull.normal(q.face)), hull_is_a, static_cast<double>(separation)};
    });
  const bool inside = q.separation <= 0 && hull.count > 2;
  const Place place = inside ? Place{q.face} : nearest_place(hull, q.face, c);
  const Vec2 n = hull.normal(place.index);
  const Vec2 v = hull.point(place.index);
  const auto feature = static_cast<std::uint32_t>(place.index);
  if (place.corner) return collide_points(v, c, hull.radius, disc.radius, hull.normal(q.face), margin, feature);
  const real separation = dot(n, c - v);
  return single_point(c - separation * n, c, n, hull.radius, disc.radius, separation, margin, feature | 0x100U);
}

struct ClosestPoints {
  Vec2 a;
  Vec2 b;
};

/// The closest points of the segments p1-q1 and p2-q2 (after Ericson 2005, section 5.1.9). Parallel ones have many: any
/// will do, since clipping finds the stretch. One that is a point is all on its first end.
ClosestPoints closest_on_segments(Vec2 p1, Vec2 q1, Vec2 p2, Vec2 q2) {
  const Vec2 d1 = q1 - p1;
  const Vec2 d2 = q2 - p2;
  const Vec2 r = p1 - p2;
  const real a = dot(d1, d1);
  const real e = dot(d2, d2);
  const real b = dot(d1, d2);
  const real c = dot(d1, r);
  const real f = dot(d2, r);
  const real denominator = a * e - b * b;
  real s = denominator > 0 ? std::clamp((b * f - c * e) / denominator, real(0), real(1)) : real(0);
  real t = e > 0 ? (b * s + f) / e : real(0);
  if (!(e > 0) || t < 0 || t > 1) {
    t = std::clamp(t, real(0), real(1));
    s = a > 0 ? std::clamp((b * t - c) / a, real(0), real(1)) : real(0);
  }
  return {p1 + s * d1, p2 + t * d2};
}

/// The edge of `hull` that lies most against `normal`.
template <int size>
[[gnu::always_inline]] inline int incident_edge(const Corners& hull, Vec2 normal) {
  Row back;
  for (int i = 0; i < size; i += lanes) back.set(i, -(normal.x * hull.x.at(i) + normal.y * hull.y.at(i)));
  real unused;
  const int deepest = place_of_largest<size>(back, unused);
  const int before = hull.before(deepest);
  return dot(normal, hull.normal(before)) < dot(normal, hull.normal(deepest)) ? before : deepest;
}

/// What is asked of two hulls.
struct Question {
  const Hull& hull_a;
  const Hull& hull_b;
  const Pose& b_in_a;
  real margin;
  real tolerance;  ///< separations that differ by less are equally good
  real largest;    ///< separation along any axis: what the cores are apart at least, or on overlap minus their depth
};

/// What the separation of two edges may be off by, metres.
real rounding_of(const Face& a, const Face& b) {
  real largest = 0;
  for (const Vec2 p : {a.from, a.to, b.from, b.to}) largest = std::max({largest, std::abs(p.x), std::abs(p.y)});
  return 4 * std::numeric_limits<real>::epsilon() * largest;
}

/// How far the cores are apart along a unit direction: never more than their distance.
real gap_along(const Corners& from, const Corners& to, Vec2 direction) {
  real front = dot(direction, from.point(0));
  real back = dot(direction, to.point(0));
  for (int i = 1; i < from.count; ++i) front = std::max(front, dot(direction, from.point(i)));
  for (int i = 1; i < to.count; ++i) back = std::min(back, dot(direction, to.point(i)));
  return back - front;
}

/// One of the two hulls and one of its faces.
struct HullFace {
  const Corners& hull;
  Face face;
};

/// Corner against corner, apart or almost: clipping found nothing of the incident edge, or only parts that are farther
/// away. When the two edges prove not to be the nearest, rounding has taken one for another that is almost parallel to
/// it; then GJK, which does not choose between faces, has the answer.
Manifold touch_at_corners(const HullFace& ref, const HullFace& inc, bool flipped, const Question& asked, real slack,
                          std::uint32_t feature, const Manifold& clipped) {
  const ClosestPoints near = closest_on_segments(ref.face.from, ref.face.to, inc.face.from, inc.face.to);
  const real core_distance = distance(near.a, near.b);
  if (core_distance > slack) {
    const Vec2 way = (real(1) / core_distance) * (near.b - near.a);
    if (gap_along(ref.hull, inc.hull, way) < core_distance - slack) {
      Manifold m = collide_gjk(asked.hull_a, Pose{}, asked.hull_b, asked.b_in_a, asked.margin);
      if (flipped) flip(m);
      return m;
    }
  }
  if (deepest(clipped) <= core_distance - ref.hull.radius - inc.hull.radius + slack) return clipped;
  return collide_points(near.a, near.b, ref.hull.radius, inc.hull.radius, ref.face.normal, asked.margin, feature);
}

/// What the two faces do not give at once.
[[gnu::noinline]] Manifold touch_beside_faces(const HullFace& ref, const HullFace& inc, real separation, bool flipped,
                                              const Question& asked, std::uint32_t feature, const Manifold& clipped) {
  const real slack = std::max(real(0.01) * asked.tolerance, rounding_of(ref.face, inc.face));
  if (deepest(clipped) <= asked.largest - ref.hull.radius - inc.hull.radius + slack) return clipped;
  if (separation > -asked.tolerance) return touch_at_corners(ref, inc, flipped, asked, slack, feature, clipped);
  // Of two faces equally good, the one taken may be the one the deepest corner is just beside.
  const Vec2 n = ref.face.normal;
  const Vec2 corner = dot(inc.face.from, n) < dot(inc.face.to, n) ? inc.face.from : inc.face.to;
  return single_point(corner - separation * n, corner, n, ref.hull.radius, inc.hull.radius, separation, asked.margin,
                      feature);
}

/// What two hulls touch in, once it is known on which face: `ref` is the hull that has it, `inc` the other one. A point
/// as near as the largest separation of all axes is proven to be the nearest; where there is none, more has to be
/// asked.
template <int size, typename Observer>
Manifold touch_on_face(const Corners& ref, int face, real separation, const Corners& inc, bool flipped,
                       const Question& asked, Observer observer) {
  const Face ref_face = ref.face(face);
  const int inc_index = incident_edge<size>(inc, ref_face.normal);
  const Face inc_face = inc.face(inc_index);
  if constexpr (Observer::watches)
    observer([&] {
      return AxisChosen{Vec2d(ref_face.normal), !flipped, static_cast<double>(separation - ref.radius - inc.radius)};
    });
  if constexpr (Observer::watches)
    observer([&] {
      return FacesChosen{Vec2d(ref_face.from), Vec2d(ref_face.to), Vec2d(inc_face.from), Vec2d(inc_face.to), !flipped};
    });
  const std::uint32_t feature =
      (flipped ? 1U << 20 : 0U) | static_cast<std::uint32_t>(face) << 12 | static_cast<std::uint32_t>(inc_index) << 4;
  Manifold m = clip(ref_face, ref.radius, inc_face, inc.radius, asked.margin, feature, observer);
  if (deepest(m) > asked.largest - ref.radius - inc.radius + real(0.01) * asked.tolerance) {
    m = touch_beside_faces({ref, ref_face}, {inc, inc_face}, separation, flipped, asked, feature | 8U, m);
  }
  if (flipped) flip(m);
  return m;
}

/// Two hulls of two or more points.
template <int size_a, int size_b, typename Observer>
Manifold collide_hulls(const Hull& hull_a, const Hull& hull_b, const Pose& b_in_a, real margin, Observer observer) {
  Corners a;
  Corners b;
  load<size_a>(hull_a, a);
  load<size_b>(hull_b, b_in_a, b);
  const real limit = margin + a.radius + b.radius;
  const FaceQuery face_a = farthest_face<size_a, size_b>(a, b, true, observer);
  if (face_a.separation > limit) return {};
  load_normals<size_b>(hull_b, b_in_a.rotation, b);
  const FaceQuery face_b = farthest_face<size_b, size_a>(b, a, false, observer);
  // Two parallel faces in contact are equally good; preferring A's keeps the features from changing every other step.
  const real tolerance = real(1e-4) * std::min(hull_a.detail, hull_b.detail);
  const real largest = std::max(face_a.separation, face_b.separation);
  const bool flipped = face_b.separation > face_a.separation + (largest > tolerance ? real(0) : tolerance);
  if ((flipped ? face_b : face_a).separation > limit) return {};
  const Question asked{hull_a, hull_b, b_in_a, margin, tolerance, largest};
  if (flipped) return touch_on_face<size_a>(b, face_b.face, face_b.separation, a, true, asked, observer);
  return touch_on_face<size_b>(a, face_a.face, face_a.separation, b, false, asked, observer);
}

/// A hull of two or more points and a disc, in the hull's frame or the disc's.
template <int size, typename Observer>
Manifold collide_with_disc(const Hull& hull_a, const Hull& hull_b, const Pose& b_in_a, real margin, Observer observer) {
  Corners a;
  Corners b;
  load<size>(hull_a, a);
  load<size>(hull_b, b_in_a, b);
  if (b.count == 1) return collide_hull_disc<size>(a, b, margin, true, observer);
  load_normals<size>(hull_b, b_in_a.rotation, b);
  Manifold m = collide_hull_disc<size>(b, a, margin, false, observer);
  flip(m);
  return m;
}

/// The sizes to compute with; each has loops of its own.
template <int size_a, typename Observer>
Manifold collide_size_b(const Hull& a, const Hull& b, const Pose& b_in_a, real margin, Observer observer) {
  if (b.count <= 4) return collide_hulls<size_a, 4>(a, b, b_in_a, margin, observer);
  if (b.count <= 8) return collide_hulls<size_a, 8>(a, b, b_in_a, margin, observer);
  return collide_hulls<size_a, max_polygon_vertices>(a, b, b_in_a, margin, observer);
}

template <typename Observer>
Manifold collide_local(const Hull& a, const Hull& b, const Pose& b_in_a, real margin, Observer observer) {
  if (a.count > 1 && b.count > 1) {
    if (a.count <= 4) return collide_size_b<4>(a, b, b_in_a, margin, observer);
    if (a.count <= 8) return collide_size_b<8>(a, b, b_in_a, margin, observer);
    return collide_size_b<max_polygon_vertices>(a, b, b_in_a, margin, observer);
  }
  const int corners = std::max(a.count, b.count);
  if (corners == 1) {
    return collide_points(a.points[0], to_world(b_in_a, b.points[0]), a.radius, b.radius, {0, 1}, margin, 0);
  }
  if (corners <= 4) return collide_with_disc<4>(a, b, b_in_a, margin, observer);
  if (corners <= 8) return collide_with_disc<8>(a, b, b_in_a, margin, observer);
  return collide_with_disc<max_polygon_vertices>(a, b, b_in_a, margin, observer);
}

}  // namespace

template <typename Observer>
Manifold collide(const Hull& a, const Pose& pose_a, const Hull& b, const Pose& pose_b, real margin, Observer observer) {
  const Pose b_in_a = relative_pose(pose_a, pose_b);
  Manifold m = collide_local(a, b, b_in_a, margin, observer);
  m.normal = rotate(pose_a.rotation, m.normal);
  for (int i = 0; i < m.count; ++i) m.points[i].point = rotate(pose_a.rotation, m.points[i].point);
  return m;
}

template Manifold collide<NoObserver>(const Hull&, const Pose&, const Hull&, const Pose&, real, NoObserver);
template Manifold collide<Observer>(const Hull&, const Pose&, const Hull&, const Pose&, real, Observer);

}  // namespace PROOFREEL_PRECISION
}  // namespace proofreel
