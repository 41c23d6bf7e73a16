#include <algorithm>
#include <catch2/catch.hpp>

#include "moving_disc.h"

using namespace proofreel;
using Catch::Contains;

TEST_CASE("A phase portrait holds one quantity beside the others, and what both have reached after it is forgotten") {
  auto r = run("plot{x={twice=function() return 2 * time() end}, y={t=time}, unit='s', x_unit='m', seconds=1}");
  const PlotView plot = frame_at(r, 300).plots.at(0);
  REQUIRE(plot.is_portrait());
  CHECK(plot.x_name == "twice");
  CHECK(plot.unit == "s");
  CHECK(plot.x_unit == "m");
  REQUIRE(plot.xs.size() == 51);
  CHECK(plot.xs.front() == Approx(4));
  CHECK(plot.values[0].back() == Approx(3));
  CHECK(plot.x_reach.low == 0);
  CHECK(plot.x_reach.high == Approx(6));
  CHECK(plot.y_reach.high == Approx(3));
}

TEST_CASE("A plot that cannot be drawn is refused in one sentence with file and line") {
  CHECK_THAT(error_of("scenario{}\nplot{y={v=function()\nreturn nil end}}"),
             Contains("line 2") && Contains("must return a number, got nothing") && Contains("\"v\""));
  CHECK_THAT(error_of("scenario{}\nplot{y={v=function() return 0/0 end}}"),
             Contains("line 2") && Contains("a finite number"));
  CHECK_THAT(error_of("scenario{}\nplot{y={v=time}, x={w=function() return {} end}}"),
             Contains("line 2") && Contains("plot curve \"w\""));
  CHECK_THAT(error_of("scenario{}\nplot{y={v=time}, x={a=time, b=time}}"), Contains("x must hold one quantity"));
  CHECK_THAT(error_of("scenario{}\nplot{y={v=time}, x_unit='m'}"), Contains("x_unit"));
  CHECK_THAT(error_of("scenario{}\nplot{y={}}"), Contains("at least one curve"));
}

TEST_CASE("A vector of a quantity begins at the centre and is as long as its scale says") {
  auto r = run("vector{body=b, of='momentum', scale=0.25}");
  const ArrowView arrow = frame_at(r, 100).arrows.at(0);
  CHECK(distance(arrow.from, {1, 0}) < 1e-12);
  CHECK(distance(arrow.to, {1.5, 0}) < 1e-12);
}

TEST_CASE("A vector that is given stands at a point of its body, from one moment until another") {
  auto r = run("vector{body=b, of={0, 3}, scale=0.5, point={0.25, 0}, from=1, to=2}");
  CHECK(frame_at(r, 99).arrows.empty());
  const ArrowView arrow = frame_at(r, 100).arrows.at(0);
  CHECK(arrow.of == VectorOf::given);
  CHECK(arrow.from.x == Approx(1.25));
  CHECK(arrow.to.x == Approx(1.25));
  CHECK(arrow.to.y == Approx(1.5));
  CHECK(frame_at(r, 199).arrows.at(0).from.x == Approx(2.24));
  CHECK(frame_at(r, 200).arrows.empty());
}

TEST_CASE("A vector of what is neither a quantity nor a vector is refused") {
  const std::string begin = "scenario{}\nlocal b = body{shape=circle{radius=1}}\nvector{body=b, ";
  CHECK_THAT(error_of(begin + "}"), Contains("line 3") && Contains("of"));
  CHECK_THAT(error_of(begin + "of='speed'}"), Contains("line 3") && Contains("velocity"));
  CHECK_THAT(error_of(begin + "of={1}}"), Contains("of must be a vector {x, y}"));
  CHECK_THAT(error_of(begin + "of={1, 0/0}}"), Contains("line 3") && Contains("of"));
  CHECK_THAT(
      error_of(begin + "of=5}"),
      Contains("line 3") && Contains("of must be the name of a quantity, such as \"velocity\", or a vector {x, y}"));
  CHECK_THAT(error_of(begin + "of={1, 2}, from=2, to=2}"), Contains("to must come after from"));
}

