#include <catch2/catch.hpp>

#include "scene_text.h"

using namespace proofreel;
using Catch::Contains;
using Catch::StartsWith;

namespace {

/// A line of a scene that has a ball `b`, and part of what must be said about it.
struct Wrong {
  std::string line;
  std::string problem;
};

void check(const Wrong& wrong) {
  const std::string text = "scenario{}\nlocal b = body{name='ball', shape=circle{radius=1}}\n" + wrong.line;
  INFO(wrong.line);
  CHECK_THAT(error_of(text), StartsWith("scene.lua: line 3: ") && Contains(wrong.problem));
}

}  // namespace

TEST_CASE("A misspelt key names the file, the line and the nearest valid key") {
  CHECK(error_of("scenario{}\nbody{shape=circle{radius=1}, frcition=1}") ==
        "scene.lua: line 2: body: unknown key \"frcition\", did you mean \"friction\"?");
  CHECK(error_of("scenario{}\nbody{\n  shape=circle{radius=1},\n  frcition=1\n}") ==
        "scene.lua: line 4: body: unknown key \"frcition\", did you mean \"friction\"?");
  CHECK_THAT(error_of("scenario{duratoin=1}"),
             Contains("line 1: scenario: unknown key \"duratoin\", did you mean \"duration\"?"));
  CHECK_THAT(error_of("scenario{view={hight=1}}"),
             Contains("scenario: view: unknown key \"hight\", did you mean \"height\"?"));
  CHECK_THAT(error_of("scenario{}\ntrail{boody=1}"), Contains("trail: unknown key \"boody\", did you mean \"body\"?"));
}

TEST_CASE("Of several misspelt keys always the same is named") {
  for (int i = 0; i < 5; ++i) {
    CHECK_THAT(error_of("scenario{}\nbody{zz=1, yy=2, xx=3, ww=4}"), Contains("unknown key \"ww\""));
  }
}

TEST_CASE("scenario{} refuses values it cannot use") {
  const auto [keys, problem] = GENERATE(table<std::string, std::string>({
      {"duration=0", "duration must be a positive number, got 0"},
      {"duration=-1", "duration must be a positive number"},
      {"duration='x'", "duration must be a number, got \"x\""},
      {"duration=0/0", "duration must be a positive number, got nan"},
      {"duration=1e-9", "is shorter than a tick"},
      {"duration=1e9", "must not exceed 100 million ticks"},
      {"rate=0", "rate must lie between 1 and 1000000, got 0"},
      {"rate=59.5", "rate must be a whole number, got 59.5"},
      {"fps=-60", "fps must lie between 1 and 1000"},
      {"seed='a'", "seed must be a whole number"},
      {"gravity=9.81", "gravity must be a vector {x, y}, got 9.81"},
      {"gravity={0, 1/0}", "gravity must be finite"},
      {"gravity={0, -1e200}", "gravity must stay below 1e6"},
      {"view=5", "view must be a table"},
      {"view={height=0}", "view: height must be a positive number"},
      {"size={100000, 100000}", "size must be two whole numbers between 1 and 16384"},
      {"size={16384, 16384}", "is too large: at most 67108864 pixels"},
      {"size={640.5, 480}", "size must be two whole numbers"},
      {"size='1280'", "size must be two whole numbers"},
      {"theme='ligth'", "theme cannot be \"ligth\", did you mean \"light\"?"},
      {"effects='all'", "effects must be \"auto\" or a list"},
      {"effects={'gravty'}", "effects cannot hold \"gravty\", did you mean \"gravity\"?"},
      {"effects={1}", "effects must be a list of names, got 1 in it"},
      {"layers={'bodys'}", "there are \"bodies\", \"parts\", \"bvh\", \"contacts\", \"joints\""},
      {"method={substeps=0}", "method: substeps must lie between 1 and 10000"},
      {"method={integrator='euler'}", "integrator cannot be \"euler\""},
      {"method={contact_hz=0}", "contact_hz must be a positive number"},
      {"golden={}", "golden needs frames="},
      {"golden={frames={-1}}", "frames must be a list of frame numbers"},
      {"title=3", "title must be a text in quotes, got 3"},
  }));
  CHECK_THAT(error_of("scenario{" + keys + "}"), StartsWith("scene.lua: line 1: scenario") && Contains(problem));
}

