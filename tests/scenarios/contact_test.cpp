#include <catch2/catch.hpp>

#include "scene_text.h"

using namespace proofreel;

namespace {

constexpr auto a = static_cast<BodyId>(1);
constexpr auto b = static_cast<BodyId>(2);

const std::string two_balls = R"(
  scenario{duration=1, rate=100, fps=50}
  local a = body{name='a', shape=circle{radius=1}}
  local b = body{name='b', shape=circle{radius=1}}
  local c = body{name='c', shape=circle{radius=1}}
  local log, event = 0, nil
  measure('log', function() return log end)
)";

const ContactEvent touch{a, b, {0.5, 0.25}, {1, 0}, 3};

const SeparationEvent parting{a, b};

}  // namespace

TEST_CASE("on_contact tells how fast they met") {
  FakeRun r(two_balls + "on_contact(a, b, function(e) log = e.speed end)");
  r.simulation->events_at[1] = {{a, b, {}, {1, 0}, 3, 2.5}};
  r.until(1);
  CHECK(r.measure() == 2.5);
}

TEST_CASE("on_separate hears when two part, in the order the handler names them") {
  const std::string pair = GENERATE("b, a", "b, nil", "nil, a");
  FakeRun r(two_balls + "on_separate(" + pair +
            ", function(e) log = log + ((e.a == b and e.b == a) and 1 or 100) end)" +
            "on_separate(c, nil, function() log = 50 end)");
  r.simulation->separations_at[2] = {parting};
  r.until(3);
  CHECK(r.measure() == 1);
}

TEST_CASE("on_separate hears of a body that was removed, too, whose handle still tells who it was") {
  FakeRun r(two_balls + "at(0.01, function() b:remove() end)" +
            "on_separate(a, nil, function(e) log = e.b == b and 1 or 2 end)");
  r.simulation->separations_at[2] = {parting};
  r.until(2);
  CHECK(r.measure() == 1);
}

TEST_CASE("on_contact hears of contacts after the step that made them") {
  FakeRun r(two_balls + "on_contact(a, b, function(e) log = time() * 100 + e.impulse * 1000 end)");
  r.simulation->events_at[5] = {touch};
  r.until(4);
  CHECK(r.measure() == 0);
  r.until(5);
  CHECK(r.measure() == 3005);
}

TEST_CASE("The event comes in the order the handler names the bodies, the normal turned with them") {
  const std::string handler =
      "function(e) log = (e.a == b and e.b == a and e.normal.x == -1 and e.point.y == 0.25) and 1 or 2 end";
  const std::string pair = GENERATE("b, a", "b, nil", "nil, a");
  FakeRun r(two_balls + "on_contact(" + pair + ", " + handler + ")");
  r.simulation->events_at[1] = {touch};
  r.until(1);
  CHECK(r.measure() == 1);
}

TEST_CASE("nil stands for any body, and others are not heard of") {
  FakeRun r(two_balls +
            "on_contact(nil, nil, function() log = log + 1 end) on_contact(c, nil, function() log = 50 end)");
  r.simulation->events_at[1] = {touch, touch};
  r.until(1);
  CHECK(r.measure() == 2);
}

TEST_CASE("Handlers run in order of creation, event by event") {
  FakeRun r(two_balls +
            "on_contact(nil, nil, function() log = log * 10 + 1 end)"
            "on_contact(nil, nil, function() log = log * 10 + 2 end)");
  r.simulation->events_at[1] = {touch, touch};
  r.until(1);
  CHECK(r.measure() == 1212);
}

TEST_CASE("A handler that removes a body hears no more of it") {
  FakeRun r(two_balls + "on_contact(nil, nil, function(e) log = log + 1 e.b:remove() end)");
  r.simulation->events_at[1] = {touch, touch};
  r.until(1);
  CHECK(r.measure() == 1);
  CHECK_FALSE(r.simulation->exists(b));
}

TEST_CASE("contacts lists touching points only, seen from the body asked about") {
  FakeRun r(two_balls + R"(
    local list = {}
    at(0.01, function()
      list = contacts(b)
      local one = list[1]
      local as_seen = one.other == a and one.normal.x == -1 and one.separation == -0.1 and one.impulse == 2
      log = #list * 10 + (as_seen and 1 or 2)
    end))");
  ContactView view{a, b, {1, 0}, {}, 2};
  view.points[0] = {{0, 0}, -0.1, 2, 0};
  view.points[1] = {{0, 1}, 0.2, 0, 0};  // speculative: apart, and no impulse
  r.simulation->touching = {view};
  r.until(2);
  CHECK(r.measure() == 11);
}

TEST_CASE("contacts of nobody lists all that touches, normals from a to b") {
  FakeRun r(two_balls + R"(
    at(0.01, function()
      local list = contacts()
      local one = list[1]
      log = #list * 10 + ((one.a == a and one.b == b and one.normal.x == 1 and one.separation == -0.1) and 1 or 2)
    end))");
  ContactView view{a, b, {1, 0}, {}, 1};
  view.points[0] = {{0, 0}, -0.1, 2, 0};
  r.simulation->touching = {view, view};
  r.until(2);
  CHECK(r.measure() == 21);
}

TEST_CASE("A ball that falls on the ground tells of it once") {
  const auto scenario = load_text(R"(
    scenario{duration=1}
    local floor = ground{y=0}
    local ball = body{at={0, 0.6}, shape=circle{radius=0.5}}
    local count = 0
    on_contact(ball, floor, function(e) count = count + (e.normal.y < -0.9 and 1 or 100) end)
    measure('count', function() return count end))");
  CHECK(Runner(*scenario).finish().measures[0].final == 1);
}