TEST_CASE("A highlight comes and goes within three tenths of a second") {
  auto r = run("highlight{body=b, from=1, to=3, text='this'}");
  CHECK(frame_at(r, 99).highlights.empty());
  CHECK(frame_at(r, 100).highlights.at(0).strength == 0);
  CHECK(frame_at(r, 115).highlights.at(0).strength == Approx(0.5));
  const HighlightView whole = frame_at(r, 200).highlights.at(0);
  CHECK(whole.strength == 1);
  CHECK(whole.text == "this");
  CHECK(whole.body == static_cast<BodyId>(1));
  CHECK_FALSE(whole.at.has_value());
  CHECK(frame_at(r, 285).highlights.at(0).strength == Approx(0.5));
  CHECK(frame_at(r, 301).highlights.empty());
}

TEST_CASE("A highlight shorter than that never reaches its full strength for longer than a moment") {
  auto r = run("highlight{body=b, from=1, to=1.2}");
  CHECK(frame_at(r, 105).highlights.at(0).strength == Approx(0.5));
  CHECK(frame_at(r, 110).highlights.at(0).strength == Approx(1));
  CHECK(frame_at(r, 115).highlights.at(0).strength == Approx(0.5));
}

TEST_CASE("A highlighted point moves with its body, one of the world stays, and both go when what they show goes") {
  auto r =
      run("highlight{body=b, point={0.5, 0}} highlight{at={3, 4}, radius=0.2} highlight{body=b}\n"
          "at(2, function() b:remove() end)");
  const auto views = frame_at(r, 100).highlights;
  REQUIRE(views.size() == 3);
  CHECK(views[0].at->x == Approx(1.5));
  CHECK(views[0].radius == Approx(0.35));
  CHECK(*views[1].at == Vec2d{3, 4});
  CHECK(views[1].radius == 0.2);
  CHECK(frame_at(r, 300).highlights.size() == 1);
}

TEST_CASE("A highlighted joint is shown half way between its anchors") {
  const auto scenario = load_text(
      "scenario{}\nlocal b = body{at={2, 0}, shape=circle{radius=0.2}}\n"
      "highlight{joint=distance{world, b, from={0, 0}, to={2, 0}}}");
  const Runner runner(*scenario);
  CHECK(distance(runner.frame(0).highlights.at(0).at.value(), {1, 0}) < 1e-12);
}

TEST_CASE("A highlight of nothing, of two things or of a removed body is refused") {
  const std::string b = "scenario{}\nlocal b = body{name='b', shape=circle{radius=1}}\n";
  CHECK_THAT(error_of(b + "highlight{text='x'}"), Contains("line 3") && Contains("one of body=, joint= and at="));
  CHECK_THAT(error_of(b + "highlight{body=b, at={0, 0}}"), Contains("one of body=, joint= and at="));
  CHECK_THAT(error_of(b + "highlight{at={0, 0}, point={0, 0}}"), Contains("is a point of a body"));
  CHECK_THAT(error_of(b + "highlight{body=b, radius=1}"), Contains("give point="));
  CHECK_THAT(error_of(b + "highlight{joint=b}"), Contains("must be a joint that exists"));
  CHECK_THAT(error_of(b + "highlight{body=b, from=2, to=2}"), Contains("must come after from"));
  CHECK_THAT(error_of(b + "b:remove()\nhighlight{body=b}"), Contains("line 4") && Contains("was removed"));
  CHECK_THAT(error_of(b + "highlight{body=b, from=6}"), Contains("never comes"));
}

TEST_CASE("What is asked of a body that was removed is refused; what was asked before goes with it") {
  const std::string b = "scenario{}\nlocal b = body{name='b', shape=circle{radius=1}}\nb:remove()\n";
  for (const char* word : {"label{body=b, text='x'}", "vector{body=b, of='velocity'}", "trail{body=b}",
                           "ghost{body=b, every=1}", "camera{follow=b}"}) {
    INFO(word);
    CHECK_THAT(error_of(b + word), Contains("line 4") && Contains("body \"b\" was removed"));
  }
}

TEST_CASE("Ghosts are no closer than a tick") {
  const std::string b = "scenario{rate=100, fps=50}\nlocal b = body{shape=circle{radius=1}}\n";
  CHECK_THAT(error_of(b + "ghost{body=b, every=0.009}"),
             Contains("line 3") && Contains("shorter than a tick, which takes 1/100 s"));
  CHECK(error_of(b + "ghost{body=b, every=0.01}").empty());
}

