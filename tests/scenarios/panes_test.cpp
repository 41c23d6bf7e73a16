// The word pane: several scenes of one file, side by side.

#include <catch2/catch.hpp>

#include "scenarios/timeline.h"
#include "scene_text.h"

using namespace proofreel;
using Catch::Contains;

namespace {

const std::string fall =
    "scenario{duration=1, rate=60, fps=20, method={substeps=1}}\n"
    "local fast = pane{title='fast', method={integrator='symplectic_euler'}}\n"
    "local fine = pane{title='fine', rate=240, gravity={0,-2}}\n"
    "local b = body{name='b', at={0,10}, shape=circle{radius=0.1}}\n"
    "measure('height', function() return b:position().y end)\n";

std::string alone(const std::string& keys) {
  return "scenario{duration=1, fps=20, " + keys +
         "}\nlocal b = body{name='b', at={0,10}, shape=circle{radius=0.1}}\n"
         "measure('height', function() return b:position().y end)\n";
}

RunReport report_of(const std::string& text) {
  const auto scenario = load_text(text);
  return Runner(*scenario).finish();
}

}  // namespace

TEST_CASE("Every pane moves as the same scene does alone, to the last bit") {
  const RunReport both = report_of(fall);
  const RunReport fast = report_of(alone("rate=60, method={substeps=1, integrator='symplectic_euler'}"));
  const RunReport fine = report_of(alone("rate=240, method={substeps=1}, gravity={0,-2}"));
  REQUIRE(both.measures.size() == 2);
  CHECK(both.measures[0].name == "fast: height");
  CHECK(both.measures[1].name == "fine: height");
  CHECK(both.measures[0].final == fast.measures[0].final);
  CHECK(both.measures[1].final == fine.measures[0].final);
  CHECK(both.measures[1].min == fine.measures[0].min);
}

TEST_CASE("Panes are at the same time in every frame, whatever their rates") {
  const auto scenario = load_text(fall);
  const std::vector<std::int64_t> timeline = film_timeline(*scenario);
  REQUIRE(timeline.size() == 20);
  Runner runner(*scenario);
  for (const std::int64_t tick : timeline) {
    while (runner.tick() < tick) runner.step();
    const Frame frame = runner.frame(0);
    REQUIRE(frame.other_panes.size() == 1);
    CHECK(frame.other_panes[0].snapshot.time == frame.snapshot.time);
    CHECK(frame.other_panes[0].pane_title == "fine");
  }
}

TEST_CASE("The trajectory hash and the samples tell of every pane") {
  std::string other = fall;
  other.replace(other.find("{0,-2}"), 6, "{0,-3}");  // the second pane only
  const RunReport a = report_of(fall), b = report_of(other);
  CHECK(a.trajectory_hash != b.trajectory_hash);
  CHECK(a.state_hash != b.state_hash);
  const auto scenario = load_text(fall);
  Runner runner(*scenario);
  const RunReport report = runner.finish();
  CHECK(measure_names(*scenario) == std::vector<std::string>{"fast: height", "fine: height"});
  REQUIRE(runner.samples().size() == 21);
  CHECK(runner.samples().back().values == std::vector{report.measures[0].final, report.measures[1].final});
}

TEST_CASE("pane{} says which pane is being made, so that one can differ in anything") {
  const auto scenario = load_text(
      "scenario{duration=1}\n"
      "if pane{title='one'} then body{shape=circle{radius=1}} expect('never', function() return false end) end\n"
      "if pane{title='two'} then body{shape=box{width=1, height=1}} body{at={5,0}, shape=circle{radius=1}} end\n");
  CHECK(scenario->scene.bodies.size() == 1);
  REQUIRE(scenario->other_panes.size() == 1);
  CHECK(scenario->other_panes[0]->scene.bodies.size() == 2);
  const RunReport report = Runner(*scenario).finish();
  REQUIRE(report.expectations.size() == 1);
  CHECK(report.expectations[0].text == "one: never");
  CHECK_FALSE(report.all_held());
}

