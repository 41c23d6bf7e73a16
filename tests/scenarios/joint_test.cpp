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

TEST_CASE("Joints are not held from beyond the world") {
  using Catch::Contains;
  const std::string scene = "scenario{}\nlocal b = body{shape=circle{radius=1}}\n";
  CHECK_THAT(error_of(scene + "drag_to{b, target={1e300, 0}, max_force=1}"),
             Contains("line 3: drag_to: target must lie within 1e9 m of the origin"));
  CHECK_THAT(error_of(scene + "revolute{world, b, at={1, 1e300}}"), Contains("at must lie within 1e9 m of the origin"));
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

TEST_CASE("Limits and motors are read with their joint") {
  const JointDef hinge =
      joints_of("revolute{world, b, at={3,0}, limits={-1, 2}, motor={speed=3, max_torque=4}, break_force=5}").at(0);
  CHECK(hinge.limits->lower == -1);
  CHECK(hinge.limits->upper == 2);
  CHECK(hinge.motor->speed == 3);
  CHECK(hinge.motor->strongest == 4);
  CHECK(hinge.break_force == 5);
  const JointDef rail = joints_of("prismatic{b, world, at={3,0}, axis={0,2}, motor={speed=-1, max_force=7}}").at(0);
  CHECK(rail.axis.x == Approx(1));  // b is turned by a quarter
  CHECK(rail.axis.y == Approx(0).margin(1e-15));
  CHECK(rail.motor->strongest == 7);
  CHECK_FALSE(rail.limits);
}

TEST_CASE("Every kind of joint reads its keys") {
  const std::string other = "local c = body{at={5,0}, shape=circle{radius=1}}\n";
  const JointDef weld = joints_of(other + "weld{b, c, break_force=9}").at(0);
  CHECK(weld.kind == JointKind::weld);
  CHECK(weld.anchor_b.x == Approx(-1));  // midway between the centres
  const JointDef wheel = joints_of("wheel{world, b, at={3,0}, axis={0,1}, stiffness=100, damping=2}").at(0);
  CHECK(wheel.axis == Vec2d{0, 1});
  CHECK(wheel.stiffness == 100);
  CHECK(wheel.damping == 2);
  const JointDef rope = joints_of("rope{world, b, from={0,0}, to={3,0}, length=4}").at(0);
  CHECK(rope.kind == JointKind::rope);
  CHECK(rope.length == 4);
  const JointDef pulley =
      joints_of(other + "pulley{b, c, from_a={3,4}, from_b={5,4}, to_a={3,1}, to_b={5,1}, ratio=2}").at(0);
  CHECK(pulley.pin_b == Vec2d{5, 4});
  CHECK(pulley.anchor_b == Vec2d{0, 1});
  CHECK(pulley.ratio == 2);
  const JointDef pull = joints_of("drag_to{b, target={7,8}, max_force=3}").at(0);
  CHECK(pull.b == static_cast<BodyId>(1));
  CHECK(pull.target == Vec2d{7, 8});
  CHECK(pull.anchor_b == Vec2d{0, 0});
  const JointDef motor = joints_of("motor{world, b, velocity={1,2}, max_force=3, speed=4, max_torque=5}").at(0);
  CHECK(motor.velocity == Vec2d{1, 2});
  CHECK(motor.max_force == 3);
  CHECK(motor.motor->speed == 4);
  CHECK(motor.motor->strongest == 5);
}

TEST_CASE("A gear names two joints, and goes with either of them") {
  const std::string text =
      "local c = body{at={5,0}, shape=circle{radius=1}}\n"
      "local j = revolute{world, b, at={3,0}} local k = prismatic{world, c, at={5,0}, axis={1,0}}\n"
      "local g = gear{j, k, ratio=-2}\n";
  const JointDef gear = joints_of(text).at(2);
  CHECK(gear.first == JointId{0});
  CHECK(gear.second == JointId{1});
  CHECK(gear.ratio == -2);
  CHECK_THAT(error_of("scenario{}\nlocal b = body{at={3,0}, shape=circle{radius=1}}\n" + text + "j:remove() g:gap()"),
             Catch::Contains("joint 2 was removed"));
}

TEST_CASE("What a joint cannot be is refused with a sentence") {
  const auto [line, problem] = GENERATE(table<std::string, std::string>({
      {"revolute{world, b}", "revolute needs at="},
      {"revolute{world, b, at={0,0}, limits={1, -1}}", "limits must be {lowest, highest}, and the first is above"},
      {"revolute{world, b, at={0,0}, limits=3}", "limits must be {lowest, highest}"},
      {"revolute{world, b, at={0,0}, limits={0/0, 1}}", "limits must be finite"},
      {"revolute{world, b, at={0,0}, motor={speed=1}}", "revolute: motor needs max_torque="},
      {"revolute{world, b, at={0,0}, motor={max_torque=1}}", "revolute: motor needs speed="},
      {"revolute{world, b, at={0,0}, motor={speed=1, max_force=1}}", "unknown key \"max_force\""},
      {"revolute{world, b, at={0,0}, motor={speed=1, max_torque=-1}}", "max_torque must be"},
      {"revolute{world, b, at={0,0}, break_force=0}", "break_force must be"},
      {"prismatic{world, b, at={0,0}}", "prismatic needs axis="},
      {"prismatic{world, b, at={0,0}, axis={0,0}}", "axis must have a direction"},
      {"prismatic{world, b, at={0,0}, axis={1,0}, motor={speed=1, max_torque=1}}", "unknown key \"max_torque\""},
      {"weld{world, world}", "weld joins body \"world\" to itself"},
      {"weld{world, b, break_force=0/0}", "break_force must be"},
      {"wheel{world, b, at={0,0}, axis={0,1}}", "wheel needs stiffness="},
      {"wheel{world, b, at={0,0}, axis={0,1}, stiffness=1, damping=-1}", "damping must"},
      {"rope{world, b, from={0,0}, to={0,0}}", "rope: from and to are the same point; give length="},
      {"rope{world, b, from={0,0}, to={1,0}, length=-1}", "length must be"},
      {"gear{b, b}", "gear{j1, j2, ...}: j1 must be a joint"},
      {"local j = weld{world, b} gear{j, j}", "j1 must be a revolute or a prismatic joint"},
      {"local j = revolute{world, b, at={0,0}} gear{j, j}", "gear couples a joint to itself"},
      {"pulley{world, b, from_a={0,1}, from_b={1,1}, to_a={0,1}, to_b={3,0}}", "from_a and to_a are the same point"},
      {"pulley{world, b, from_a={0,1}, from_b={1,1}, to_a={0,0}}", "pulley needs to_b="},
      {"pulley{world, b, from_a={0,1}, from_b={1,1}, to_a={0,0}, to_b={3,0}, ratio=0}", "ratio must be"},
      {"drag_to{world, target={0,0}, max_force=1}", "must be a body of the scene, not the world"},
      {"drag_to{b, max_force=1}", "drag_to needs target="},
      {"drag_to{b, target={0,0}}", "drag_to needs max_force="},
      {"drag_to{b, target={0/0,0}, max_force=1}", "target must be finite"},
      {"motor{world, b}", "motor needs speed= with max_torque=, or velocity= with max_force="},
      {"motor{world, b, speed=1}", "motor needs max_torque="},
      {"motor{world, b, velocity={1,0}}", "motor needs max_force="},
      {"local j = weld{world, b} j:set{speed=1}", "belongs to a motor, and this joint was made without one"},
      {"local j = weld{world, b} j:set{target={0,0}}", "belongs to drag_to, which this joint is not"},
      {"local j = weld{world, b} on_break(j, print)", "the joint never breaks; make it with break_force="},
      {"local j = weld{world, b, break_force=1} b:remove() j:reaction()", "joint 0 was removed"},
  }));
  INFO(line);
  CHECK_THAT(error_of("scenario{}\nlocal b = body{at={3,0}, shape=circle{radius=1}}\n" + line),
             Catch::StartsWith("scene.lua: line 3: ") && Catch::Contains(problem));
}

TEST_CASE("Targets and speeds can be set on the way") {
  FakeRun r(R"(
    scenario{duration=1, rate=100, fps=50}
    local b = body{shape=circle{radius=1}}
    local hand = drag_to{b, target={0,0}, max_force=1}
    local j = revolute{world, b, at={0,0}, motor={speed=1, max_torque=1}}
    at(0.1, function() hand:set{target={2,3}} j:set{speed=-4} end))");
  r.until(11);
  CHECK(std::get<ChangeJoint>(r.simulation->log.at(0)).target == Vec2d{2, 3});
  CHECK(std::get<ChangeJoint>(r.simulation->log.at(1)).speed == -4);
}

TEST_CASE("A break is told once, and a broken joint still answers") {
  const std::string text = R"(
    scenario{duration=0.5}
    local b = body{shape=circle{radius=1}, mass=10}
    local j = weld{world, b, break_force=50}
    local told, force = 0, 0
    on_break(j, function(e) told = told + 1 force = e.reaction.y assert(e.joint == j) j:remove() end)
    measure('told', function() return told end)
    measure('force', function() return force end)
    measure('reaction', function() return j:reaction().y end)
    measure('gap', function() return j:gap() end))";
  const auto scenario = load_text(text);
  Runner runner(*scenario);
  while (!runner.finished()) runner.step();
  CHECK(scenario->script->measure(0) == 1);
  CHECK(scenario->script->measure(1) == Approx(98.1).epsilon(1e-6));
  CHECK(scenario->script->measure(2) == 0);
  CHECK(scenario->script->measure(3) > 0.5);
}
