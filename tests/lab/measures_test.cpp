#include "lab/measures.h"

#include <catch2/catch.hpp>

#include "lab/peers/peers.h"
#include "tests/lab/lab_scenes.h"

namespace proofreel {
namespace {

using namespace test;

/// Bodies as they are at the start.
Snapshot snapshot_of(const Scene& scene) {
  Snapshot snapshot;
  make_simulation(scene)->observe(snapshot);
  return snapshot;
}

ContactView carrying(BodyId a, BodyId b) {
  ContactView contact;
  contact.a = a;
  contact.b = b;
  contact.point_count = 1;
  contact.points[0].normal_impulse = 1;
  return contact;
}

JointView joint_view(JointKind kind, Vec2d anchor_a, Vec2d anchor_b) {
  JointView view;
  view.kind = kind;
  view.anchor_a = anchor_a;
  view.anchor_b = anchor_b;
  return view;
}

TEST_CASE("Penetration is the depth of every overlap, also against the thinner body", "[measures]") {
  const Scene scene = scene_of({body_with(box_shape(1, 1), {0, 0.49}), body_with(box_shape(1, 0.2), {3, 0.07}),
                                body_with(box_shape(1, 1), {6, 2}), floor_body()});
  const Penetration found = penetration_of(snapshot_of(scene), {});
  REQUIRE(found.pairs == 2);
  REQUIRE(found.largest == Approx(0.03));
  REQUIRE(found.mean == Approx(0.02));
  REQUIRE(found.of_smaller == Approx(0.15));
  REQUIRE(found.largest_air == 0);
}

TEST_CASE("Air is told only between bodies that carry each other", "[measures]") {
  const Scene scene = scene_of({body_with(box_shape(1, 1), {0, 0.51}), body_with(box_shape(1, 1), {3, 0.52}),
                                body_with(disc_shape(0.5), {6, 0.5}), floor_body()});
  Snapshot snapshot = snapshot_of(scene);
  const auto ground = static_cast<BodyId>(4);
  snapshot.contacts = {carrying(static_cast<BodyId>(1), ground), carrying(static_cast<BodyId>(3), ground)};
  const Penetration found = penetration_of(snapshot, {});
  REQUIRE(found.pairs == 2);
  REQUIRE(found.largest == Approx(0).margin(1e-12));
  REQUIRE(found.largest_air == Approx(0.01));
  REQUIRE(found.mean_air == Approx(0.005));
}

TEST_CASE("Of two bodies with several shapes the deepest pair counts, once", "[measures]") {
  ShapeDef low = box_shape(1, 1);
  ShapeDef high = box_shape(1, 1);
  for (Vec2d& p : low.points) p += Vec2d{-1, -0.02};
  for (Vec2d& p : high.points) p += Vec2d{1, -0.01};
  BodyDef both = body_with(low, {0, 0.5});
  both.shapes.push_back(high);
  const auto fits = fit_of_pairs(snapshot_of(scene_of({both, floor_body()})), {}, 0.01);
  REQUIRE(fits.size() == 1);
  REQUIRE(fits[0].separation == Approx(-0.02));
  REQUIRE(fits[0].thickness == Approx(1));
}

TEST_CASE("What may overlap is no penetration: joints, filters, sensors, two fixed bodies", "[measures]") {
  Scene scene = scene_of({body_with(box_shape(1, 1), {0, 0}), body_with(box_shape(1, 1), {0.5, 0})});
  REQUIRE(penetration_of(snapshot_of(scene), {}).pairs == 1);
  SECTION("joints") {
    scene.joints = {joint_of(JointKind::revolute, {0, 0}, {-0.5, 0})};
    scene.joints[0].a = static_cast<BodyId>(2);
    REQUIRE(penetration_of(snapshot_of(scene), {}).pairs == 0);
  }
  SECTION("filters") {
    const FilterDef apart{-1, 1, ~std::uint64_t{0}};
    REQUIRE(penetration_of(snapshot_of(scene), {apart, apart}).pairs == 0);
    REQUIRE(penetration_of(snapshot_of(scene), {apart}).pairs == 1);
  }
  SECTION("sensors") {
    scene.bodies[0].sensor = true;
    REQUIRE(penetration_of(snapshot_of(scene), {}).pairs == 0);
  }
  SECTION("fixed bodies") {
    for (BodyDef& body : scene.bodies) body.type = BodyType::fixed;
    REQUIRE(penetration_of(snapshot_of(scene), {}).pairs == 0);
  }
}

TEST_CASE("A joint's gap is what its kind forbids", "[measures]") {
  REQUIRE(joint_gap(joint_view(JointKind::revolute, {1, 1}, {4, 5})) == Approx(5));
  REQUIRE(joint_gap(joint_view(JointKind::weld, {1, 1}, {4, 5})) == Approx(5));
  JointView rod = joint_view(JointKind::distance, {0, 0}, {3, 4});
  rod.length = 5.5;
  REQUIRE(joint_gap(rod) == Approx(0.5));
  rod.kind = JointKind::rope;
  REQUIRE(joint_gap(rod) == 0);
  rod.length = 4.5;
  REQUIRE(joint_gap(rod) == Approx(0.5));
  JointView slider = joint_view(JointKind::prismatic, {0, 0}, {3, 0.25});
  slider.axis = {1, 0};
  REQUIRE(joint_gap(slider) == Approx(0.25));
  REQUIRE(joint_gap(joint_view(JointKind::spring, {0, 0}, {3, 4})) == 0);
}

TEST_CASE("Joint gaps are averaged over the rigid joints", "[measures]") {
  Snapshot snapshot;
  snapshot.joints = {joint_view(JointKind::revolute, {0, 0}, {0.1, 0}), joint_view(JointKind::weld, {0, 0}, {0, 0}),
                     joint_view(JointKind::spring, {0, 0}, {9, 0})};
  REQUIRE(joint_gaps(snapshot).largest == Approx(0.1));
  REQUIRE(joint_gaps(snapshot).mean == Approx(0.05));
  REQUIRE(joint_gaps({}).mean == 0);
}

TEST_CASE("Our joints' own gaps are those measured from outside", "[measures]") {
  Scene scene = scene_of({body_with(disc_shape(0.1), {3, 4})});
  scene.joints = {joint_of(JointKind::distance, {0, 0}, {0, 0})};
  scene.joints[0].length = 4.5;
  const JointView view = snapshot_of(scene).joints[0];
  REQUIRE(joint_gap(view) == Approx(0.5));
  REQUIRE(view.gap == Approx(joint_gap(view)));
}

}  // namespace
}  // namespace proofreel