TEST_CASE("A pane whose simulation fails stops the film and is named") {
  const std::string text =
      "scenario{duration=1, rate=60, fps=20}\npane{title='good'}\nlocal bad = pane{title='bad'}\n"
      "local b = body{shape=circle{radius=0.1}}\nif bad then at(0.5, function() b:force({1e308, 0}) b:force({1e308, "
      "0}) end) end\n";
  const auto scenario = load_text(text);
  Runner runner(*scenario);
  CHECK_THROWS_WITH(
      [&] {
        while (!runner.finished()) runner.step();
      }(),
      Contains("pane \"bad\": the simulation stopped"));
  const auto again = load_text(text);
  CHECK_FALSE(Runner(*again).finish().all_held());
}

TEST_CASE("What is set from outside holds in every pane that does not set it itself") {
  const auto scenario = load_text(fall, {{"rate", "120"}});
  CHECK(scenario->scene.rate == 120);
  CHECK(scenario->other_panes[0]->scene.rate == 240);
}

TEST_CASE("Wrong panes are refused with a sentence") {
  const std::string begin = "scenario{duration=1}\n";
  CHECK(error_of(begin + "pane{title='a'}") == "scene.lua: one pane{...} is no split screen: make two or more");
  CHECK_THAT(error_of(begin + "pane{}"), Contains("scene.lua: line 2: pane needs title="));
  CHECK_THAT(error_of(begin + "pane{title='a'}\npane{title='a'}"),
             Contains("scene.lua: line 3: pane: title is that of another"));
  CHECK_THAT(error_of(begin + "pane{title='a', duration=2}"), Contains("unknown key \"duration\""));
  CHECK_THAT(error_of(begin + "pane{title='a', method={substep=2}}"), Contains("did you mean \"substeps\""));
  CHECK_THAT(error_of(begin + "pane{title='a'}\npane{title='b', method={substeps=0}}"),
             Contains("scene.lua: line 3: pane \"b\": method.substeps must lie between 1 and 10000"));
  CHECK_THAT(error_of(begin + "pane{title='a', rate={}}\npane{title='b'}"),
             Contains("pane \"a\": rate must be a whole number"));
  CHECK_THAT(error_of(begin + "pane{title='a', gravity={{}, 1}}"), Contains("gravity cannot be a table"));
  CHECK_THAT(error_of(begin + "if pane{title='a'} then pane{title='b'} end\npane{title='c'}"),
             Contains("must then call pane{...} for the same panes"));
  CHECK_THAT(error_of(begin + "for i = 1, 10 do pane{title='p' .. i} end"), Contains("at most 9 panes"));
  CHECK_THAT(
      error_of(
          "scenario{}\npane{title='a'} pane{title='b'}\ndemonstrate{algorithm='centroid', points={{0,0},{1,0},{0,1}}}"),
      Contains("divides the picture itself"));
}

TEST_CASE("A pane whose rate does not fit the film's frames is refused when filmed") {
  const auto scenario = load_text("scenario{duration=1, rate=60, fps=60}\npane{title='a'}\npane{title='b', rate=90}");
  CHECK_THROWS_WITH(film_timeline(*scenario), Contains("scene.lua: pane \"b\": a film needs") && Contains("90"));
}

TEST_CASE("Saving, resuming and other engines are for one scene, and say so") {
  const auto scenario = load_text(fall);
  CHECK_THROWS_WITH(Runner(*scenario, {10}), Contains("with one scene only, and the file shows 2 side by side"));
  CHECK_THROWS_WITH(Runner(*scenario, make_simulation(scenario->scene)), Contains("with one scene only"));
}

