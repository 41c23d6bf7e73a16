#include <catch2/catch.hpp>

#include "scene_text.h"

using namespace proofreel;
using Catch::Contains;

TEST_CASE("Measures are sampled at every frame and at the last tick") {
  FakeRun r("scenario{duration=0.105, rate=100, fps=25}\nmeasure('t', function() return time() end)");
  const RunReport report = r.runner->finish();
  CHECK(report.ticks == 11);
  std::vector<std::int64_t> ticks;
  for (const Sample& sample : r.runner->samples()) ticks.push_back(sample.tick);
  CHECK(ticks == std::vector<std::int64_t>{0, 4, 8, 11});
  CHECK(report.measures[0].min == 0);
  CHECK(report.measures[0].max == 0.11);
  CHECK(report.measures[0].final == 0.11);
  CHECK_FALSE(report.measures[0].max_error);
}

TEST_CASE("A function of reference is compared at every sample") {
  FakeRun r(
      "scenario{duration=1, rate=100, fps=50}\nmeasure('t', function() return time() end)\n"
      "reference('t', function(t) return t * 0.5 end)");
  CHECK(r.runner->finish().measures[0].max_error == 0.5);
}

TEST_CASE("A table of references is compared at its own times only, even between samples") {
  FakeRun r(
      "scenario{duration=1, rate=100, fps=50}\nmeasure('t', function() return time() end)\n"
      "reference('t', {{0, 0}, {0.51, 0.41}, {5, 100}})");
  const RunReport report = r.runner->finish();
  CHECK(report.measures[0].max_error == Approx(0.1).epsilon(1e-12));
  CHECK(r.runner->samples().size() == 51);
}

TEST_CASE("A reference needs its measure") {
  CHECK_THAT(error_of("scenario{}\nmeasure('speed', time)\nreference('sped', {{0, 1}})"),
             Contains("reference \"sped\": there is no such measure, did you mean \"speed\"?"));
}

TEST_CASE("Measures must return finite numbers, and say where they do not") {
  CHECK_THAT(error_of("scenario{}\n\nmeasure('m', function() end)"),
             Contains("scene.lua: line 3: must return a number, got nothing (in measure \"m\", at 0 s)"));
  CHECK_THAT(error_of("scenario{}\nmeasure('m', function() return time() < 0.5 and 0 or 1/0 end)"),
             Contains("line 2: must return a finite number, got inf (in measure \"m\", at 0.5 s)"));
  CHECK_THAT(error_of("scenario{}\nexpect('e', function() return 1 end)"),
             Contains("must return true or false, got 1"));
  CHECK_THAT(error_of("scenario{}\nplot{y={p = function() return 'x' end}}"), Contains("plot curve \"p\""));
}

TEST_CASE("Whoever measures may look but not act") {
  const std::string act = GENERATE("b:impulse{1, 0}", "b:remove()", "b:set{spin=1}", "body{shape=circle{radius=1}}",
                                   "at(3, print)", "caption{text='x'}", "trail{body=b}");
  CHECK_THAT(error_of("scenario{}\nlocal b = body{shape=circle{radius=1}}\nmeasure('m', function() " + act + " end)"),
             Contains("may only look"));
}

TEST_CASE("Measures and expectations belong at the top level") {
  const std::string word = GENERATE("measure('m', print)", "expect('e', print)", "reference('m', print)",
                                    "slow{from=0, to=1, factor=0.5}", "include 'x.lua'");
  CHECK_THAT(error_of("scenario{}\nat(0.1, function() " + word + " end)"), Contains("belongs at the top level"));
}

TEST_CASE("An expectation for always is looked at in the beginning and after every tick") {
  FakeRun held("scenario{duration=1, rate=100, fps=50}\nexpect('e', function() return true end, {always=true})");
  const RunReport good = held.runner->finish();
  CHECK(good.expectations[0].held);
  CHECK(good.expectations[0].tick == 100);
  CHECK(good.all_held());
  FakeRun first("scenario{}\nexpect('e', function() return time() > 0 end, {always=true})");
  CHECK_FALSE(first.runner->finish().expectations[0].held);
  FakeRun later(
      "scenario{duration=1, rate=100, fps=50}\nexpect('e', function() return time() < 0.37 end, {always=true})");
  const RunReport bad = later.runner->finish();
  CHECK_FALSE(bad.all_held());
  CHECK(bad.expectations[0].tick == 37);
}

TEST_CASE("Other expectations are looked at once, at their time or at the end") {
  FakeRun r(
      "scenario{duration=1, rate=100, fps=50}\n"
      "expect('at', function() return time() == 0.33 end, {at=0.33})\n"
      "expect('finally', function() return time() == 1 end, {finally=true})\n"
      "expect('default', function() return time() == 1 end)");
  const RunReport report = r.runner->finish();
  CHECK(report.all_held());
  CHECK(report.expectations[0].tick == 33);
  CHECK(report.expectations[2].tick == 100);
}

TEST_CASE("An expectation after the end is an error, unless the command line cut the scenario short") {
  const std::string text = "scenario{duration=5}\nexpect('e', function() return false end, {at=4})";
  CHECK(error_of(text, {{"duration", "1"}}).empty());
  CHECK_THAT(load_text(text, {{"duration", "1"}})->warnings.at(0), Contains("comes after the end"));
  CHECK_THAT(error_of("scenario{duration=3}\nexpect('e', print, {at=4})"), Contains("comes after the end"));
}

TEST_CASE("A simulation that fails stops the run and fails what was not looked at") {
  const std::string text =
      "scenario{duration=1, rate=100, fps=50}\nbody{name='ball', shape=circle{radius=1}}\n"
      "expect('early', function() return true end, {at=0.1})\nexpect('late', function() return true end)";
  FakeRun r(text);
  r.simulation->fails_at = 30;
  const RunReport report = r.runner->finish();
  CHECK(report.ticks == 30);
  CHECK(report.failure->stage == "the drift");
  CHECK(report.expectations[0].held);
  CHECK_FALSE(report.expectations[1].held);
  CHECK_FALSE(report.all_held());
  FakeRun stepped(text);
  stepped.simulation->fails_at = 3;
  CHECK_THROWS_WITH(stepped.until(5),
                    Contains("stopped at tick 3 (0.03 s)") && Contains("the drift") && Contains("body \"ball\""));
}

TEST_CASE("The trajectory hash chains the states of all ticks") {
  FakeRun r("scenario{duration=0.03, rate=100, fps=50}");
  std::uint64_t chain = chained_hash(0, r.simulation->state_hash());
  CHECK(r.runner->trajectory_hash() == chain);
  while (!r.runner->finished()) {
    r.runner->step();
    chain = chained_hash(chain, r.simulation->state_hash());
  }
  CHECK(r.runner->finish().trajectory_hash == chain);
}

TEST_CASE("Energy is what the simulation says, while loading too") {
  CHECK(value_of("energy().total", "body{at={0, 2}, mass=3, shape=circle{radius=1}, velocity={2, 0}}") ==
        Approx(0.5 * 3 * 4 + 3 * 9.81 * 2));
  CHECK(is_true("e.work == 0", "e = energy()"));
  CHECK(is_true("e.total == e.kinetic + e.potential", "body{shape=circle{radius=1}, spin=2}\ne = energy()"));
}