TEST_CASE("Layers may change in the course of the film") {
  auto r = run("layers{at=1, 'bodies', 'mass'} layers{at=2, 'energy'}");
  const auto shows = [](const Frame& frame, Layer layer) {
    return std::find(frame.layers.begin(), frame.layers.end(), layer) != frame.layers.end();
  };
  CHECK(shows(frame_at(r, 99), Layer::joints));
  CHECK_FALSE(shows(frame_at(r, 99), Layer::mass));
  CHECK(shows(frame_at(r, 100), Layer::mass));
  CHECK(shows(frame_at(r, 100), Layer::labels));
  CHECK_FALSE(shows(frame_at(r, 100), Layer::joints));
  CHECK_FALSE(shows(frame_at(r, 200), Layer::mass));
  CHECK(shows(frame_at(r, 200), Layer::energy));
}

TEST_CASE("Layers that do not exist, come in the wrong order or too late are refused") {
  CHECK_THAT(error_of("scenario{}\nlayers{at=1, 'bodys'}"), Contains("line 2") && Contains("\"bodys\""));
  CHECK_THAT(error_of("scenario{}\nlayers{'bodies'}"), Contains("layers") && Contains("at"));
  CHECK_THAT(error_of("scenario{}\nlayers{at=2, 'bodies'}\nlayers{at=2, 'mass'}"),
             Contains("line 3") && Contains("must come after"));
  CHECK_THAT(error_of("scenario{duration=5}\nlayers{at=6, 'bodies'}"), Contains("layers: at = 6 never comes"));
  CHECK_THAT(error_of("scenario{}\nat(1, function() layers{at=2, 'bodies'} end)"), Contains("top level"));
}

TEST_CASE("Islands are found only where a layer shows them, at some time of the film") {
  const std::string text = "scenario{layers={'bodies'}}\nbody{shape=circle{radius=1}}\n";
  const auto island = [](const std::string& scene) {
    const auto scenario = load_text(scene);
    const Runner runner(*scenario);
    return runner.frame(0).snapshot.bodies.at(0).island;
  };
  CHECK(island(text) == 0);
  CHECK(island(text + "layers{at=2, 'islands'}") == 1);
}

TEST_CASE("A newton is drawn as long in every frame: by the weights at the start, or as the scenario says") {
  auto r = run("at(1, function() body{mass=1000, shape=circle{radius=1}} end)");
  const double scale = frame_at(r, 10).force_scale;
  CHECK(scale * 2 * 9.81 == Approx(0.15 * 10));  // one body of 2 kg: 15 % of the height of 10 m
  CHECK(frame_at(r, 300).force_scale == scale);
  CHECK(load_text("scenario{force_scale=0.25}")->picture.force_scale == 0.25);
  CHECK(load_text("scenario{gravity={0, 0}}")->picture.force_scale > 0);
  CHECK_THAT(error_of("scenario{force_scale=0}"), Contains("force_scale") && Contains("positive"));
}

TEST_CASE("The bars of energy are measured by what was reached so far, and by the total at the start") {
  const auto scenario = load_text("scenario{duration=2}\nbody{at={0, 10}, mass=1, shape=circle{radius=1}}");
  Runner runner(*scenario);
  const EnergyExtent first = runner.frame(0).energy;
  CHECK(first.initial_total == Approx(98.1));
  CHECK(first.lowest == 0);
  CHECK(first.highest == Approx(98.1));
  while (!runner.finished()) runner.step();
  const EnergyExtent last = runner.frame(1).energy;
  CHECK(last.initial_total == Approx(98.1));
  CHECK(last.highest == Approx(0.5 * 19.62 * 19.62));
  CHECK(last.lowest == Approx(98.1 - 0.5 * 19.62 * 19.62));
}

TEST_CASE("A plot takes no number so large that the distance of two is none any more") {
  auto r = run("plot{y={huge=function() return time() < 1 and 1e300 or -1.1e300 end}}");
  CHECK_NOTHROW(r.until(99));
  CHECK_THROWS_WITH(r.until(100), Contains("must return a number between -1e300 and 1e300, got -1.1e+300"));
}