TEST_CASE("scenario{} is called once, and at the top level") {
  CHECK_THAT(error_of("body{shape=circle{radius=1}}"), Contains("the file never calls scenario{...}"));
  CHECK_THAT(error_of("scenario{}\nscenario{}"), Contains("line 2: scenario{...} was called already"));
  CHECK_THAT(error_of("scenario 'x'"), Contains("scenario needs a table, scenario{...}, got \"x\""));
  CHECK_THAT(error_of("scenario{}\nat(0.1, function() scenario{} end)"), Contains("belongs at the top level"));
  CHECK_THAT(error_of("at(0, print)\nscenario{}"), Contains("call scenario{...} first"));
}

TEST_CASE("Bodies refuse values they cannot use") {
  const auto [keys, problem] = GENERATE(table<std::string, std::string>({
      {"mass=0", "mass must be a positive number, got 0"},
      {"mass=-1", "mass must be a positive number"},
      {"inertia=0", "inertia must be a positive number"},
      {"density=-1", "density must be a positive number"},
      {"friction=-0.1", "friction must be a number that is not negative"},
      {"friction='rough'", "friction must be a number or {static=, kinetic=}"},
      {"friction={static=0.2, kinetic=0.4}", "must not be larger when sliding"},
      {"friction={static=0.2}", "friction needs kinetic="},
      {"restitution=1.5", "restitution must lie between 0 and 1"},
      {"at=5", "at must be a vector {x, y}, got 5"},
      {"at={1}", "at must be a vector {x, y}"},
      {"at={1, 2, 3}", "at must be a vector {x, y}"},
      {"at={0/0, 1}", "at must be finite"},
      {"angle=1/0", "angle must be a finite number"},
      {"velocity={'a', 'b'}", "velocity must be a vector"},
      {"type='dynamik'", "type cannot be \"dynamik\", did you mean \"dynamic\"?"},
      {"name=5", "name must be a text in quotes"},
      {"bullet=1", "bullet must be true or false, got 1"},
      {"group=0.5", "group must be a whole number"},
      {"color='red'", "color must be written 0xRRGGBB"},
      {"color=-1", "color must lie between 0 and 16777215"},
      {"shapes={circle{radius=1}}", "shape and shapes cannot both be set"},
      {"[1]=2", "unknown key \"1\""},
  }));
  check({"body{shape=circle{radius=1}, " + keys + "}", problem});
}

TEST_CASE("A body needs a shape that is one") {
  check({"body{}", "body \"body 2\": it is dynamic but has no shape"});
  check({"body{type='static'}", "body \"body 2\": it needs a shape"});
  check({"body{shape={radius=1}}", "shape must be a shape such as circle{radius=1}, got a table"});
  check({"body{shape=circle}", "shape must be a shape such as circle{radius=1}, got a function"});
  check({"body{shapes=circle{radius=1}}", "shapes must be a list of shapes"});
  check({"body{shapes={}}", "shapes must hold at least one shape"});
  check({"body{shapes={1}}", "shapes must be a list of shapes, got 1 in it"});
  check({"body 'x'", "body needs a table, body{...}, got \"x\""});
}

TEST_CASE("Geometry that cannot be used is refused with the body's name") {
  const auto [shape, problem] = GENERATE(table<std::string, std::string>({
      {"circle{radius=0}", "the radius of its circle must be a positive number"},
      {"segment{a={0,0}, b={1,0}}", "no area"},
      {"polygon{{0,0},{1,1},{1,0},{0,1}}", "crosses itself"},
  }));
  check({"body{name='odd one', shape=" + shape + "}", "body \"odd one\": "});
  check({"body{name='odd one', shape=" + shape + "}", problem});
}

