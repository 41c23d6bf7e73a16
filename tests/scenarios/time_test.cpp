#include <catch2/catch.hpp>

#include "scene_text.h"

using namespace proofreel;

namespace {

/// Callbacks note what they are as decimal digits: the measure `log` reads as their order.
const std::string note = "local log = 0\nlocal function note(d) return function() log = log * 10 + d end end\n";
const std::string log = "measure('log', function() return log end)\n";

FakeRun run(const std::string& text) { return FakeRun("scenario{duration=1, rate=100, fps=50}\n" + note + text + log); }

}  // namespace

TEST_CASE("at runs before its tick is stepped") {
  auto r = run("at(0, note(1)) at(0.05, note(2))\n");
  CHECK(r.measure() == 0);
  r.until(1);
  CHECK(r.measure() == 1);
  r.until(5);
  CHECK(r.measure() == 1);
  r.until(6);
  CHECK(r.measure() == 12);
}

TEST_CASE("Times round to the nearest tick") {
  auto r = run("at(0.0149, note(1)) at(0.0151, note(2))\n");
  r.until(2);
  CHECK(r.measure() == 1);
  r.until(3);
  CHECK(r.measure() == 12);
}

TEST_CASE("every first fires after its period, then again and again") {
  auto r = run("every(0.1, note(7))\n");
  r.until(10);
  CHECK(r.measure() == 0);
  r.until(11);
  CHECK(r.measure() == 7);
  r.until(100);
  CHECK(r.measure() == 777777777);
}

TEST_CASE("Periods between ticks do not drift") {
  auto r = FakeRun(
      "scenario{duration=70, rate=10, fps=10}\nlocal n = 0\nevery(0.7 / 3, function() n = n + 1 end)\n"
      "measure('n', function() return n end)");
  r.until(700);
  CHECK(r.measure() == 299);  // the 300th is due at 70 s, when nothing is stepped any more
}

TEST_CASE("Callbacks of one tick run in order of creation") {
  auto r = run("every(0.1, note(1)) at(0.2, note(2)) every(0.2, note(3)) at(0.1, note(4))\n");
  r.until(21);
  CHECK(r.measure() == 14123);
}

TEST_CASE("Callbacks may make callbacks, even for the tick they run in") {
  auto r = run("at(0.1, function() at(time(), note(5)) every(0.1, note(6)) end) at(0.1, note(4))\n");
  r.until(21);
  CHECK(r.measure() == 456);
}

TEST_CASE("A callback cannot be made for the past") {
  CHECK_THAT(
      error_of("scenario{}\nat(0.5, function()\n  at(0.1, print) end)"),
      Catch::Contains("line 3: at(0.1, fn): that time has passed already (in a callback of at or every, at 0.5 s)"));
}

TEST_CASE("time is the tick by the rate, and zero while loading") {
  CHECK(value_of("time()") == 0);
  auto r = FakeRun("scenario{rate=100, fps=50}\nmeasure('t', time)");
  r.until(7);
  CHECK(r.measure() == 0.07);
}

TEST_CASE("The same script twice gives the same hash") {
  const std::string text = R"(
    scenario{duration=0.5, seed=3}
    ground{y=0}
    every(0.05, function()
      body{at={math.random() * 4 - 2, 3}, angle=math.random() * 6, shape=regular{sides=math.random(3, 7), radius=0.2}}
    end))";
  const auto one = load_text(text);
  const auto two = load_text(text);
  const RunReport a = Runner(*one).finish();
  CHECK(a.trajectory_hash == Runner(*two).finish().trajectory_hash);
  const auto other = load_text(text, {{"seed", "4"}});
  CHECK(a.trajectory_hash != Runner(*other).finish().trajectory_hash);
}

TEST_CASE("What a file puts after its own end is refused, for nobody would see or hear of it") {
  const std::string scene = "scenario{duration=5}\n";
  const std::vector<std::pair<std::string, std::string>> late{
      {"at(99, function() end)", "at: t = 99 never comes: the scenario ends at 5 s"},
      {"at(5, function() end)", "at: t = 5 never comes"},
      {"every(5.5, function() end)", "every: dt = 5.5 never comes"},
      {"camera{at=6, height=3}", "camera: at = 6 never comes"},
      {"caption{text='late', from=7}", "caption \"late\": from = 7 never comes"},
      {"slow{from=8, to=9, factor=0.5}", "slow: from = 8 never comes"},
      {"expect('late', function() return true end, {at=99})", "expect \"late\" comes after the end of the scenario"}};
  for (const auto& [words, sentence] : late) {
    CAPTURE(words);
    CHECK_THAT(error_of(scene + words), Catch::Matchers::Contains("scene.lua: " + sentence));
    CHECK(error_of("scenario{duration=100}\n" + words, {{"duration", "0.1"}}).empty());
  }
  CHECK(error_of(scene + "at(4.99, function() end) caption{text='on', from=4.9, to=99} camera{at=4, over=9, height=3}")
            .empty());
  CHECK(error_of("scenario{duration=0.1}\nevery(0.05, function() at(time() + 9, function() end) end)").empty());
}
