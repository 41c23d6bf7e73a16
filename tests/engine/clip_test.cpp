#include "engine/clip.h"

#include <catch2/catch.hpp>

#include "engine/collide.h"
#include "tests/engine/scenes.h"

using namespace proofreel;
using namespace proofreel::test;

namespace {

/// The top of a box four metres wide.
const Face floor_top{{2, 0}, {-2, 0}, {0, 1}};

}  // namespace

TEST_CASE("What hangs over the end of the reference face is cut off", "[clip]") {
  const Face bottom{{1, real(-0.1)}, {3, real(-0.1)}, {0, -1}};
  const Manifold m = clip(floor_top, 0, bottom, 0, 0, 0);
  REQUIRE(m.count == 2);
  CHECK(m.points[0].point.x == Approx(2));
  CHECK(m.points[1].point.x == Approx(1));
  CHECK(m.points[0].point.y == Approx(-0.05));
  CHECK(m.points[0].separation == Approx(-0.1));
}

TEST_CASE("A cut end keeps the slope of the incident face", "[clip]") {
  const Face slope{{1, 0}, {3, real(0.5)}, normalized(Vec2{real(0.5), -2})};
  const Manifold m = clip(floor_top, 0, slope, 0, 1, 0);
  REQUIRE(m.count == 2);
  CHECK(m.points[0].separation == Approx(0.25));
  CHECK(m.points[1].separation == Approx(0).margin(1e-7));
}

TEST_CASE("Points farther away than the margin are left out", "[clip]") {
  const Face slope{{1, 0}, {2, 1}, normalized(Vec2{1, -1})};
  const Manifold m = clip(floor_top, 0, slope, 0, real(0.5), 6);
  REQUIRE(m.count == 1);
  CHECK(m.points[0].separation == Approx(0).margin(1e-7));
  CHECK(m.points[0].feature == 7);
}

TEST_CASE("A face beyond the side planes leaves nothing", "[clip]") {
  CHECK(clip(floor_top, 0, {{3, 0}, {4, 0}, {0, -1}}, 0, 1, 0).count == 0);
  CHECK(clip(floor_top, 0, {{-4, 0}, {-3, 0}, {0, -1}}, 0, 1, 0).count == 0);
}

TEST_CASE("Radii bring surfaces nearer and keep the point midway", "[clip]") {
  const Face bottom{{-1, 1}, {1, 1}, {0, -1}};
  const Manifold m = clip(floor_top, real(0.5), bottom, real(0.25), 1, 0);
  REQUIRE(m.count == 2);
  CHECK(m.points[0].separation == Approx(0.25));
  CHECK(m.points[0].point.y == Approx(0.625));
}

TEST_CASE("Coincident points part along the fallback by the sum of the radii", "[clip]") {
  const Manifold m = collide_points({1, 1}, {1, 1}, real(0.5), real(0.25), {0, 1}, 0, 0);
  REQUIRE(m.count == 1);
  CHECK(m.normal == Vec2{0, 1});
  CHECK(m.points[0].separation == Approx(-0.75));
}

TEST_CASE("The incident edge is the one that lies most against the normal", "[clip]") {
  const Hull box = make_hull(box_shape(2, 2), {});
  const Vec2 up{real(0.1), 1};
  CHECK(box.normals[incident_edge(box, up)] == Vec2{0, -1});
  CHECK(box.normals[incident_edge(box, Vec2{1, real(0.1)})] == Vec2{-1, 0});
}

TEST_CASE("Flipping a manifold turns its normal and keeps its points", "[clip]") {
  Manifold m = collide_points({0, 0}, {1, 0}, 1, 1, {0, 1}, 0, 3);
  const Manifold before = m;
  flip(m);
  CHECK(m.normal == -before.normal);
  CHECK(m.points[0].point == before.points[0].point);
  CHECK(m.points[0].feature == 3);
}

namespace {

struct Seen {
  std::vector<AxisTested> axes;
  std::vector<AxisChosen> chosen;
  std::vector<FacesChosen> faces;
  std::vector<PointClipped> points;
  Manifold manifold;
};

Seen watched(const ShapeDef& a, const Pose& pose_a, const ShapeDef& b, const Pose& pose_b) {
  Seen seen;
  const Observer observer([&](const Event& event) {
    if (const auto* axis = std::get_if<AxisTested>(&event)) seen.axes.push_back(*axis);
    if (const auto* chosen = std::get_if<AxisChosen>(&event)) seen.chosen.push_back(*chosen);
    if (const auto* faces = std::get_if<FacesChosen>(&event)) seen.faces.push_back(*faces);
    if (const auto* point = std::get_if<PointClipped>(&event)) seen.points.push_back(*point);
  });
  seen.manifold = collide(make_hull(a, {}), pose_a, make_hull(b, {}), pose_b, 0, observer);
  return seen;
}

}  // namespace

TEST_CASE("An observer sees every axis with both intervals, the one chosen, the faces and the points", "[collide]") {
  const Seen seen = watched(box_shape(4, 2), {}, box_shape(2, 2), {{1, real(1.9)}, {}});
  REQUIRE(seen.axes.size() == 8);
  for (const AxisTested& axis : seen.axes) {
    const double gap = axis.of_a ? axis.interval_b[0] - axis.interval_a[1] : axis.interval_a[0] - axis.interval_b[1];
    CHECK(gap == Approx(axis.separation).margin(1e-6));
    CHECK(axis.separation <= seen.chosen.at(0).separation + 1e-6);
  }
  REQUIRE(seen.chosen.size() == 1);
  CHECK(seen.chosen[0].axis.y == Approx(1));
  CHECK(seen.chosen[0].separation == Approx(-0.1));
  REQUIRE(seen.faces.size() == 1);
  CHECK(seen.faces[0].reference_of_a);
  CHECK(seen.faces[0].incident_a.y == Approx(0.9));
  REQUIRE(seen.points.size() == 2);
  CHECK(seen.points[0].kept);
  CHECK(seen.points[0].separation == Approx(static_cast<double>(seen.manifold.points[0].separation)));
}

TEST_CASE("Shapes that one of A's axes separates are not tested on B's", "[collide]") {
  const Seen seen = watched(box_shape(2, 2), {}, box_shape(2, 2), {{5, 0}, {}});
  CHECK(seen.axes.size() == 4);
  CHECK(seen.chosen.empty());
  CHECK(seen.manifold.count == 0);
}

TEST_CASE("Watching changes no bit of a manifold", "[collide]") {
  const Pose pose{{real(0.9), real(1.1)}, Rot(real(0.4))};
  const Seen seen = watched(box_shape(4, 2), {}, box_shape(1, 1), pose);
  const Manifold plain = collide(make_hull(box_shape(4, 2), {}), {}, make_hull(box_shape(1, 1), {}), pose, 0);
  REQUIRE(seen.manifold.count == plain.count);
  CHECK(seen.manifold.normal == plain.normal);
  for (int k = 0; k < plain.count; ++k) {
    CHECK(seen.manifold.points[k].point == plain.points[k].point);
    CHECK(seen.manifold.points[k].separation == plain.points[k].separation);
  }
}
