#include "engine/cast.h"

namespace proofreel {
inline namespace PROOFREEL_PRECISION {

namespace {

/// A grazing way makes the jumps converge by halves only; that is enough for all digits of a double.
constexpr int most_jumps = 128;

constexpr real epsilon = std::numeric_limits<real>::epsilon();

/// Of the shapes at one fraction of the way, in the frame of what may be hit.
struct Gap {
  real separation = 0;
  Vec2 normal;  ///< out of what may be hit
  Vec2 point;   ///< on its surface
};

Gap gap_of(const HullPair& pair, const CoreDistance& core) {
  return {core.distance - pair.a.radius - pair.b.radius, core.normal, core.on_a + pair.a.radius * core.normal};
}

template <typename Observer>
Gap overlap_of(const HullPair& pair, const SimplexCache& cache, Observer observer) {
  const Penetration inside = core_penetration(pair, cache, observer);
  return {-inside.depth - pair.a.radius - pair.b.radius, inside.normal, inside.on_a + pair.a.radius * inside.normal};
}

CastHit world_hit(const Pose& pose, real fraction, const Gap& gap, bool at_start) {
  return {fraction, to_world(pose, gap.point), rotate(pose.rotation, gap.normal), at_start};
}

}  // namespace

bool overlap(const Hull& a, const Pose& pose_a, const Hull& b, const Pose& pose_b) {
  return distance(a, pose_a, b, pose_b).separation <= 0;
}

template <typename Observer>
std::optional<CastHit> shape_cast(const Hull& a, const Pose& pose_a, Vec2 translation, const Hull& b,
                                  const Pose& pose_b, Observer observer) {
  const Pose start = relative_pose(pose_b, pose_a);
  const Vec2 way = inverse_rotate(pose_b.rotation, translation);
  SimplexCache cache;
  Gap gap;
  real fraction = 0;
  for (int jump = 0; jump < most_jumps; ++jump) {
    const HullPair pair{b, a, {start.position + fraction * way, start.rotation}};
    const CoreDistance core = core_distance(pair, cache, observer);
    if (core.overlap && jump > 0) {
      gap.point = overlap_of(pair, cache, observer).point;  // but the normal of the way here stands
      break;
    }
    gap = core.overlap ? overlap_of(pair, cache, observer) : gap_of(pair, core);
    if constexpr (Observer::watches)
      observer([&] {
        return Advanced{static_cast<double>(fraction), static_cast<double>(gap.separation), Vec2d(core.on_a),
                        Vec2d(core.on_b)};
      });
    const real touching = 8 * (rounding_of(core.on_a, core.on_b) + rounding_of(way, {}));
    if (jump == 0 && gap.separation < -touching) return world_hit(pose_b, 0, gap, true);
    const real approach = -dot(gap.normal, way);
    if (approach <= 8 * epsilon * length(way)) return std::nullopt;
    if (gap.separation <= touching) return world_hit(pose_b, fraction, gap, jump == 0);
    const real next = fraction + gap.separation / approach;
    if (next > 1) return std::nullopt;
    if (next == fraction) break;
    fraction = next;
  }
  return world_hit(pose_b, fraction, gap, false);
}

template <typename Observer>
std::optional<CastHit> ray_cast(const Hull& hull, const Pose& pose, Vec2 from, Vec2 to, Observer observer) {
  Hull point;
  point.count = 1;
  return shape_cast(point, Pose{from, {}}, to - from, hull, pose, observer);
}

template std::optional<CastHit> shape_cast<NoObserver>(const Hull&, const Pose&, Vec2, const Hull&, const Pose&,
                                                       NoObserver);
template std::optional<CastHit> shape_cast<Observer>(const Hull&, const Pose&, Vec2, const Hull&, const Pose&,
                                                     Observer);
template std::optional<CastHit> ray_cast<NoObserver>(const Hull&, const Pose&, Vec2, Vec2, NoObserver);
template std::optional<CastHit> ray_cast<Observer>(const Hull&, const Pose&, Vec2, Vec2, Observer);

}  // namespace PROOFREEL_PRECISION
}  // namespace proofreel
