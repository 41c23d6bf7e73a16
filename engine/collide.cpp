#include "engine/collide.h"

#include <algorithm>
#include <limits>

namespace proofreel {
inline namespace PROOFREEL_PRECISION {

real deepest(const Manifold& m) {
  real least = std::numeric_limits<real>::max();
  for (int i = 0; i < m.count; ++i) least = std::min(least, m.points[i].separation);
  return least;
}

namespace {

/// Everything below happens in A's frame: B's hull is brought there first.
Hull transformed(const Hull& hull, const Pose& pose) {
  Hull out;
  out.count = hull.count;
  out.radius = hull.radius;
  out.thickness = hull.thickness;
  for (int i = 0; i < hull.count; ++i) {
    out.points[i] = to_world(pose, hull.points[i]);
    out.normals[i] = rotate(pose.rotation, hull.normals[i]);
  }
  return out;
}

int next_index(const Hull& hull, int i) { return i + 1 < hull.count ? i + 1 : 0; }

/// A contact between the core points `on_a` and `on_b`, `core_distance` apart along `normal`.
ManifoldPoint point_between(Vec2 on_a, Vec2 on_b, Vec2 normal, real radius_a, real radius_b, real core_distance,
                            std::uint32_t feature) {
  const Vec2 surface_a = on_a + radius_a * normal;
  const Vec2 surface_b = on_b - radius_b * normal;
  return {real(0.5) * (surface_a + surface_b), core_distance - radius_a - radius_b, feature};
}

Manifold single(Vec2 on_a, Vec2 on_b, Vec2 normal, const Hull& a, const Hull& b, real core_distance, real margin,
                std::uint32_t feature) {
  Manifold m;
  m.normal = normal;
  m.points[0] = point_between(on_a, on_b, normal, a.radius, b.radius, core_distance, feature);
  m.count = m.points[0].separation <= margin ? 1 : 0;
  return m;
}

/// Two discs, or two corners: the normal joins the points. Coincident points may part in any direction, so they part
/// along `fallback`.
Manifold collide_points(Vec2 on_a, Vec2 on_b, const Hull& a, const Hull& b, Vec2 fallback, real margin,
                        std::uint32_t feature) {
  const real d = distance(on_a, on_b);
  const Vec2 normal = d > 0 ? (real(1) / d) * (on_b - on_a) : fallback;
  return single(on_a, on_b, normal, a, b, d, margin, feature);
}

struct FaceQuery {
  int face = 0;
  real separation = std::numeric_limits<real>::lowest();
};

/// The face of `a` that `b` is farthest in front of, by the separating axis theorem: if that is positive, the hulls are
/// apart; otherwise it is the axis of least penetration among a's normals.
FaceQuery farthest_face(const Hull& a, const Hull& b) {
  FaceQuery best;
  for (int i = 0; i < a.count; ++i) {
    real nearest = std::numeric_limits<real>::max();
    for (int j = 0; j < b.count; ++j) nearest = std::min(nearest, dot(a.normals[i], b.points[j] - a.points[i]));
    if (nearest > best.separation) best = {i, nearest};
  }
  return best;
}

/// A disc's centre against a hull; the manifold's normal points from the hull to the disc.
Manifold collide_hull_disc(const Hull& hull, const Hull& disc, real margin) {
  const Vec2 c = disc.points[0];
  const FaceQuery q = farthest_face(hull, disc);
  const int i = q.face;
  const Vec2 v1 = hull.points[i];
  const Vec2 v2 = hull.points[next_index(hull, i)];
  const bool inside = q.separation <= 0 && hull.count > 2;
  const auto feature = static_cast<std::uint32_t>(i);
  if (!inside && dot(c - v1, v2 - v1) <= 0) return collide_points(v1, c, hull, disc, hull.normals[i], margin, feature);
  if (!inside && dot(c - v2, v1 - v2) <= 0) {
    const auto corner = static_cast<std::uint32_t>(next_index(hull, i));
    return collide_points(v2, c, hull, disc, hull.normals[i], margin, corner);
  }
  const Vec2 n = hull.normals[i];
  return single(c - q.separation * n, c, n, hull, disc, q.separation, margin, feature | 0x100U);
}

struct ClosestPoints {
  Vec2 a;
  Vec2 b;
};

/// The closest points of the segments p1-q1 and p2-q2 (after Ericson 2005, section 5.1.9).
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
  real t = (b * s + f) / e;
  if (t < 0 || t > 1) {
    t = std::clamp(t, real(0), real(1));
    s = std::clamp((b * t - c) / a, real(0), real(1));
  }
  return {p1 + s * d1, p2 + t * d2};
}

/// The edge of `hull` that faces against `normal`: one of the two at the vertex deepest along it.
int incident_edge(const Hull& hull, Vec2 normal) {
  int deepest = 0;
  for (int i = 1; i < hull.count; ++i) {
    if (dot(normal, hull.points[i]) < dot(normal, hull.points[deepest])) deepest = i;
  }
  const int before = deepest > 0 ? deepest - 1 : hull.count - 1;
  return dot(normal, hull.normals[before]) < dot(normal, hull.normals[deepest]) ? before : deepest;
}

/// The part of the incident edge between the side planes of the reference face, point by point
/// (thesis chapter 4.4, clipping). The normal points out of the reference hull.
Manifold clip(const Hull& ref, int ref_face, const Hull& inc, int inc_face, real margin, std::uint32_t feature) {
  const Vec2 v1 = ref.points[ref_face];
  const Vec2 v2 = ref.points[next_index(ref, ref_face)];
  const Vec2 n = ref.normals[ref_face];
  const Vec2 tangent = normalized(v2 - v1);
  const real width = dot(v2 - v1, tangent);
  // The incident edge runs the other way, so its end comes first along the reference face.
  const Vec2 w1 = inc.points[next_index(inc, inc_face)];
  const Vec2 w2 = inc.points[inc_face];
  const real x1 = dot(w1 - v1, tangent);
  const real x2 = dot(w2 - v1, tangent);
  Manifold m;
  m.normal = n;
  if (x2 < 0 || x1 > width) return m;
  const real run = x2 - x1;
  const Vec2 ends[2] = {x1 < 0 && run > 0 ? lerp(w1, w2, -x1 / run) : w1,
                        x2 > width && run > 0 ? lerp(w1, w2, (width - x1) / run) : w2};
  for (std::uint32_t k = 0; k < 2; ++k) {
    const real core = dot(ends[k] - v1, n);
    const ManifoldPoint p = point_between(ends[k] - core * n, ends[k], n, ref.radius, inc.radius, core, feature | k);
    if (p.separation <= margin) m.points[m.count++] = p;
  }
  return m;
}

void flip(Manifold& m) { m.normal = -m.normal; }

/// Two hulls of two or more points. `b` is in a's frame.
Manifold collide_hulls(const Hull& a, const Hull& b, real margin) {
  const FaceQuery face_a = farthest_face(a, b);
  const FaceQuery face_b = farthest_face(b, a);
  // Two parallel faces in contact are equally good; preferring A's keeps the features from changing every other step.
  const real tolerance = real(1e-4) * std::min(a.thickness, b.thickness);
  const bool apart = std::max(face_a.separation, face_b.separation) > tolerance;
  const bool flipped = face_b.separation > face_a.separation + (apart ? real(0) : tolerance);
  const Hull& ref = flipped ? b : a;
  const Hull& inc = flipped ? a : b;
  const FaceQuery face = flipped ? face_b : face_a;
  if (face.separation > margin + a.radius + b.radius) return {};

  const int inc_face = incident_edge(inc, ref.normals[face.face]);
  const std::uint32_t feature = (flipped ? 1U << 20 : 0U) | static_cast<std::uint32_t>(face.face) << 12 |
                                static_cast<std::uint32_t>(inc_face) << 4;
  const ClosestPoints near = closest_on_segments(ref.points[face.face], ref.points[next_index(ref, face.face)],
                                                 inc.points[inc_face], inc.points[next_index(inc, inc_face)]);
  Manifold m = clip(ref, face.face, inc, inc_face, margin, feature);
  // Corner against corner: clipping finds nothing of the incident edge, or only parts that are farther away.
  const real core_distance = distance(near.a, near.b);
  const bool missed = deepest(m) > core_distance - a.radius - b.radius + real(0.01) * tolerance;
  if (missed && face.separation > -tolerance) {
    m = collide_points(near.a, near.b, ref, inc, ref.normals[face.face], margin, feature | 8U);
  }
  if (flipped) flip(m);
  return m;
}

Manifold collide_local(const Hull& a, const Hull& b, real margin) {
  if (a.count == 1 && b.count == 1) return collide_points(a.points[0], b.points[0], a, b, {0, 1}, margin, 0);
  if (b.count == 1) return collide_hull_disc(a, b, margin);
  if (a.count == 1) {
    Manifold m = collide_hull_disc(b, a, margin);
    flip(m);
    return m;
  }
  return collide_hulls(a, b, margin);
}

}  // namespace

Manifold collide(const Hull& a, const Pose& pose_a, const Hull& b, const Pose& pose_b, real margin) {
  const Pose b_in_a{to_local(pose_a, pose_b.position), inverse(pose_a.rotation) * pose_b.rotation};
  Manifold m = collide_local(a, transformed(b, b_in_a), margin);
  m.normal = rotate(pose_a.rotation, m.normal);
  for (int i = 0; i < m.count; ++i) m.points[i].point = rotate(pose_a.rotation, m.points[i].point);
  return m;
}

}  // namespace PROOFREEL_PRECISION
}  // namespace proofreel
