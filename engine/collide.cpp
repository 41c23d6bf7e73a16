#include "engine/collide.h"

#include <algorithm>
#include <bit>
#include <cstring>
#include <limits>
#include <type_traits>

namespace proofreel {
inline namespace PROOFREEL_PRECISION {
namespace {

/// Four floats or two doubles at once. This is how GCC and Clang spell it on every processor, WebAssembly included:
/// each lane computes what a plain number would, so the bits are those of the loop over single numbers.
using Lanes [[gnu::vector_size(16)]] = real;
constexpr int lanes = sizeof(Lanes) / sizeof(real);

/// Whole numbers as wide, which is what a comparison of lanes gives: all bits set where it holds.
using Mark = std::conditional_t<sizeof(real) == 4, std::int32_t, std::int64_t>;
using Marks [[gnu::vector_size(16)]] = Mark;

/// One number per corner of a hull, in whole lanes.
struct Row {
  alignas(Lanes) real of[max_polygon_vertices];

  Lanes at(int i) const {
    Lanes values;
    std::memcpy(&values, of + i, sizeof(Lanes));
    return values;
  }
  void set(int i, Lanes values) { std::memcpy(of + i, &values, sizeof(Lanes)); }
};

/// A hull in A's frame, coordinate by coordinate. Places behind the last corner repeat corner 0, as in Hull, which
/// changes no minimum and no maximum. So loops may run over `size` places, a round number known to the compiler, and
/// need no branch that depends on how many corners there are. Not initialised, because most of it is never used.
struct Corners {
  Row x, y;
  Row normal_x, normal_y;
  int count;
  real radius;

  Vec2 point(int i) const { return {x.of[i], y.of[i]}; }
  Vec2 normal(int i) const { return {normal_x.of[i], normal_y.of[i]}; }
  int next(int i) const { return i + 1 < count ? i + 1 : 0; }
  int before(int i) const { return i > 0 ? i - 1 : count - 1; }
  Face face(int i) const { return {point(i), point(next(i)), normal(i)}; }
};

/// Lanes of points, coordinate by coordinate.
struct Points {
  Lanes x, y;
};

Points points_at(const Vec2* from) {
  Points p;
  for (int lane = 0; lane < lanes; ++lane) {
    p.x[lane] = from[lane].x;
    p.y[lane] = from[lane].y;
  }
  return p;
}

Points rotated(Rot q, Points p) { return {q.c * p.x - q.s * p.y, q.s * p.x + q.c * p.y}; }

template <int size>
void load(const Hull& hull, Corners& out) {
  out.count = hull.count;
  out.radius = hull.radius;
  for (int i = 0; i < size; i += lanes) {
    const Points p = points_at(hull.points + i);
    const Points n = points_at(hull.normals + i);
    out.x.set(i, p.x);
    out.y.set(i, p.y);
    out.normal_x.set(i, n.x);
    out.normal_y.set(i, n.y);
  }
}

/// Without its normals, which a hull that is apart does not need.
template <int size>
void load(const Hull& hull, const Pose& pose, Corners& out) {
  out.count = hull.count;
  out.radius = hull.radius;
  for (int i = 0; i < size; i += lanes) {
    const Points p = rotated(pose.rotation, points_at(hull.points + i));
    out.x.set(i, pose.position.x + p.x);
    out.y.set(i, pose.position.y + p.y);
  }
}

template <int size>
void load_normals(const Hull& hull, Rot rotation, Corners& out) {
  for (int i = 0; i < size; i += lanes) {
    const Points n = rotated(rotation, points_at(hull.normals + i));
    out.normal_x.set(i, n.x);
    out.normal_y.set(i, n.y);
  }
}

/// The first place of the largest number, which is put into `all`. Guesses about which one that is would be wrong half
/// of the time, and cost more than looking at all of them.
template <int size>
[[gnu::always_inline]] inline int place_of_largest(const Row& row, real& all) {
  Lanes largest = row.at(0);
  for (int i = lanes; i < size; i += lanes) largest = row.at(i) > largest ? row.at(i) : largest;
  all = largest[0];
  for (int lane = 1; lane < lanes; ++lane) all = largest[lane] > all ? largest[lane] : all;
  Marks mark{};
  for (int lane = 0; lane < lanes; ++lane) mark[lane] = Mark{1} << lane;
  Marks found = (row.at(0) >= all) & mark;
  for (int i = lanes; i < size; i += lanes) found |= (row.at(i) >= all) & (mark << i);
  unsigned any = 1U << (size - 1);
  for (int lane = 0; lane < lanes; ++lane) any |= static_cast<unsigned>(found[lane]);
  return std::countr_zero(any);
}

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

Manifold disc_on_face(const Corners& hull, int face, const Corners& disc, real margin) {
  const Vec2 c = disc.point(0);
  const Vec2 n = hull.normal(face);
  const real separation = dot(n, c - hull.point(face));
  return single_point(c - separation * n, c, n, hull.radius, disc.radius, separation, margin,
                      static_cast<std::uint32_t>(face) | 0x100U);
}

/// Whether p lies between the two ends of a face.
bool is_beside(const Corners& hull, int face, Vec2 p) {
  const Face f = hull.face(face);
  return dot(p - f.from, f.to - f.from) > 0 && dot(p - f.to, f.from - f.to) > 0;
}

/// A disc's centre against a hull; the manifold's normal points from the hull to the disc. Of two almost parallel faces
/// rounding may have taken the wrong one: a corner is touched only where the centre is beside neither face.
template <int size, typename Observer>
Manifold collide_hull_disc(const Corners& hull, const Corners& disc, real margin, bool hull_is_a, Observer observer) {
  const Vec2 c = disc.point(0);
  const FaceQuery q = farthest_face<size, 1>(hull, disc, hull_is_a, observer);
  if (q.separation - hull.radius - disc.radius > margin) return {};
  const int i = q.face;
  if constexpr (Observer::watches)
    observer([&] {
      const real separation = q.separation - hull.radius - disc.radius;
      return AxisChosen{Vec2d(hull.normal(i)), hull_is_a, static_cast<double>(separation)};
    });
  const auto [v1, v2, n] = hull.face(i);
  const bool inside = q.separation <= 0 && hull.count > 2;
  const auto feature = static_cast<std::uint32_t>(i);
  const auto next_feature = static_cast<std::uint32_t>(hull.next(i));
  if (!inside && dot(c - v1, v2 - v1) <= 0) {
    if (const int before = hull.before(i); is_beside(hull, before, c)) return disc_on_face(hull, before, disc, margin);
    return collide_points(v1, c, hull.radius, disc.radius, n, margin, feature);
  }
  if (!inside && dot(c - v2, v1 - v2) <= 0) {
    if (const int next = hull.next(i); is_beside(hull, next, c)) return disc_on_face(hull, next, disc, margin);
    return collide_points(v2, c, hull.radius, disc.radius, n, margin, next_feature);
  }
  return single_point(c - q.separation * n, c, n, hull.radius, disc.radius, q.separation, margin, feature | 0x100U);
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
  const int before = deepest > 0 ? deepest - 1 : hull.count - 1;
  return dot(normal, hull.normal(before)) < dot(normal, hull.normal(deepest)) ? before : deepest;
}

/// What two hulls touch in, once it is known on which face: `ref` is the hull that has it, `inc` the other one.
template <int size, typename Observer>
Manifold touch_on_face(const Corners& ref, int face, real separation, const Corners& inc, bool flipped, real margin,
                       real tolerance, Observer observer) {
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
  Manifold m = clip(ref_face, ref.radius, inc_face, inc.radius, margin, feature, observer);
  if (separation > -tolerance) {
    // Corner against corner: clipping finds nothing of the incident edge, or only parts that are farther away.
    const ClosestPoints near = closest_on_segments(ref_face.from, ref_face.to, inc_face.from, inc_face.to);
    const real core_distance = distance(near.a, near.b);
    const real radius_a = flipped ? inc.radius : ref.radius;
    const real radius_b = flipped ? ref.radius : inc.radius;
    if (deepest(m) > core_distance - radius_a - radius_b + real(0.01) * tolerance) {
      m = collide_points(near.a, near.b, ref.radius, inc.radius, ref_face.normal, margin, feature | 8U);
    }
  } else if (m.count == 0) {
    // Of two faces equally good, the one taken may be the one the deepest corner is just beside.
    const Vec2 n = ref_face.normal;
    const Vec2 corner = dot(inc_face.from, n) < dot(inc_face.to, n) ? inc_face.from : inc_face.to;
    m = single_point(corner - separation * n, corner, n, ref.radius, inc.radius, separation, margin, feature | 8U);
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
  const bool apart = std::max(face_a.separation, face_b.separation) > tolerance;
  const bool flipped = face_b.separation > face_a.separation + (apart ? real(0) : tolerance);
  if ((flipped ? face_b : face_a).separation > limit) return {};
  if (flipped) return touch_on_face<size_a>(b, face_b.face, face_b.separation, a, true, margin, tolerance, observer);
  return touch_on_face<size_b>(a, face_a.face, face_a.separation, b, false, margin, tolerance, observer);
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
  // The second one too if there is none, which costs less than asking.
  for (ManifoldPoint& p : m.points) p.point = rotate(pose_a.rotation, p.point);
  return m;
}

template Manifold collide<NoObserver>(const Hull&, const Pose&, const Hull&, const Pose&, real, NoObserver);
template Manifold collide<Observer>(const Hull&, const Pose&, const Hull&, const Pose&, real, Observer);

}  // namespace PROOFREEL_PRECISION
}  // namespace proofreel