TEST_CASE("What is wrong in one pane only is told as that of this pane, with the line it stands in") {
  const std::string two = "scenario{duration=1}\npane{title='a'}\nlocal b = pane{title='b'}\n";
  CHECK(error_of(two + "if b then error('bad') end") == "scene.lua: line 4: bad (in pane \"b\")");
  CHECK_THAT(error_of("scenario{duration=1}\npane{title='a'}\npane{title='b',\nview={height=-1}}"),
             Catch::StartsWith("scene.lua: line 4: pane \"b\": view.height must be"));
  CHECK_THAT(error_of("scenario{duration=1}\npane{title='a'}\npane{title='b', method={integrator='rk4'}}\n"
                      "body{shape=circle{radius=1}}\nbody{at={3,0}, shape=circle{radius=1}}"),
             Contains("cannot step bodies that may meet") && Catch::EndsWith("(in pane \"b\")"));
  const auto scenario = load_text(two + "if b then at(0.5, function() error('bad') end) end");
  CHECK_THROWS_WITH(Runner(*scenario).finish(), Contains("line 4: bad") && Contains("of pane \"b\", at 0.5 s"));
}

TEST_CASE("Panes that would be films of different lengths, sizes or times are refused") {
  const std::string two = "local a = pane{title='a'}\nlocal b = pane{title='b'}\n";
  const auto refused = [&](const std::string& text, const char* key) {
    CHECK_THAT(error_of(text),
               Contains("pane \"b\": ") && Contains(std::string(key) + " must be that of the first pane"));
  };
  refused(two + "scenario{duration = a and 1 or 2}", "duration");
  refused(two + "scenario{fps = a and 60 or 30}", "fps");
  refused(two + "scenario{size = a and {640, 360} or {320, 180}}", "size");
  refused(two + "scenario{theme = a and 'dark' or 'light'}", "theme");
  refused("scenario{}\n" + two + "if b then freeze{at=1, seconds=1} end", "freeze");
  refused("scenario{}\n" + two + "if b then slow{from=1, to=2, factor=0.5} end", "slow");
  refused("scenario{}\n" + two + "if b then section{at=0, name='s'} end", "section");
  CHECK_NOTHROW(load_text("scenario{}\n" + two + "freeze{at=1, seconds=1} section{at=0, name='s'}"));
}

TEST_CASE("What any pane has for a caption the film shows, and once what several have") {
  const std::string two = "scenario{duration=1}\npane{title='a'}\nlocal b = pane{title='b', rate=480}\n";
  const auto frame_at = [](const std::string& text, std::int64_t tick) {
    const auto scenario = load_text(text);
    Runner runner(*scenario);
    while (runner.tick() < tick) runner.step();
    const Frame frame = runner.frame(0);
    std::vector<std::string> said;
    for (const CaptionView& caption : frame.captions) said.push_back(caption.text);
    return std::pair{said, frame.bands.below};
  };
  const std::string later = "if b then caption{text='only b', from=0.5} end";
  CHECK(frame_at(two + later, 0) == std::pair{std::vector<std::string>{}, true});
  CHECK(frame_at(two + later, 120).first == std::vector<std::string>{"only b"});
  CHECK(frame_at(two + "caption{text='all'}\n" + later, 120).first == std::vector<std::string>{"all", "only b"});
  CHECK(frame_at(two + "if b then at(0.25, function() caption{text='called'} end) end", 72).first ==
        std::vector<std::string>{"called"});
}

TEST_CASE("Expectations that a failed pane leaves open have its name, too") {
  const RunReport report = report_of(
      "scenario{duration=1, rate=60, fps=20}\npane{title='good'}\nlocal bad = pane{title='bad'}\n"
      "local b = body{shape=circle{radius=0.1}}\nexpect('rests', function() return true end)\n"
      "if bad then at(0.5, function() b:force({1e308, 0}) b:force({1e308, 0}) end) end\n");
  REQUIRE(report.expectations.size() == 2);
  CHECK(report.expectations[0].text == "good: rests");
  CHECK(report.expectations[1].text == "bad: rests");
}
