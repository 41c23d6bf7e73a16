#include <catch2/catch.hpp>

#include "scene_text.h"

using namespace proofreel;

namespace {

std::vector<JointDef> joints_of(const std::string& text) {
  return load_text("scenario{}\nlocal b = body{at={3,0}, angle=math.pi/2, shape=circle{radius=1}}\n" + text)
      ->scene.joints;
}

}  // namespace

TEST_CASE("World points become points of the bodies") {
  const JointDef j = joints_of("revolute{world, b, at={3, 1}}").at(0);
  CHECK(j.kind == JointKind::revolute);
  CHECK(j.a == BodyId::world);
  CHECK(j.b == static_cast<BodyId>(1));
  CHECK(j.anchor_a == Vec2d{3, 1});
  CHECK(j.anchor_b.x == Approx(1));
  CHECK(j.anchor_b.y == Approx(0).margin(1e-15));
}

TEST_CASE("Lengths default to the distance now") {
  CHECK(joints_of("distance{world, b, from={0,0}, to={3,4}}").at(0).length == 5);
  CHECK(joints_of("distance{world, b, from={0,0}, to={3,4}, length=2}").at(0).length == 2);
  const JointDef spring = joints_of("spring{world, b, from={0,0}, to={3,4}, stiffness=10, damping=0.5}").at(0);
  CHECK(spring.kind == JointKind::spring);
  CHECK(spring.length == 5);
  CHECK(spring.stiffness == 10);
  CHECK(spring.damping == 0.5);
}

TEST_CASE("Joints made in callbacks use where the bodies are then") {
  FakeRun r(R"(
    scenario{duration=1, rate=100, fps=50}
    local b = body{velocity={10, 0}, shape=circle{radius=1}}
    at(0.1, function() revolute{world, b, at={0, 0}} end))");
  r.until(11);
  CHECK(std::get<CreateJoint>(r.simulation->log.at(0)).def.anchor_b.x == Approx(-1));
}

TEST_CASE("Joints tell their gap and reaction, and can be removed") {
  FakeRun r(R"(
    scenario{duration=1, rate=100, fps=50}
    local b = body{shape=circle{radius=1}}
    local j = revolute{world, b, at={0, 0}}
    measure('gap', function() return j:gap() end)
    measure('reaction', function() return j:reaction().y end))");
  CHECK(r.measure(0) == 0.25);
  CHECK(r.measure(1) == 4);
  FakeRun removed(
      "scenario{}\nlocal b = body{shape=circle{radius=1}}\nlocal j = revolute{world, b, at={0,0}}\n"
      "at(0, function() j:remove() end)");
  removed.until(1);
  CHECK_FALSE(removed.simulation->exists(JointId{0}));
}

TEST_CASE("The gap can be asked for while loading") {
  CHECK(value_of("j:gap()", "b = body{shape=circle{radius=1}}\nj = revolute{world, b, at={0,0}}") == 0);
}
