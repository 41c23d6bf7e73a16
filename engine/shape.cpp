#include "engine/shape.h"

#include <algorithm>
#include <cassert>
#include <iterator>

namespace proofreel {
inline namespace PROOFREEL_PRECISION {

namespace {

real thickness_of(const Hull& hull) {
  if (hull.count < 3) return 2 * hull.radius;
  real thinnest = std::numeric_limits<real>::max();
  for (int i = 0; i < hull.count; ++i) {
    real depth = 0;
    for (int j = 0; j < hull.count; ++j) {
      depth = std::max(depth, -dot(hull.normals[i], hull.points[j] - hull.points[i]));
    }
    thinnest = std::min(thinnest, depth);
  }
  return thinnest + 2 * hull.radius;
}

}  // namespace

Hull make_hull(const ShapeDef& def, Vec2d center) {
  assert(!def.points.empty() && def.points.size() <= max_polygon_vertices);
  Hull hull;
  hull.count = static_cast<int>(def.points.size());
  hull.radius = static_cast<real>(def.radius);
  for (int i = 0; i < hull.count; ++i) {
    const Vec2d here = def.points[static_cast<std::size_t>(i)];
    const Vec2d next = def.points[static_cast<std::size_t>((i + 1) % hull.count)];
    hull.points[i] = Vec2(here - center);
    hull.normals[i] = Vec2(-perp(normalized(next - here)));
  }
  std::fill(hull.points + hull.count, std::end(hull.points), hull.points[0]);
  std::fill(hull.normals + hull.count, std::end(hull.normals), hull.normals[0]);
  hull.thickness = thickness_of(hull);
  hull.detail = hull.thickness > 0 ? hull.thickness : real(0.01) * distance(hull.points[0], hull.points[1]);
  return hull;
}

Hull transformed(const Hull& hull, const Pose& pose) {
  Hull out = hull;
  for (Vec2& point : out.points) point = to_world(pose, point);
  for (Vec2& normal : out.normals) normal = rotate(pose.rotation, normal);
  return out;
}

Aabb bounds(const Hull& hull, const Pose& pose) {
  Aabb box;
  for (int i = 0; i < hull.count; ++i) box = merged(box, to_world(pose, hull.points[i]));
  return expanded(box, hull.radius);
}

real reach(const Hull& hull) {
  real farthest = 0;
  for (int i = 0; i < hull.count; ++i) farthest = std::max(farthest, length(hull.points[i]));
  return farthest + hull.radius;
}

}  // namespace PROOFREEL_PRECISION
}  // namespace proofreel
