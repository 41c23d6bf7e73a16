#include "engine/collide_gjk.h"

namespace proofreel {
inline namespace PROOFREEL_PRECISION {

namespace {

/// What GJK, or where the cores overlap EPA, knows of two cores, in A's frame.
struct Nearest {
  Vec2 on_a;
  Vec2 on_b;
  Vec2 normal;
  real distance = 0;  ///< of the cores along the normal, negative on overlap
};

template <typename Observer>
Nearest find_nearest(const HullPair& pair, Observer observer) {
  SimplexCache cache;
  const CoreDistance core = core_distance(pair, cache, observer);
  if (!core.overlap) return {core.on_a, core.on_b, core.normal, core.distance};
  const Penetration inside = core_penetration(pair, cache, observer);
  return {inside.on_a, inside.on_b, inside.normal, -inside.depth};
}

struct BestFace {
  int face = 0;
  real sine = 0;  ///< of the angle between its normal and the direction
};

/// The face that looks along `direction` (unit, in the hull's frame). Compared by sines: near 0 the cosine has lost
/// half its digits.
BestFace face_along(const Hull& hull, Vec2 direction) {
  int best = 0;
  for (int i = 1; i < hull.count; ++i) {
    if (dot(hull.normals[i], direction) > dot(hull.normals[best], direction)) best = i;
  }
  const Vec2 normal = hull.normals[best];
  return {best, dot(normal, direction) > 0 ? std::abs(cross(normal, direction)) : real(1)};
}

Face moved(const Pose& pose, const Face& face) {
  return {to_world(pose, face.from), to_world(pose, face.to), rotate(pose.rotation, face.normal)};
}

/// Clips the two faces that lie against each other; in front of the reference face they may still miss each other.
template <typename Observer>
Manifold clip_faces(const HullPair& pair, Vec2 normal, real margin, std::uint32_t& feature, Observer observer) {
  const Rot rotation = pair.b_in_a.rotation;
  const BestFace on_a = face_along(pair.a, normal);
  const BestFace on_b = face_along(pair.b, inverse_rotate(rotation, -normal));
  // Of parallel faces always A's, so that the features do not change with the rounding.
  const bool flipped = on_b.sine < on_a.sine - 64 * std::numeric_limits<real>::epsilon();
  const Face ref = flipped ? moved(pair.b_in_a, face_of(pair.b, on_b.face)) : face_of(pair.a, on_a.face);
  const int inc_face =
      flipped ? incident_edge(pair.a, ref.normal) : incident_edge(pair.b, inverse_rotate(rotation, ref.normal));
  const Face inc = flipped ? face_of(pair.a, inc_face) : moved(pair.b_in_a, face_of(pair.b, inc_face));
  feature = (flipped ? 1U << 20 : 0U) | static_cast<std::uint32_t>(flipped ? on_b.face : on_a.face) << 12 |
            static_cast<std::uint32_t>(inc_face) << 4;
  if constexpr (Observer::watches)
    observer([&] { return FacesChosen{Vec2d(ref.from), Vec2d(ref.to), Vec2d(inc.from), Vec2d(inc.to), !flipped}; });
  const real ref_radius = flipped ? pair.b.radius : pair.a.radius;
  const real inc_radius = flipped ? pair.a.radius : pair.b.radius;
  Manifold m = clip(ref, ref_radius, inc, inc_radius, margin, feature, observer);
  if (flipped) flip(m);
  return m;
}

template <typename Observer>
Manifold manifold_of(const HullPair& pair, const Nearest& nearest, real margin, Observer observer) {
  const Hull& a = pair.a;
  const Hull& b = pair.b;
  const real separation = nearest.distance - a.radius - b.radius;
  if (separation > margin) return {};
  std::uint32_t feature = 0;
  if (a.count > 1 && b.count > 1) {
    const Manifold m = clip_faces(pair, nearest.normal, margin, feature, observer);
    const real slack = real(1e-6) * std::min(a.thickness, b.thickness) + 2 * rounding_of(nearest.on_a, nearest.on_b);
    if (deepest(m) <= separation + slack) return m;
    feature |= 8U;  // corner against corner: of the faces, other parts are in front of each other, or none
  }
  return single_point(nearest.on_a, nearest.on_b, nearest.normal, a.radius, b.radius, nearest.distance, margin,
                      feature);
}

}  // namespace

template <typename Observer>
Manifold collide_gjk(const Hull& a, const Pose& pose_a, const Hull& b, const Pose& pose_b, real margin,
                     Observer observer) {
  const HullPair pair{a, b, relative_pose(pose_a, pose_b)};
  Manifold m = manifold_of(pair, find_nearest(pair, observer), margin, observer);
  m.normal = rotate(pose_a.rotation, m.normal);
  for (int i = 0; i < m.count; ++i) m.points[i].point = rotate(pose_a.rotation, m.points[i].point);
  return m;
}

template Manifold collide_gjk<NoObserver>(const Hull&, const Pose&, const Hull&, const Pose&, real, NoObserver);
template Manifold collide_gjk<Observer>(const Hull&, const Pose&, const Hull&, const Pose&, real, Observer);

}  // namespace PROOFREEL_PRECISION
}  // namespace proofreel
