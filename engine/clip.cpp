#include "engine/clip.h"

namespace proofreel {
inline namespace PROOFREEL_PRECISION {

int incident_edge(const Hull& hull, Vec2 normal) {
  int deepest = 0;
  for (int i = 1; i < hull.count; ++i) {
    if (dot(normal, hull.points[i]) < dot(normal, hull.points[deepest])) deepest = i;
  }
  const int before = deepest > 0 ? deepest - 1 : hull.count - 1;
  return dot(normal, hull.normals[before]) < dot(normal, hull.normals[deepest]) ? before : deepest;
}

Manifold single_point(Vec2 on_a, Vec2 on_b, Vec2 normal, real radius_a, real radius_b, real core_distance, real margin,
                      std::uint32_t feature) {
  Manifold m;
  m.normal = normal;
  m.points[0] = point_between(on_a, on_b, normal, radius_a, radius_b, core_distance, feature);
  m.count = m.points[0].separation <= margin ? 1 : 0;
  return m;
}

Manifold collide_points(Vec2 on_a, Vec2 on_b, real radius_a, real radius_b, Vec2 fallback, real margin,
                        std::uint32_t feature) {
  const real d = distance(on_a, on_b);
  const Vec2 normal = d > 0 ? (real(1) / d) * (on_b - on_a) : fallback;
  return single_point(on_a, on_b, normal, radius_a, radius_b, d, margin, feature);
}

}  // namespace PROOFREEL_PRECISION
}  // namespace proofreel
