#pragma once

/// From a normal to contact points (thesis chapter 4.4, clipping). Whatever found the normal (separating axes, or GJK
/// with EPA) knows along which direction two shapes touch, but a box on a floor touches in a whole stretch, and resting
/// needs both ends of it. Clipping finds them: the reference face is the one the normal stands on, the incident face is
/// the one of the other shape that lies most against it, and of the incident face everything is cut off that is not in
/// front of the reference face. What is left has two ends: the points.
///
/// Everything given to one call is in one frame; which one does not matter.

#include <cstdint>
#include <limits>

#include "engine/observer.h"
#include "engine/shape.h"

namespace proofreel {
inline namespace PROOFREEL_PRECISION {

/// One point of a manifold. It stays the same one as long as the same features touch, which `feature` names.
struct ManifoldPoint {
  Vec2 point;           ///< midway between the surfaces; from collide: relative to A's centre of mass, in world axes
  real separation = 0;  ///< metres along the normal, negative on overlap
  std::uint32_t feature = 0;
};

/// All that two convex shapes touch in: one normal and one or two points.
struct Manifold {
  Vec2 normal;  ///< unit, from A to B
  ManifoldPoint points[2];
  int count = 0;
};

/// The least separation of all points; the largest number there is for a manifold without points. No loop: whether
/// there are one or two is anybody's guess.
inline real deepest(const Manifold& m) {
  constexpr real none = std::numeric_limits<real>::max();
  const real first = m.count > 0 ? m.points[0].separation : none;
  const real second = m.count > 1 ? m.points[1].separation : none;
  return second < first ? second : first;
}

/// The manifold as seen from the other shape: the normal turns round, the points stay.
inline void flip(Manifold& m) { m.normal = -m.normal; }

/// One edge of a hull, which is all that clipping wants to know of a shape besides its radius.
struct Face {
  Vec2 from;
  Vec2 to;      ///< counter-clockwise after `from`
  Vec2 normal;  ///< unit, outward
};

/// The corner after corner `i`, counter-clockwise.
inline int next_index(const Hull& hull, int i) { return i + 1 < hull.count ? i + 1 : 0; }

/// The edge that starts at corner `i`.
inline Face face_of(const Hull& hull, int i) {
  return {hull.points[i], hull.points[next_index(hull, i)], hull.normals[i]};
}

/// The edge of `hull` that lies most against `normal`: one of the two at the corner farthest back along it. On a tie
/// the later edge, so that the answer does not depend on rounding elsewhere.
int incident_edge(const Hull& hull, Vec2 normal);

/// A contact between the core points `on_a` and `on_b` (of shapes not yet rounded), `core_distance` apart along
/// `normal`, which points from A to B.
inline ManifoldPoint point_between(Vec2 on_a, Vec2 on_b, Vec2 normal, real radius_a, real radius_b, real core_distance,
                                   std::uint32_t feature) {
  const Vec2 surface_a = on_a + radius_a * normal;
  const Vec2 surface_b = on_b - radius_b * normal;
  return {real(0.5) * (surface_a + surface_b), core_distance - radius_a - radius_b, feature};
}

/// A manifold of that one point; of none when it is farther apart than `margin`.
Manifold single_point(Vec2 on_a, Vec2 on_b, Vec2 normal, real radius_a, real radius_b, real core_distance, real margin,
                      std::uint32_t feature);

/// Two discs, or two corners: the normal joins the points. Coincident points may part in any direction, so they part
/// along `fallback` (unit): they overlap by the sum of the radii. The thesis has the radius of the first, which leaves
/// the second where it is.
Manifold collide_points(Vec2 on_a, Vec2 on_b, real radius_a, real radius_b, Vec2 fallback, real margin,
                        std::uint32_t feature);

/// The part of the incident face between the side planes of the reference face, point by point. The normal points out
/// of the reference shape: where that is B, the caller flips the manifold. Points farther apart than `margin` are left
/// out. The last bit of `feature` must be free; it tells the two ends apart.
/// Tells the observer of every end (PointClipped).
///
/// Defined here, because the faces come straight out of registers: handed over in memory, they cost a tenth of a
/// manifold.
template <typename Observer = NoObserver>
[[gnu::always_inline]] inline Manifold clip(const Face& ref, real ref_radius, const Face& inc, real inc_radius,
                                            real margin, std::uint32_t feature, Observer observer = {}) {
  const Vec2 v1 = ref.from;
  const Vec2 n = ref.normal;
  const Vec2 tangent = normalized(ref.to - v1);
  const real width = dot(ref.to - v1, tangent);
  // The incident edge runs the other way, so its end comes first along the reference face.
  const Vec2 w1 = inc.to;
  const Vec2 w2 = inc.from;
  const real x1 = dot(w1 - v1, tangent);
  const real x2 = dot(w2 - v1, tangent);
  Manifold m;
  m.normal = n;
  if (x2 < 0 || x1 > width) return m;
  // Whether an end is cut is anybody's guess, so both are computed alike: from a start, so much of the way w1 to w2.
  const real run = x2 - x1;
  const bool cut1 = x1 < 0 && run > 0;
  const bool cut2 = x2 > width && run > 0;
  const Vec2 starts[2] = {w1, {cut2 ? w1.x : w2.x, cut2 ? w1.y : w2.y}};
  const real ways[2] = {cut1 ? -x1 / run : 0, cut2 ? (width - x1) / run : 0};
  for (std::uint32_t k = 0; k < 2; ++k) {
    const Vec2 end = starts[k] + ways[k] * (w2 - w1);
    const real core = dot(end - v1, n);
    const ManifoldPoint p = point_between(end - core * n, end, n, ref_radius, inc_radius, core, feature | k);
    const bool kept = p.separation <= margin;
    if constexpr (Observer::watches)
      observer([&] {
        return PointClipped{Vec2d(k == 0 ? w1 : w2), Vec2d(end), static_cast<double>(p.separation), kept};
      });
    m.points[m.count] = p;
    m.count += kept ? 1 : 0;
  }
  return m;
}

}  // namespace PROOFREEL_PRECISION
}  // namespace proofreel
