// Polygons, poses, casts and trees out of arbitrary bytes. Whatever they are: no crash, no endless loop, and no answer
// that is not a number; what a scenario may not hand in is refused with a sentence.

#include <cstdio>
#include <cstdlib>
#include <vector>

#include "engine/cast.h"
#include "engine/collide.h"
#include "engine/collide_gjk.h"
#include "engine/decompose.h"
#include "engine/dynamic_tree.h"
#include "engine/outline.h"
#include "engine/polygon.h"
#include "engine/seam.h"
#include "engine/simulation.h"
#include "engine/time_of_impact.h"
#include "tests/fuzz/bytes.h"

namespace proofreel::fuzz {
namespace {

void require(bool holds, const char* claim) {
  if (holds) return;
  std::fprintf(stderr, "It does not hold that %s.\n", claim);
  std::abort();
}

bool finite(Vec2 v) { return is_finite(v); }

// From bytes to shapes.

std::vector<Vec2d> corners_from(Bytes& bytes) {
  std::vector<Vec2d> corners;
  const int count = bytes.below(24);
  for (int i = 0; i < count; ++i) corners.push_back(bytes.vector());
  return corners;
}

void check_parts(const std::vector<Vec2d>& outline, const ConvexParts& parts) {
  double area = 0;
  for (const std::vector<Vec2d>& part : parts) {
    require(is_convex(part), "the parts of a polygon are convex");
    require(part.size() <= max_polygon_vertices, "a part has no more corners than a shape may have");
    area += area_of(part);
  }
  const double whole = area_of(outline);
  require(std::abs(area - whole) <= 1e-6 * whole, "the parts of a polygon have its area");
}

/// The convex parts of a polygon; none when it is refused.
std::vector<ShapeDef> polygon_from(Bytes& bytes) {
  std::vector<Vec2d> corners = corners_from(bytes);
  if (bytes.below(2) == 0) corners = convex_hull(corners);
  const auto cleaned = clean_polygon(corners);
  if (const auto* sentence = std::get_if<std::string>(&cleaned)) {
    require(!sentence->empty(), "a refusal says why");
    return {};
  }
  const auto& outline = std::get<std::vector<Vec2d>>(cleaned);
  const auto cut = convex_parts(outline);
  if (const auto* sentence = std::get_if<std::string>(&cut)) {
    require(!sentence->empty(), "a refusal says why");
    return {};
  }
  check_parts(outline, std::get<ConvexParts>(cut));
  std::vector<ShapeDef> shapes;
  for (const std::vector<Vec2d>& part : std::get<ConvexParts>(cut)) shapes.emplace_back().points = part;
  return shapes;
}

std::vector<ShapeDef> shapes_from(Bytes& bytes) {
  const int kind = bytes.below(4);
  if (kind > 1) {
    std::vector<ShapeDef> shapes = polygon_from(bytes);
    if (kind == 3 && shapes.size() == 1) shapes[0].radius = std::abs(bytes.number());
    return shapes;
  }
  ShapeDef shape;
  for (int i = 0; i <= kind; ++i) shape.points.push_back(bytes.vector());
  shape.radius = std::abs(bytes.number());
  return {shape};
}

/// The hulls of a body that may take part, and nothing of one that may not.
std::vector<Hull> hulls_from(Bytes& bytes) {
  BodyDef body;
  body.type = BodyType::fixed;
  body.shapes = shapes_from(bytes);
  if (problem_with(body)) return {};
  std::vector<Hull> hulls;
  for (const ShapeDef& shape : body.shapes) hulls.push_back(make_hull(shape, {0, 0}));
  return hulls;
}

bool usable(Vec2d v) { return is_finite(v) && std::abs(v.x) < 1e9 && std::abs(v.y) < 1e9; }

Vec2 place_from(Bytes& bytes) {
  const Vec2d place = bytes.vector();
  return usable(place) ? Vec2(place) : Vec2{};
}

real angle_from(Bytes& bytes) {
  const double angle = bytes.number();
  return std::isfinite(angle) && std::abs(angle) < 1e6 ? static_cast<real>(angle) : real(0);
}

Pose pose_from(Bytes& bytes) {
  const Vec2 place = place_from(bytes);
  return {place, Rot(angle_from(bytes))};
}

// What must hold of the answers.

void check(const Manifold& m) {
  require(m.count >= 0 && m.count <= 2, "a manifold has at most two points");
  if (m.count == 0) return;
  require(std::abs(length(m.normal) - real(1)) < real(1e-3), "a normal is a unit vector");
  for (int i = 0; i < m.count; ++i) {
    require(finite(m.points[i].point) && std::isfinite(m.points[i].separation), "a contact point is finite");
  }
}

void check_pair(const Hull& a, const Pose& pose_a, const Hull& b, const Pose& pose_b, Bytes& bytes) {
  const real margin = std::min(std::abs(angle_from(bytes)), real(10));
  check(collide(a, pose_a, b, pose_b, margin));
  check(collide_gjk(a, pose_a, b, pose_b, margin));
  const DistanceResult d = distance(a, pose_a, b, pose_b);
  require(std::isfinite(d.separation) && finite(d.on_a) && finite(d.on_b), "a distance is finite");
  const Vec2 way = place_from(bytes);
  for (const auto& hit :
       {shape_cast(a, pose_a, way, b, pose_b), ray_cast(b, pose_b, pose_a.position, pose_a.position + way)}) {
    if (!hit) continue;
    require(hit->fraction >= 0 && hit->fraction <= 1, "a cast hits between start and end");
    require(finite(hit->point) && finite(hit->normal), "a cast's hit is finite");
  }
  const Sweep sweep_a{pose_a, way, angle_from(bytes)};
  const Sweep sweep_b{pose_b, place_from(bytes), angle_from(bytes)};
  const TimeOfImpact impact = time_of_impact(a, sweep_a, b, sweep_b, 0, real(1e-3));
  require(impact.fraction >= 0 && impact.fraction <= 1, "an impact lies between start and end");
}

void fuzz_shapes(Bytes& bytes) {
  const std::vector<Hull> a = hulls_from(bytes);
  const std::vector<Hull> b = hulls_from(bytes);
  const Pose pose_a = pose_from(bytes);
  const Pose pose_b = pose_from(bytes);
  for (std::size_t i = 0; i < a.size(); ++i) {
    for (const Hull& other : b) check_pair(a[i], pose_a, other, pose_b, bytes);
    Seam seam;
    find_seam(a[i], std::span(a).subspan(i + 1), seam);
  }
}

void fuzz_tree(Bytes& bytes) {
  DynamicTree tree;
  std::vector<ProxyId> leaves;
  while (!bytes.empty()) {
    const Vec2 low = place_from(bytes);
    const Vec2 size = place_from(bytes);
    const Aabb box{low, low + Vec2{std::abs(size.x), std::abs(size.y)}};
    const int what = leaves.empty() ? 0 : bytes.below(6);
    const std::size_t which = leaves.empty() ? 0 : static_cast<std::size_t>(bytes.byte()) % leaves.size();
    if (what <= 1) leaves.push_back(tree.insert(box, static_cast<std::uint32_t>(leaves.size())));
    if (what == 2) tree.move(leaves[which], box);
    if (what == 3) {
      tree.remove(leaves[which]);
      leaves.erase(leaves.begin() + static_cast<std::ptrdiff_t>(which));
    }
    if (what == 4) tree.query(box, [](ProxyId, std::uint32_t) { return true; });
    if (what == 5) tree.rebuild();
    require(tree.validate(), "a tree is sound after every change");
  }
  std::size_t pairs = 0;
  tree.for_each_pair([&](ProxyId, ProxyId) { ++pairs; });
  require(pairs <= leaves.size() * leaves.size(), "no pair is found twice");
}

}  // namespace
}  // namespace proofreel::fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  proofreel::fuzz::Bytes bytes({data, size});
  if (bytes.below(4) == 0) {
    proofreel::fuzz::fuzz_tree(bytes);
  } else {
    proofreel::fuzz::fuzz_shapes(bytes);
  }
  return 0;
}
