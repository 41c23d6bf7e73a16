#include <catch2/catch.hpp>

#include "scene_text.h"

using namespace proofreel;

namespace {

BodyDef body_of(const std::string& text) { return load_text("scenario{}\n" + text)->scene.bodies.at(0); }

}  // namespace

TEST_CASE("A body takes all its keys") {
  const BodyDef b = body_of(
      "body{name='b', type='kinematic', at={1,2}, angle=3, velocity={4,5}, spin=6, density=7, mass=8, inertia=9,"
      "friction={static=0.6, kinetic=0.4}, restitution=0.5, gravity_scale=-1, fixed_rotation=true, bullet=true,"
      "sensor=true, group=-2, category=4, mask=8, color=0x123456, shape=circle{radius=1, at={0.5, 0}}}");
  CHECK(b.name == "b");
  CHECK(b.type == BodyType::kinematic);
  CHECK(b.position == Vec2d{1, 2});
  CHECK(b.angle == 3);
  CHECK(b.velocity == Vec2d{4, 5});
  CHECK(b.spin == 6);
  CHECK(b.shapes.at(0).density == 7);
  CHECK(b.mass == 8);
  CHECK(b.inertia == 9);
  CHECK(b.shapes[0].friction == FrictionDef{0.6, 0.4});
  CHECK(b.shapes[0].restitution == 0.5);
  CHECK(b.gravity_scale == -1);
  CHECK((b.fixed_rotation && b.bullet && b.sensor));
  CHECK(b.filter.group == -2);
  CHECK(b.filter.category == 4);
  CHECK(b.filter.mask == 8);
  CHECK(b.color == 0x123456);
  CHECK(b.shapes[0].points == std::vector<Vec2d>{{0.5, 0}});
}

TEST_CASE("A body without a name is called after its number") {
  const auto scenario = load_text(
      "scenario{}\nground{y=0}\nbody{shape=circle{radius=1}}\nat(0.1, function() body{shape=circle{radius=1}} end)");
  CHECK(scenario->scene.bodies[0].name == "ground");
  CHECK(scenario->scene.bodies[1].name == "body 2");
  Runner(*scenario).finish();
  CHECK(scenario->body_names == std::vector<std::string>{"ground", "body 2", "body 3"});
}

TEST_CASE("Shapes keep coefficients of their own and take the rest from the body") {
  const BodyDef b = body_of(
      "body{friction=0.1, density=3, shapes={circle{radius=1, friction=0.9}, box{width=1, height=2, density=5}}}");
  CHECK(b.shapes.at(0).friction == FrictionDef{0.9, 0.9});
  CHECK(b.shapes[0].density == 3);
  CHECK(b.shapes.at(1).friction == FrictionDef{0.1, 0.1});
  CHECK(b.shapes[1].density == 5);
}

TEST_CASE("Boxes, regular polygons and hulls have the corners they say") {
  CHECK(body_of("body{shape=box{width=2, height=4, at={1, 0}}}").shapes[0].points ==
        std::vector<Vec2d>{{0, -2}, {2, -2}, {2, 2}, {0, 2}});
  const auto square = body_of("body{shape=regular{sides=4, radius=math.sqrt(2)}}").shapes[0].points;
  REQUIRE(square.size() == 4);
  CHECK(square[0].x == Approx(1));
  CHECK(square[0].y == Approx(-1));
  CHECK(square[2].x == Approx(-1));
  CHECK(square[2].y == Approx(1));
  CHECK(body_of("body{shape=hull{{0,0},{2,0},{1,0.5},{2,2},{0,2}}}").shapes[0].points.size() == 4);
  CHECK(body_of("body{shape=polygon{{0,0},{0,1},{1,1},{1,0},{0.5,0}}}").shapes[0].points.size() == 4);
  const ShapeDef capsule = body_of("body{shape=capsule{a={-1,0}, b={1,0}, radius=0.5}}").shapes[0];
  CHECK(capsule.points == std::vector<Vec2d>{{-1, 0}, {1, 0}});
  CHECK(capsule.radius == 0.5);
}

TEST_CASE("Colours are numbers or hexadecimal texts") {
  CHECK(body_of("body{shape=circle{radius=1}, color='#fF8000'}").color == 0xFF8000);
}

TEST_CASE("ground and wall are static") {
  const BodyDef floor = body_of("ground{y=2, friction=0.9}");
  CHECK(floor.type == BodyType::fixed);
  CHECK(floor.position == Vec2d{0, 2});
  CHECK(floor.shapes[0].points[2].y == 0);
  CHECK(floor.shapes[0].friction.at_rest == 0.9);
  const BodyDef wall = body_of("wall{a={1,0}, b={1,5}}");
  CHECK(wall.type == BodyType::fixed);
  CHECK(wall.shapes[0].points == std::vector<Vec2d>{{1, 0}, {1, 5}});
}