TEST_CASE("Shapes refuse keys and types at once") {
  check({"circle{}", "circle needs radius="});
  check({"circle{radius='1'}", "circle: radius must be a number, got \"1\""});
  check({"circle{raduis=1}", "circle: unknown key \"raduis\", did you mean \"radius\"?"});
  check({"regular{sides=2, radius=1}", "sides must lie between 3 and 16"});
  check({"polygon{{0,0},{1,0},5}", "polygon: corner 3 must be a vector {x, y}, got 5"});
  check({"box{width=1}", "box needs height="});
  check({"capsule{a={0,0}, radius=1}", "capsule needs b="});
  check({"circle{radius=1}.radius = 2", "a shape has no \"radius\""});
}

TEST_CASE("Handles refuse methods they do not have and bodies that are gone") {
  check({"b:positon()", "a body has no \"positon\", did you mean \"position\"?"});
  check({"local x = b.mas", "a body has no \"mas\", did you mean \"mass\"?"});
  check({"b.position()", "write b:position(), not b.position()"});
  check({"b.angle = 3", "handles have no fields to assign to"});
  check({"b:remove() b:remove()", "body \"ball\" was removed"});
  check({"b:remove() b:velocity()", "body \"ball\" was removed"});
  check({"b:set{anlge=1}", "set: unknown key \"anlge\", did you mean \"angle\"?"});
  check({"b:set{mass=-1}", "mass must be a positive number"});
  check({"b:set{shape=circle{radius=0}}", "body \"ball\": the radius of its circle"});
  check({"b:impulse(5)", "impulse must be a vector {x, y}, got 5"});
  check({"b:impulse({1/0, 0})", "impulse must be finite"});
  check({"b:force({1, 0})", "works only in callbacks"});
  check({"b:torque(1)", "works only in callbacks"});
  check({"world:set{at={1,1}}", "the world cannot be changed"});
  check({"ground{y=0}:impulse({1,0})", "b:impulse has no effect on body \"ground\", which is not dynamic"});
  check({"contacts(5)", "contacts(b): b must be a body, got 5"});
  check({"contacts(nil)", "contacts(b): b must be a body, got nothing"});
  check({"on_separate(b, print)", "on_separate needs two bodies (or nil for any) and a function"});
  check({"on_separate(b, b, print)", "on_separate: a body never touches itself"});
}

TEST_CASE("Joints refuse what they cannot join") {
  check({"revolute{world, b}", "revolute needs at="});
  check({"revolute{world, at={0,0}}", "revolute{a, b, ...}: b must be a body, got nothing"});
  check({"revolute{b, b, at={0,0}}", "revolute joins body \"ball\" to itself"});
  check({"revolute{world, ground{y=0}, at={0,0}}", "neither of which is dynamic"});
  check({"distance{world, b, from={0,0}}", "distance needs to="});
  check({"distance{world, b, from={0,0}, to={0,0}}", "are the same point"});
  check({"distance{world, b, from={0,0}, to={1,0}, length=0}", "length must be a positive number"});
  check({"spring{world, b, from={0,0}, to={1,0}}", "spring needs stiffness="});
  check({"spring{world, b, from={0,0}, to={1,0}, stiffness=-1}", "stiffness must be a number that is not negative"});
  check({"b:remove() revolute{world, b, at={0,0}}", "body \"ball\" was removed"});
  check({"local j = revolute{world, b, at={0,0}} j:remove() j:gap()", "joint 0 was removed"});
  check({"local j = revolute{world, b, at={0,0}} b:remove() j:gap()", "joint 0 was removed"});
  check({"local j = revolute{world, b, at={0,0}} j:force()", "a joint has no \"force\""});
}

