#include "engine/gjk.h"

#include <cmath>

namespace proofreel {
inline namespace PROOFREEL_PRECISION {

namespace {

constexpr int most_iterations = 64;

/// Of one corner p (and q the same); or of two with the origin's foot between them; or of three with the origin inside.
/// Members instead of an array: so the compiler keeps it all in registers.
struct Simplex {
  SimplexCorner p;
  SimplexCorner q;
  SimplexCorner r;
  real side = 1;  ///< 1 when the origin is to the left of the way from p to q, -1 when it is to the right
  int count = 0;
};

/// Keeps of the two corners what is nearest the origin.
void reduce_two(Simplex& s) {
  const Vec2 p = s.p.difference;
  const Vec2 q = s.q.difference;
  const Vec2 edge = q - p;
  s.count = 1;
  if (dot(p, edge) >= 0) {
    s.q = s.p;
    return;
  }
  if (dot(q, edge) <= 0) {
    s.p = s.q;
    return;
  }
  s.count = 2;
  s.side = std::copysign(real(1), cross(p, q));  // a factor, not a branch: nobody could predict it
}

/// The third corner was found looking from the other two towards the origin, whose foot lies between those two: so
/// only the third itself, the two edges at it and the inside can be nearest.
void reduce_three(Simplex& s) {
  const Vec2 p = s.p.difference;
  const Vec2 q = s.q.difference;
  const Vec2 r = s.r.difference;
  const bool outside_qr = s.side * cross(q, r) < 0;
  const bool outside_rp = s.side * cross(r, p) < 0;
  s.count = 2;
  if (outside_qr && dot(r - q, r) > 0) {
    s.p = s.r;
  } else if (outside_rp && dot(r - p, r) > 0) {
    s.q = s.r;
  } else if (outside_qr || outside_rp) {
    s.p = s.r;
    s.q = s.r;
    s.count = 1;
  } else {
    s.count = 3;
  }
}

void add(Simplex& s, const SimplexCorner& corner) {
  if (s.count == 1) {
    s.q = corner;
    reduce_two(s);
  } else {
    s.r = corner;
    reduce_three(s);
  }
}

/// From the origin to the simplex, square to it. An edge's own perpendicular stays exact when the origin comes near it.
Vec2 away_from_origin(const Simplex& s) {
  return s.count == 1 ? s.p.difference : -s.side * perp(s.q.difference - s.p.difference);
}

bool encloses_origin(const Simplex& s) {
  const Vec2 p = s.p.difference;
  const Vec2 q = s.q.difference;
  const Vec2 r = s.r.difference;
  const real area = cross(q - p, r - p);
  return area * cross(p, q) >= 0 && area * cross(q, r) >= 0 && area * cross(r, p) >= 0 && area != 0;
}

/// Any simplex will do as a start, so what does not enclose the origin any more may lose a corner.
Simplex start(const HullPair& pair, const SimplexCache& cache) {
  Simplex s;
  s.count = 1;
  s.p = cache.count == 0 ? support(pair, -pair.b_in_a.position) : simplex_corner(pair, cache.a[0], cache.b[0]);
  s.q = s.p;
  if (cache.count <= 1) return s;
  s.q = simplex_corner(pair, cache.a[1], cache.b[1]);
  if (cache.count == 3) {
    s.r = simplex_corner(pair, cache.a[2], cache.b[2]);
    s.count = 3;
    if (encloses_origin(s)) return s;
  }
  reduce_two(s);
  return s;
}

void store(const Simplex& s, SimplexCache& cache) {
  const auto byte = [](int i) { return static_cast<std::uint8_t>(i); };
  cache = {byte(s.count), {byte(s.p.a), byte(s.q.a), byte(s.r.a)}, {byte(s.p.b), byte(s.q.b), byte(s.r.b)}};
}

/// Where on the edge the origin's foot is: 0 at p, 1 at q.
real foot_on_edge(const Simplex& s) {
  if (s.count == 1) return 0;
  const Vec2 edge = s.q.difference - s.p.difference;
  return std::clamp(-dot(s.p.difference, edge) / dot(edge, edge), real(0), real(1));
}

/// The nearest points, and the distance along the square to the simplex. Where an edge is shorter than the distance,
/// the line between the nearest points gives the direction more exactly than the edge does.
void measure(const HullPair& pair, const Simplex& s, real rounding, CoreDistance& result) {
  const real t = foot_on_edge(s);
  result.on_a = lerp(pair.a.points[s.p.a], pair.a.points[s.q.a], t);
  result.on_b = lerp(pair.b_points[s.p.b], pair.b_points[s.q.b], t);
  const Vec2 between = result.on_b - result.on_a;
  Vec2 away = away_from_origin(s);
  if (length_squared(between) > length_squared(away)) away = between;
  const real size = length(away);
  const real along = dot(away, between);
  if (along <= rounding * size) return;
  result.overlap = false;
  result.distance = along / size;
  result.normal = (real(1) / size) * away;
}

SupportFound support_event(const HullPair& pair, Vec2 direction, const SimplexCorner& found) {
  return {Vec2d(direction), Vec2d(pair.a.points[found.a]), Vec2d(pair.b_points[found.b]), Vec2d(found.difference)};
}

SimplexReduced reduced_event(const Simplex& s) {
  SimplexReduced event{{Vec2d(s.p.difference), Vec2d(s.q.difference), Vec2d(s.r.difference)}, s.count, {}};
  if (s.count < 3) event.closest = Vec2d(lerp(s.p.difference, s.q.difference, foot_on_edge(s)));
  return event;
}

}  // namespace

template <typename Observer>
CoreDistance core_distance(const HullPair& pair, SimplexCache& cache, Observer observer) {
  Simplex s = start(pair, cache);
  const real rounding = rounding_of(pair.a.points[s.p.a], pair.b_points[s.p.b]);
  CoreDistance result;
  if constexpr (Observer::watches) observer([&] { return reduced_event(s); });
  while (s.count < 3 && result.iterations < most_iterations) {
    const Vec2 away = away_from_origin(s);
    const SimplexCorner next = support(pair, -away);
    ++result.iterations;
    if constexpr (Observer::watches) observer([&] { return support_event(pair, -away, next); });
    const real gain = dot(away, s.p.difference - next.difference);
    if (same(next, s.q) || gain <= rounding * (std::abs(away.x) + std::abs(away.y))) break;
    add(s, next);
    if constexpr (Observer::watches) observer([&] { return reduced_event(s); });
  }
  store(s, cache);
  if (s.count < 3) measure(pair, s, rounding, result);
  if constexpr (Observer::watches)
    observer([&] {
      return DistanceFound{Vec2d(result.on_a), Vec2d(result.on_b), static_cast<double>(result.distance),
                           result.iterations};
    });
  return result;
}

template <typename Observer>
DistanceResult distance(const Hull& a, const Pose& pose_a, const Hull& b, const Pose& pose_b, SimplexCache& cache,
                        Observer observer) {
  const CoreDistance core = core_distance({a, b, relative_pose(pose_a, pose_b)}, cache, observer);
  DistanceResult result;
  result.separation = core.distance - a.radius - b.radius;
  result.cores_overlap = core.overlap;
  result.iterations = core.iterations;
  if (core.overlap) return result;
  result.on_a = rotate(pose_a.rotation, core.on_a + a.radius * core.normal);
  result.on_b = rotate(pose_a.rotation, core.on_b - b.radius * core.normal);
  result.normal = rotate(pose_a.rotation, core.normal);
  return result;
}

DistanceResult distance(const Hull& a, const Pose& pose_a, const Hull& b, const Pose& pose_b) {
  SimplexCache cache;
  return distance(a, pose_a, b, pose_b, cache);
}

template CoreDistance core_distance<NoObserver>(const HullPair&, SimplexCache&, NoObserver);
template CoreDistance core_distance<Observer>(const HullPair&, SimplexCache&, Observer);
template DistanceResult distance<NoObserver>(const Hull&, const Pose&, const Hull&, const Pose&, SimplexCache&,
                                             NoObserver);
template DistanceResult distance<Observer>(const Hull&, const Pose&, const Hull&, const Pose&, SimplexCache&, Observer);

}  // namespace PROOFREEL_PRECISION
}  // namespace proofreel
