#include <catch2/catch.hpp>

#include "scene_text.h"

using namespace proofreel;
using Catch::Contains;
using Catch::StartsWith;

namespace {

/// Runs the text to its end.
std::unique_ptr<Scenario> run_text(const std::string& text) {
  auto scenario = load_text(text);
  Runner runner(*scenario);
  while (!runner.finished()) runner.step();
  // Measures are looked at while the simulation is there: keep what they said last.
  for (std::size_t i = 0; i < scenario->measures.size(); ++i) {
    INFO(scenario->measures[i].name);
    CHECK(runner.samples().back().values[i] == 1);
  }
  return scenario;
}

const std::string two_boxes = R"(
    ground{y=0}
    local a = body{name='a', at={0, 0.5}, shape=box{width=1, height=1}}
    local b = body{name='b', at={3, 0.5}, shape=box{width=1, height=1}}
)";

}  // namespace

TEST_CASE("on_sleep hears whenever its body falls asleep, and of nobody else's sleep") {
  run_text("scenario{duration=3}" + two_boxes + R"(
    local told, who = 0, nil
    on_sleep(a, function(e) told = told + 1 who = e.body end)
    at(1, function() assert(a:asleep() and b:asleep()) a:wake() assert(not a:asleep() and b:asleep()) end)
    at(1.2, function() assert(not a:asleep()) end)
    measure('told twice', function() return told == 2 and who == a and 1 or 0 end)
    measure('at rest', function() return a:asleep() and a:velocity().y == 0 and 1 or 0 end))");
}

TEST_CASE("A list of effects that names sleeping lets bodies sleep, without it nobody does") {
  run_text("scenario{duration=1, effects={'gravity', 'contacts', 'friction', 'sleeping'}}" + two_boxes +
           "measure('asleep', function() return a:asleep() and 1 or 0 end)");
  run_text("scenario{duration=1}" + two_boxes + "measure('awake', function() return a:asleep() and 0 or 1 end)");
}

TEST_CASE("A list of effects that omits sleeping is warned of where on_sleep is used, at the top or in a callback") {
  const std::string call =
      GENERATE("on_sleep(a, print)", "at(0.1, function() on_sleep(a, print) on_sleep(b, print) end)");
  const auto scenario =
      run_text("scenario{duration=1, effects={'gravity', 'contacts', 'friction'}}" + two_boxes + call);
  REQUIRE(scenario->warnings.size() == 1);
  CHECK_THAT(scenario->warnings[0], Contains("the scene calls for \"sleeping\", but the list of effects omits it"));
}

TEST_CASE("on_sleep in a callback lets bodies sleep from then on") {
  run_text("scenario{duration=3}" + two_boxes + R"(
    local told
    at(1.5, function() assert(not a:asleep()) on_sleep(b, function() told = time() end) end)
    measure('told', function() return (time() < 3 or told and told > 1.9) and 1 or 0 end))");
}

TEST_CASE("A handler of on_sleep may remove its body") {
  run_text("scenario{duration=2}" + two_boxes + R"(
    on_sleep(a, function(e) e.body:remove() end)
    on_sleep(a, function(e) error('it is gone') end)
    on_sleep(b, function(e) b:impulse({0, 5}) end)
    measure('up again', function() return 1 end))");
}

TEST_CASE("Wrong use of sleep is told with the line") {
  const auto [line, problem] = GENERATE(table<std::string, std::string>({
      {"on_sleep(print)", "on_sleep needs a body and a function"},
      {"on_sleep(nil, print)", "on_sleep(body, fn): body must be a body, got nothing"},
      {"on_sleep(b, 3)", "on_sleep(body, fn): fn"},
      {"on_sleep(world, print)", "on_sleep(body, fn): body must be a body of the scene, not the world"},
      {"on_sleep(ground{y=0}, print)", "never sleeps, for it is not dynamic"},
      {"b:remove() on_sleep(b, print)", "body \"b\" was removed"},
      {"b:remove() b:wake()", "body \"b\" was removed"},
      {"b:remove() b:asleep()", "body \"b\" was removed"},
      {"world:wake()", "the world cannot be changed (b:wake)"},
      {"ground{y=0}:wake()", "which is not dynamic"},
      {"measure('m', function() b:wake() return 1 end)", "b:wake acts on the scene"},
      {"measure('m', function() on_sleep(b, print) return 1 end)", "on_sleep acts on the scene"},
  }));
  INFO(line);
  CHECK_THAT(error_of("scenario{}\nlocal b = body{name='b', shape=circle{radius=1}}\n" + line),
             StartsWith("scene.lua: line 3: ") && Contains(problem));
}

TEST_CASE("Sleep and an integrator that cannot leave bodies out are refused together") {
  CHECK_THAT(
      error_of("scenario{method={integrator='rk4'}}\nlocal b = body{shape=circle{radius=1}}\non_sleep(b, print)"),
      Contains("cannot leave out bodies that sleep: use \"verlet\" or \"symplectic_euler\""));
}
