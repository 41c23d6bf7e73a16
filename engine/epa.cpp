#include "engine/epa.h"

#include <utility>

namespace proofreel {
inline namespace PROOFREEL_PRECISION {

namespace {

/// The most corners a Minkowski difference has, and a few for what rounding makes of corners in a row.
constexpr int capacity = 2 * max_polygon_vertices + 8;

/// A corner of the polytope and the edge from it to the next corner.
struct PolytopeEdge {
  SimplexCorner start;
  Vec2 normal;        ///< unit, outward
  real distance = 0;  ///< of the edge's line to the origin, negative when that lies outside
};

/// Counter-clockwise.
struct Polytope {
  PolytopeEdge edges[capacity];
  int count = 0;
};

int after(const Polytope& p, int i) { return i + 1 < p.count ? i + 1 : 0; }
int before(const Polytope& p, int i) { return i > 0 ? i - 1 : p.count - 1; }

void measure_edge(Polytope& p, int i) {
  PolytopeEdge& edge = p.edges[i];
  edge.normal = -perp(normalized(p.edges[after(p, i)].start.difference - edge.start.difference));
  edge.distance = dot(edge.normal, edge.start.difference);
}

int closest_edge(const Polytope& p) {
  int best = 0;
  for (int i = 1; i < p.count; ++i) {
    if (p.edges[i].distance < p.edges[best].distance) best = i;
  }
  return best;
}

void erase(Polytope& p, int i) {
  --p.count;
  for (int k = i; k < p.count; ++k) p.edges[k] = p.edges[k + 1];
}

/// Whether the polytope turns left at a corner. Where it does not, the corner is not one any more.
bool turns_left(const Polytope& p, int i) {
  const Vec2 here = p.edges[i].start.difference;
  return cross(here - p.edges[before(p, i)].start.difference, p.edges[after(p, i)].start.difference - here) > 0;
}

/// Between true corners of B - A a new one leaves the polytope convex. But a simplex that was kept from an earlier pose
/// may hold points from inside B - A, and those vanish inside the polytope as soon as it has grown past them.
void insert_after(Polytope& p, int i, const SimplexCorner& corner) {
  int here = i + 1;
  for (int k = p.count++; k > here; --k) p.edges[k] = p.edges[k - 1];
  p.edges[here].start = corner;
  while (p.count > 3 && !turns_left(p, after(p, here))) {
    const int gone = after(p, here);
    erase(p, gone);
    if (gone < here) --here;
  }
  while (p.count > 3 && !turns_left(p, before(p, here))) {
    const int gone = before(p, here);
    erase(p, gone);
    if (gone < here) --here;
  }
  measure_edge(p, before(p, here));
  measure_edge(p, here);
}

/// The corners to start with: those of GJK's simplex and, where it has fewer than three, others that span an area.
class Start {
 public:
  Start(const HullPair& pair, const SimplexCache& simplex) : pair_(pair) {
    for (; count < simplex.count; ++count) corners[count] = simplex_corner(pair, simplex.a[count], simplex.b[count]);
    for (int i = 0; i < pair.a.count; ++i) rounding = std::max(rounding, rounding_of(pair.a.points[i], {}));
    for (int i = 0; i < pair.b.count; ++i) rounding = std::max(rounding, rounding_of({}, pair.b_points[i]));
    drop_flat();
    if (count == 1) widen_point();
    if (count == 2) widen_segment();
    const Vec2 p = corners[0].difference;
    if (count == 3 && cross(corners[1].difference - p, corners[2].difference - p) < 0)
      std::swap(corners[1], corners[2]);
  }

  SimplexCorner corners[3];
  int count = 0;
  real rounding = 0;  ///< what coordinates may be off by, metres

 private:
  /// Forgets corners that coincide or lie on a line, to rounding.
  void drop_flat() {
    const Vec2 edge = corners[1].difference - corners[0].difference;
    const real size = length(edge);
    if (count == 3 && std::abs(cross(edge, corners[2].difference - corners[0].difference)) <= rounding * size)
      count = 2;
    if (count == 2 && size <= rounding) count = 1;
  }

  void widen_point() {
    for (const Vec2 direction : {Vec2{1, 0}, Vec2{-1, 0}, Vec2{0, 1}, Vec2{0, -1}}) {
      if (add_if_beyond(direction)) return;
    }
  }

  void widen_segment() {
    const Vec2 across = perp(normalized(corners[1].difference - corners[0].difference));
    if (!add_if_beyond(across)) add_if_beyond(-across);
  }

  /// Adds the farthest corner along a unit direction unless the first one is as far.
  bool add_if_beyond(Vec2 direction) {
    const SimplexCorner found = support(pair_, direction);
    if (dot(direction, found.difference - corners[0].difference) <= rounding) return false;
    corners[count++] = found;
    return true;
  }

  const HullPair& pair_;
};

/// The origin is on a difference that is a segment or a point.
Penetration flat_penetration(const HullPair& pair, const Start& start) {
  Penetration result;
  result.normal = {0, 1};
  if (start.count == 2) result.normal = perp(normalized(start.corners[1].difference - start.corners[0].difference));
  result.on_a = pair.a.points[start.corners[0].a];
  result.on_b = to_world(pair.b_in_a, pair.b.points[start.corners[0].b]);
  if (start.count == 1) return result;
  const Vec2 edge = start.corners[1].difference - start.corners[0].difference;
  const real t = std::clamp(-dot(start.corners[0].difference, edge) / dot(edge, edge), real(0), real(1));
  result.on_a = lerp(result.on_a, pair.a.points[start.corners[1].a], t);
  result.on_b = lerp(result.on_b, to_world(pair.b_in_a, pair.b.points[start.corners[1].b]), t);
  return result;
}

/// The way out across an edge leads against its normal: B - A has to move away from the origin on that side.
void leave_across(const HullPair& pair, const PolytopeEdge& from, const PolytopeEdge& to, Penetration& result) {
  const Vec2 edge = to.start.difference - from.start.difference;
  const real t = std::clamp(-dot(from.start.difference, edge) / dot(edge, edge), real(0), real(1));
  result.normal = -from.normal;
  result.depth = std::max(from.distance, real(0));
  result.on_a = lerp(pair.a.points[from.start.a], pair.a.points[to.start.a], t);
  result.on_b = lerp(pair.b_points[from.start.b], pair.b_points[to.start.b], t);
}

}  // namespace

template <typename Observer>
Penetration core_penetration(const HullPair& pair, const SimplexCache& simplex, Observer observer) {
  const Start start(pair, simplex);
  if (start.count < 3) return flat_penetration(pair, start);
  Polytope polytope;
  for (; polytope.count < 3; ++polytope.count) polytope.edges[polytope.count].start = start.corners[polytope.count];
  for (int i = 0; i < 3; ++i) measure_edge(polytope, i);

  Penetration result;
  for (;;) {
    const int closest = closest_edge(polytope);
    const PolytopeEdge& edge = polytope.edges[closest];
    const PolytopeEdge& next = polytope.edges[after(polytope, closest)];
    if constexpr (Observer::watches)
      observer([&] {
        return ClosestEdge{Vec2d(edge.start.difference), Vec2d(next.start.difference), Vec2d(edge.normal),
                           static_cast<double>(edge.distance)};
      });
    const SimplexCorner corner = support(pair, edge.normal);
    ++result.iterations;
    const real gain = dot(edge.normal, corner.difference) - edge.distance;
    if (gain <= start.rounding || same(corner, next.start) || result.iterations == capacity) {
      leave_across(pair, edge, next, result);
      return result;
    }
    insert_after(polytope, closest, corner);
    if constexpr (Observer::watches) observer([&] { return PolytopeExpanded{Vec2d(corner.difference)}; });
  }
}

template Penetration core_penetration<NoObserver>(const HullPair&, const SimplexCache&, NoObserver);
template Penetration core_penetration<Observer>(const HullPair&, const SimplexCache&, Observer);

}  // namespace PROOFREEL_PRECISION
}  // namespace proofreel
