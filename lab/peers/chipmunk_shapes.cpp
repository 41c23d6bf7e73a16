#include "lab/peers/chipmunk_shapes.h"

#include <cmath>
#include <limits>

#include "lab/peers/peer_problems.h"

namespace proofreel {
namespace {

cpShape* make_shape(cpBody* body, const ShapeDef& def) {
  if (def.points.size() == 1) return cpCircleShapeNew(body, def.radius, to_cp(def.points[0]));
  if (def.points.size() == 2) return cpSegmentShapeNew(body, to_cp(def.points[0]), to_cp(def.points[1]), def.radius);
  std::vector<cpVect> points;
  for (const Vec2d point : def.points) points.push_back(to_cp(point));
  return cpPolyShapeNewRaw(body, static_cast<int>(points.size()), points.data(), def.radius);
}

cpShapeFilter to_cp(const FilterDef& filter) {
  const cpGroup group = filter.group < 0 ? static_cast<cpGroup>(-std::int64_t{filter.group}) : CP_NO_GROUP;
  return cpShapeFilterNew(group, static_cast<cpBitmask>(filter.category), static_cast<cpBitmask>(filter.mask));
}

}  // namespace

std::vector<cpShape*> make_shapes(cpBody* body, const BodyDef& def) {
  std::vector<cpShape*> shapes;
  for (const ShapeDef& shape_def : def.shapes) {
    cpShape* shape = make_shape(body, shape_def);
    cpShapeSetFriction(shape, std::sqrt(shape_def.friction.sliding));
    cpShapeSetElasticity(shape, shape_def.restitution);
    cpShapeSetSurfaceVelocity(shape, cpv(shape_def.surface_speed, 0));  // only kept there: see ChipmunkWorld::mix
    cpShapeSetSensor(shape, def.sensor ? cpTrue : cpFalse);
    cpShapeSetFilter(shape, to_cp(def.filter));
    shapes.push_back(shape);
  }
  return shapes;
}

Problem problem_for_chipmunk(const BodyDef& body) {
  if (body.bullet) return "it is a bullet, and Chipmunk has no continuous collision";
  if (body.filter.category > std::numeric_limits<cpBitmask>::max()) {
    return "its category is beyond the 32 that Chipmunk knows";
  }
  return {};
}

}  // namespace proofreel