TEST_CASE("Events and pictures refuse what they cannot use") {
  check({"at('x', print)", "at(t, fn): t must be a number of seconds, got \"x\""});
  check({"at(-1, print)", "must be a number of seconds that is not negative, got -1"});
  check({"at(1)", "at(t, fn): fn must be a function, got nothing"});
  check({"every(0, print)", "shorter than a tick, which takes 1/240 s"});
  check({"every(1/0, print)", "must be a number of seconds"});
  check({"on_contact(b, print)", "on_contact needs two bodies (or nil for any) and a function"});
  check({"on_contact(b, b, print)", "a body never touches itself"});
  check({"on_contact(5, nil, print)", "must be a body, got 5"});
  check({"camera{}", "camera needs follow=, center= or height="});
  check({"camera{follow=b, center={0,0}}", "follow and center cannot both be set"});
  check({"camera{follow=world}", "must be a body of the scene, not the world"});
  check({"caption{from=0}", "caption needs text="});
  check({"caption{text='a', from=2, to=1}", "to must come after from"});
  check({"caption{text='a', at='botom'}", "at cannot be \"botom\", did you mean \"bottom\"?"});
  check({"label{text='a'}", "label needs body="});
  check({"vector{body=b, of='speed'}", "of cannot be \"speed\""});
  check({"vector{body=b, of='velocity', scale=0}", "scale must be a positive number"});
  check({"trail{body=b, seconds=-1}", "seconds must be a positive number"});
  check({"plot{title='p'}", "plot needs y="});
  check({"plot{y={}}", "y must hold at least one curve"});
  check({"plot{y={a=1}}", "y must be a table {name = function() ... end, ...}"});
  check({"slow{from=1, to=2}", "slow needs factor="});
  check({"slow{from=1, to=2, factor=2}", "factor must not be larger than 1"});
  check({"slow{from=2, to=1, factor=0.5}", "to must come after from"});
  check({"slow{from=1, to=2, factor=0.5} slow{from=1.5, to=3, factor=0.5}", "two stretches of slow motion overlap"});
}

TEST_CASE("Texts that could not be shown are refused") {
  check({"label{body=b, text='\\xff'}", "label: text must be UTF-8 without control characters"});
  check({"label{body=b, text='\\xc0\\x80'}", "must be UTF-8"});
  check({"label{body=b, text='\\xed\\xa0\\x80'}", "must be UTF-8"});
  check({"label{body=b, text='a\\0b'}", "must be UTF-8"});
  check({"measure('\\27', time)", "must be UTF-8"});
  check({"caption{text=('x'):rep(10001)}", "is longer than 10000 bytes"});
  CHECK(error_of("scenario{title='\u00b5 \u2192 \U0001F600\\n'}").empty());
}

TEST_CASE("An integrator that cannot step the scene is refused, also when a callback makes it so") {
  const std::string rk4 = "scenario{method={integrator='rk4'}} body{shape=circle{radius=1}} ";
  CHECK(error_of(rk4).empty());
  CHECK_THAT(error_of(rk4 + "body{at={3, 0}, shape=circle{radius=1}}"),
             Contains("integrator \"rk4\" cannot step bodies"));
  CHECK_THAT(error_of(rk4 + "at(0.1, function() body{at={3, 0}, shape=circle{radius=1}} end)"),
             Contains("integrator \"rk4\" cannot step bodies"));
}

TEST_CASE("Measuring refuses what it cannot use") {
  check({"measure('', print)", "measure(name, fn): name must not be empty"});
  check({"measure('m')", "measure(name, fn): fn must be a function, got nothing"});
  check({"measure('m', print) measure('m', print)", "there is a measure \"m\" already"});
  check({"reference('m', {1, 2})", "must hold pairs {t, value} of finite numbers, got 1"});
  check({"reference('m', {})", "must hold at least one pair"});
  check({"reference('m', 5)", "reference(name, what): what must be a function, got 5"});
  check({"expect('e', print, {sometimes=true})", "expect: unknown key \"sometimes\""});
  check({"expect('e', print, {at=1, always=true})", "expect takes one of"});
  check({"expect('e', print, {})", "expect takes one of"});
}