TEST_CASE("Handles answer while the file is loaded") {
  const std::string make =
      "b = body{at={1,2}, angle=0.5, velocity={3,4}, spin=5, mass=6, shape=circle{radius=1, at={1, 0}}}";
  CHECK(is_true("b:position().x == 1 and b:position()[2] == 2 and b:angle() == 0.5 and b:spin() == 5", make));
  CHECK(is_true("b:velocity().y == 4 and b:mass() == 6 and math.abs(b:center().x - 1 - math.cos(0.5)) < 1e-15", make));
  CHECK(is_true("b == b2 and t[b2] == 1 and b ~= world", make + "\nt = {[b] = 1}\nfor k in pairs(t) do b2 = k end"));
}

TEST_CASE("Vectors are tables with names, and come in both ways") {
  const std::string make = "b = body{at={x=1, y=2}, shape=circle{radius=1}}\np = b:position()";
  CHECK(is_true("p.x == 1 and p[1] == 1 and p.y == 2 and p[2] == 2 and #p == 2 and p.z == nil", make));
  CHECK(is_true("p[1] == 7 and b:position().x == 7 and tostring(p) == '{7.0, 2.0}'", make + "\np.x = 7\nb:set{at=p}"));
}

TEST_CASE("set while loading changes what the body starts with") {
  const BodyDef b = body_of(
      "local b = body{shape=circle{radius=1}, friction=0.2}\n"
      "b:set{at={5,5}, name='new', shape=box{width=1, height=1}, mask=2}");
  CHECK(b.position == Vec2d{5, 5});
  CHECK(b.name == "new");
  CHECK(b.shapes[0].points.size() == 4);
  CHECK(b.shapes[0].friction.at_rest == 0.2);
  CHECK(b.filter.mask == 2);
}

TEST_CASE("An impulse while loading is part of the first velocity") {
  const BodyDef b = body_of("local b = body{mass=2, inertia=4, shape=circle{radius=1}}\nb:impulse({6, 0}, {0, 1})");
  CHECK(b.velocity == Vec2d{3, 0});
  CHECK(b.spin == -1.5);
}

TEST_CASE("Callbacks act through commands") {
  FakeRun r(R"(
    scenario{duration=1, rate=100, fps=50}
    local b = body{shape=circle{radius=1}, group=-3, friction=0.3}
    at(0, function()
      b:set{velocity={1, 0}, mask=6, restitution=0.5}
      b:impulse({1, 2})
      b:force({3, 4}, {5, 6})
      b:torque(7)
      b:set{shape=circle{radius=2}, friction=0.8}
      b:remove()
    end))");
  r.until(1);
  REQUIRE(r.simulation->log.size() == 6);
  const auto& change = std::get<ChangeBody>(r.simulation->log[0]);
  CHECK(change.velocity == Vec2d{1, 0});
  CHECK(change.restitution == 0.5);
  CHECK(change.filter->group == -3);
  CHECK(change.filter->mask == 6);
  CHECK_FALSE(change.position);
  CHECK(std::get<ApplyImpulse>(r.simulation->log[1]).impulse == Vec2d{1, 2});
  CHECK_FALSE(std::get<ApplyImpulse>(r.simulation->log[1]).at);
  CHECK(std::get<ApplyForce>(r.simulation->log[2]).at == Vec2d{5, 6});
  CHECK(std::get<ApplyTorque>(r.simulation->log[3]).torque == 7);
  const auto& reshaped = std::get<ChangeBody>(r.simulation->log[4]);
  CHECK(reshaped.shapes->at(0).friction.at_rest == 0.8);
  CHECK(reshaped.shapes->at(0).restitution == 0.5);
  CHECK_FALSE(reshaped.friction);
  CHECK(std::get<RemoveBody>(r.simulation->log[5]).body == static_cast<BodyId>(1));
}

TEST_CASE("A body removed while loading is gone before the first tick") {
  FakeRun r(
      "scenario{}\nlocal b = body{shape=circle{radius=1}}\nlocal j = revolute{world, b, at={0,0}}\n"
      "local c = body{shape=circle{radius=1}}\nb:remove()");
  CHECK_FALSE(r.simulation->exists(static_cast<BodyId>(1)));
  CHECK(r.simulation->exists(static_cast<BodyId>(2)));
  CHECK_FALSE(r.simulation->exists(JointId{0}));
}

TEST_CASE("Effects that the list omits are named in a warning") {
  const std::string bounce = "body{shape=circle{radius=1}, restitution=0.5}\n";
  CHECK_THAT(load_text("scenario{effects={'gravity'}}\n" + bounce)->warnings.at(0), Catch::Contains("\"restitution\""));
  CHECK(load_text("scenario{effects={'gravity', 'restitution'}}\n" + bounce)->warnings.empty());
  CHECK(load_text("scenario{}\n" + bounce)->warnings.empty());
  const auto late =
      load_text("scenario{duration=0.2, effects={'gravity'}}\nevery(0.05, function() " + bounce + " end)");
  CHECK(late->warnings.empty());
  Runner(*late).finish();
  CHECK(late->warnings.size() == 1);
}
