#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>

#include "engine/archive.h"
#include "engine/state_hash.h"
#include "scenarios/replay.h"
#include "scenarios/runner.h"
#include "tests/scenarios/scene_text.h"

using namespace proofreel;
using Catch::Matchers::Contains;

namespace {

struct Saved {
  RunReport report;
  std::vector<Sample> samples;
  std::vector<SavedRun> runs;
};

Saved run_and_save(Scenario& scenario, const std::vector<std::int64_t>& ticks) {
  Runner runner(scenario, ticks);
  Saved saved;
  saved.report = runner.finish();
  saved.samples = runner.samples();
  for (const std::int64_t tick : ticks) saved.runs.push_back(saved_run_in(bytes_of(runner.saved(tick)), "saved"));
  return saved;
}

Saved run_and_save(const std::string& text, const std::vector<std::int64_t>& ticks) {
  return run_and_save(*load_text(text), ticks);
}

RunReport resumed(const std::string& text, const SavedRun& run) {
  const auto scenario = load_text(text);
  return Runner(*scenario, run, "saved").finish();
}

/// Why the run cannot be resumed; empty when it can.
std::string refusal(const std::string& text, const SavedRun& run, const std::vector<Override>& overrides = {}) {
  try {
    const auto scenario = load_text(text, overrides);
    Runner(*scenario, run, "saved").finish();
  } catch (const ScenarioError& error) {
    return error.what();
  }
  return {};
}

/// Ticks of a run that look arbitrary and are always the same.
std::vector<std::int64_t> some_ticks(std::int64_t last, std::uint64_t seed) {
  std::vector<std::int64_t> ticks;
  for (std::uint64_t i = 1; i <= 2; ++i)
    ticks.push_back(static_cast<std::int64_t>((seed / i) % static_cast<std::uint64_t>(last)));
  std::sort(ticks.begin(), ticks.end());
  return ticks;
}

const std::string busy = R"lua(
  scenario { duration = 1, rate = 120, fps = 60 }
  ground { y = 0 }
  local ball = body { at = {0, 1}, shape = circle { radius = 0.2 }, restitution = 0.7 }
  every(0.1, function()
    local x = math.random() - 0.5
    local made = body { at = {x, 2}, shape = box { width = 0.2, height = 0.2 } }
    spring { ball, made, from = ball:position(), to = {x, 2}, stiffness = 5, damping = 0.1 }
  end)
  every(0.3, function() ball:impulse({0.1, 1}) end)
  on_contact(nil, nil, function(e)
    if e.a ~= world and e.a ~= ball and e.b ~= ball and e.impulse > 0.12 then e.b:set { velocity = {0, 1} } end
  end)
  at(0.5, function() ball:set { shape = box { width = 0.3, height = 0.3 } } end)
  at(0.95, function() ball:remove() end)
  measure("energy", function() return energy().total end)
)lua";

}  // namespace

TEST_CASE("Every scenario goes on from any tick as if it had never stopped, here and in another process") {
  for (const std::string& path : all_scenarios()) {
    INFO(path);
    const auto scenario = load_scenario(path, shortened(path));
    if (!scenario->other_panes.empty()) continue;  // which are saved one by one, as files of their own
    const std::vector<std::int64_t> ticks = some_ticks(scenario->ticks(), hash_of(path.data(), path.size()));
    const Saved unbroken = run_and_save(*scenario, ticks);
    for (const SavedRun& run : unbroken.runs) {
      const auto again = load_scenario(path, shortened(path));
      const RunReport report = Runner(*again, run, "saved").finish();
      CHECK(report.trajectory_hash == unbroken.report.trajectory_hash);
      CHECK(report.state_hash == unbroken.report.state_hash);
    }
    const auto moving = load_scenario(path, shortened(path));
    Runner runner(*moving);
    for (const std::int64_t tick : ticks) {
      while (runner.tick() < tick) runner.step();
      runner.move_to(make_simulation(moving->scene));
    }
    CHECK(runner.finish().trajectory_hash == unbroken.report.trajectory_hash);
  }
}

TEST_CASE("Commands of a tick come again in their order, before its step and after it") {
  std::vector<std::int64_t> ticks;
  for (std::int64_t tick = 0; tick <= 120; tick += 4) ticks.push_back(tick);
  const Saved unbroken = run_and_save(busy, ticks);
  for (const SavedRun& run : unbroken.runs) {
    INFO("from tick " << run.tick);
    const RunReport report = resumed(busy, run);
    REQUIRE(report.trajectory_hash == unbroken.report.trajectory_hash);
    REQUIRE(report.measures[0].final == unbroken.report.measures[0].final);
    REQUIRE(report.initial_energy.total() == unbroken.report.initial_energy.total());
    REQUIRE(report.resumed_at == run.tick);
  }
}

TEST_CASE("Measures speak of what is left") {
  const Saved unbroken = run_and_save(busy, {60});
  const auto scenario = load_text(busy);
  Runner runner(*scenario, unbroken.runs[0], "saved");
  const RunReport report = runner.finish();
  std::vector<double> left;
  for (const Sample& sample : unbroken.samples) {
    if (sample.tick >= 60) left.push_back(sample.values[0]);
  }
  REQUIRE(runner.samples().size() == left.size());
  for (std::size_t i = 0; i < left.size(); ++i) REQUIRE(runner.samples()[i].values[0] == left[i]);
  REQUIRE(report.measures[0].min == *std::min_element(left.begin(), left.end()));
  REQUIRE(report.measures[0].max == *std::max_element(left.begin(), left.end()));
}

TEST_CASE("A simulation in use may be exchanged at any tick under the same script") {
  const std::uint64_t expected = run_and_save(busy, {}).report.trajectory_hash;
  const auto scenario = load_text(busy);
  Runner runner(*scenario);
  while (!runner.finished()) {
    runner.move_to(make_simulation(scenario->scene));
    runner.step();
  }
  REQUIRE(runner.finish().trajectory_hash == expected);
}

TEST_CASE("What can see a variable that changed is not known after resuming, all else is") {
  const auto changed_for = [](const std::string& script) {
    const std::string text = "scenario{duration=1, rate=60}\nlocal b = body{shape=circle{radius=1}}\n" + script;
    return run_and_save(text, {30}).runs[0].changed_variables.at(0);
  };
  // A constant that a callback sees too, and a variable that changed before and was changed back.
  CHECK(changed_for("local r = 2\nat(0.7, function() b:impulse{r, 0} end)\n"
                    "measure('m', function() return r * b:position().x end)")
            .empty());
  CHECK(changed_for("local r = 2\nat(0.1, function() r = 3 end)\nat(0.2, function() r = 2 end)\n"
                    "measure('m', function() return r end)")
            .empty());
  // Changed: by a callback, within a table, behind another function, by the measure itself, as a global.
  CHECK(changed_for("local hits = 0\nat(0.7, function() hits = 1 end)\nmeasure('m', function() return hits end)") ==
        "hits");
  CHECK(changed_for("local t = {{n=0}}\nat(0.1, function() t[1].n = 1 end)\nmeasure('m', function() return #t end)") ==
        "t");
  CHECK(changed_for("local hits = 0\nlocal function f() return hits end\nat(0.7, function() hits = 1 end)\n"
                    "measure('m', function() return f() end)") == "hits");
  CHECK(changed_for("local top = 0\nmeasure('m', function() top = math.max(top, time()) return top end)") == "top");
  CHECK(changed_for("hits = 0\nat(0.7, function() hits = 1 end)\nmeasure('m', function() return hits end)") == "hits");
  // Set by a callback, and set back by the measure that has seen it.
  CHECK(changed_for("local hit = false\nevery(0.1, function() hit = true end)\n"
                    "measure('m', function() local h = hit; hit = false; return h and 1 or 0 end)") == "hit");
  // Only its reference can see it.
  CHECK(changed_for("local shift = 0\nat(0.7, function() shift = 1 end)\nmeasure('m', function() return 0 end)\n"
                    "reference('m', function(t) return shift end)") == "shift");
}

TEST_CASE("A measure that is not known has no figures, and an expectation neither holds nor fails") {
  const std::string text =
      "scenario{duration=1, rate=60}\nlocal b, n = body{shape=circle{radius=1}}, 0\nevery(0.1, function() n = n + 1 "
      "end)\n"
      "measure('n', function() return n end)\nmeasure('x', function() return b:position().x end)\n"
      "expect('counted', function() return n == 10 end)\n"
      "expect('counted early', function() return n == 2 end, {at=0.25})\n"
      "expect('few', function() return n < 3 end, {at=0.4})\n"
      "expect('always few', function() return n < 100 end, {always=true})\n"
      "expect('falls', function() return b:position().y < 0 end)";
  const Saved saved = run_and_save(text, {30});
  const auto scenario = load_text(text);
  Runner runner(*scenario, saved.runs[0], "saved");
  const RunReport report = runner.finish();
  CHECK(report.measures[0].unknown_for == "n");
  CHECK(report.measures[1].unknown_for.empty());
  CHECK(std::isnan(runner.samples().back().values[0]));
  CHECK(report.expectations[0].unknown_for == "n");
  CHECK_FALSE(report.expectations[0].failed());
  CHECK(report.expectations[1].unknown_for.empty());  // it held in the saved run, before
  CHECK(report.expectations[1].held);
  CHECK(report.expectations[2].failed());
  CHECK(report.expectations[3].unknown_for == "n");
  CHECK(report.expectations[4].held);
  CHECK_FALSE(report.all_held());
}

TEST_CASE("An expectation that failed before stays failed, one that fails later fails") {
  const std::string text =
      "scenario{duration=1, rate=60}\nlocal b = body{at={0, 5}, shape=circle{radius=1}}\n"
      "expect('early', function() return time() > 0.2 end, {always=true})\n"
      "expect('late', function() return time() < 0.8 end, {always=true})";
  const Saved saved = run_and_save(text, {30});
  const RunReport report = resumed(text, saved.runs[0]);
  for (std::size_t i = 0; i < 2; ++i) {
    CHECK(report.expectations[i].failed());
    CHECK(report.expectations[i].tick == saved.report.expectations[i].tick);
  }
}

TEST_CASE("Scripts know the bodies their callbacks made before") {
  const std::string text =
      "scenario{duration=1, rate=60}\nground{y=0}\n"
      "at(0.1, function() body{name='late', at={0, 0.5}, shape=circle{radius=0.5}} end)\n"
      "at(0.6, function() body{name='later', at={3, 0.5}, shape=circle{radius=0.5}} end)\n"
      "measure('weight', function() local sum = 0\n"
      "  for i, c in ipairs(contacts(world)) do sum = sum + #tostring(c.other) end return sum end)";
  const Saved saved = run_and_save(text, {30});
  REQUIRE(resumed(text, saved.runs[0]).measures[0].final == saved.report.measures[0].final);
}

TEST_CASE("A force field that can see a variable that changes cannot be saved") {
  const std::string text =
      "scenario{duration=1, rate=60}\nbody{shape=circle{radius=1}}\nlocal push = 0\n"
      "field(function() return push, 0 end)\nat(0.5, function() push = 3 end)";
  const auto scenario = load_text(text);
  Runner runner(*scenario, {15});
  runner.finish();
  CHECK_THROWS_WITH(runner.saved(15), Contains("a force field can see the variable \"push\""));
  const std::string constant =
      "scenario{duration=1, rate=60}\nbody{shape=circle{radius=1}}\nlocal push = 2\n"
      "field(function(x, y, vx, vy, t) return push * vy, t end)";
  const Saved saved = run_and_save(constant, {15});
  CHECK(resumed(constant, saved.runs[0]).trajectory_hash == saved.report.trajectory_hash);
}

TEST_CASE("Whatever does not fit is refused with the reason") {
  const std::string head = "scenario{duration=1, rate=60, gravity={0, -9}}\n";
  const std::string lua = head + "local b = body{shape=circle{radius=1}}\n";
  const std::string calling = lua + "every(0.25, function() b:impulse{1, 0} end)";
  const SavedRun run = run_and_save(calling, {30}).runs[0];
  CHECK(refusal(calling, run).empty());
  CHECK_THAT(refusal(calling + " ", run), Contains("saved cannot be resumed: ") && Contains("text is another one"));
  CHECK_THAT(refusal(calling, run, {{"substeps", "4"}}),
             Contains("saved with no --set, and now there is --set method.substeps=4"));
  CHECK_THAT(refusal(calling, run, {{"duration", "2"}}), Contains("callbacks were not logged beyond t=1 s"));
  CHECK(refusal(calling, run, {{"duration", "0.75"}}).empty());
  CHECK_THAT(refusal(calling, run, {{"duration", "0.25"}}), Contains("goes on from t=0.5 s, after the end"));
  const SavedRun quiet = run_and_save(lua, {30}).runs[0];
  CHECK(refusal(lua, quiet, {{"duration", "2"}}).empty());
  SavedRun other = run;
  other.state[40] ^= std::byte{1};
  CHECK_THAT(refusal(calling, other), Contains("the state in it is damaged"));
  other = run;
  other.log[0].command = RemoveBody{BodyId{9}};
  CHECK_THAT(refusal(calling, other), Contains("a command in it makes no sense"));
}

TEST_CASE("A file that is included counts as text of the scenario") {
  const ScratchFolder folder;
  const std::string path = folder.write("scene.lua", "scenario{duration=1, rate=60}\ninclude 'ball.lua'");
  const std::string ball = "body{shape=circle{radius=1}}";
  folder.write("ball.lua", ball);
  const SavedRun run = run_and_save(*load_scenario(path, {}), {30}).runs[0];
  CHECK_NOTHROW(Runner(*load_scenario(path, {}), run, "saved"));
  folder.write("ball.lua", ball + " ");
  const auto changed = load_scenario(path, {});
  CHECK_THROWS_WITH(Runner(*changed, run, "saved"), Contains("text is another one"));
}

TEST_CASE("A run that fails before the time to save at cannot be saved") {
  const auto scenario = load_text(
      "scenario{duration=1, rate=60}\nlocal b = body{shape=circle{radius=1}}\n"
      "at(0.25, function() for i = 1, 3 do b:force{1e308, 0} end end)");
  Runner runner(*scenario, {10, 40});
  REQUIRE(runner.finish().failure);
  CHECK_NOTHROW(runner.saved(10));
  CHECK_THROWS_WITH(runner.saved(40), Contains("stopped before the time to save at"));
}

TEST_CASE("Shortened, damaged and foreign files are refused") {
  const SavedRun run = run_and_save(busy, {60}).runs[0];
  const std::vector<std::byte> bytes = bytes_of(run);
  for (std::size_t length = 0; length < bytes.size(); length += 1 + bytes.size() / 40)
    REQUIRE_THROWS_AS(saved_run_in(std::span(bytes).first(length), "f"), ScenarioError);
  for (std::size_t at = 0; at < bytes.size(); at += 1 + bytes.size() / 40) {
    std::vector<std::byte> changed = bytes;
    changed[at] ^= std::byte{4};
    REQUIRE_THROWS_AS(saved_run_in(changed, "f"), ScenarioError);
  }
  std::vector<std::byte> newer = bytes;
  newer[sizeof(Mark)] = std::byte{9};
  CHECK_THROWS_WITH(saved_run_in(newer, "f"), "f cannot be resumed: it was written by a newer version of this program");
  CHECK_THROWS_WITH(saved_run_in({}, "f"), "f cannot be resumed: it was not written by this program");
}

TEST_CASE("A resumed run that ends elsewhere than the saved one says so") {
  SavedRun run = run_and_save(busy, {60}).runs[0];
  auto scenario = load_text(busy);
  Runner(*scenario, run, "saved").finish();
  CHECK(scenario->warnings.empty());
  run.last_trajectory_hash ^= 1U;
  scenario = load_text(busy);
  Runner(*scenario, run, "saved").finish();
  CHECK_THAT(scenario->warnings.at(0), Contains("the motion is not that of the saved run"));
}

TEST_CASE("A simulation that offers no saving is not moved from or to") {
  const auto scenario = load_text(busy);
  Runner engine(*scenario);
  CHECK_THROWS_WITH(engine.move_to(std::make_unique<FakeSimulation>(scenario->scene)),
                    Contains("cannot be taken up by this kind of simulation"));
  FakeRun fake("scenario{}\nbody{shape=circle{radius=1}}");
  CHECK_THROWS_WITH(fake.runner->move_to(make_simulation(fake.scenario->scene)),
                    Contains("this kind of simulation cannot be saved"));
}

TEST_CASE("Commands that make no sense are told from those that do") {
  const auto scenario = load_text("scenario{}\nlocal b = body{shape=circle{radius=1}}\nrevolute{world, b, at={0, 0}}");
  const auto simulation = make_simulation(scenario->scene);
  const BodyId none{7};
  const auto sensible = [&](const Command& command) { return makes_sense(command, *simulation); };
  CHECK(sensible(ApplyForce{BodyId{1}, {1, 2}, {}}));
  CHECK(sensible(RemoveJoint{JointId{0}}));
  CHECK_FALSE(sensible(ApplyForce{none, {1, 2}, {}}));
  CHECK_FALSE(sensible(ApplyImpulse{BodyId::world, {1, 2}, {}}));
  CHECK_FALSE(sensible(ApplyTorque{BodyId{1}, NAN}));
  CHECK_FALSE(sensible(RemoveBody{BodyId::world}));
  CHECK_FALSE(sensible(RemoveJoint{JointId{1}}));
  CHECK_FALSE(sensible(CreateBody{}));
  ChangeBody change;
  change.body = BodyId{1};
  CHECK(sensible(change));
  change.shapes = std::vector<ShapeDef>(1);
  CHECK_FALSE(sensible(change));
  JointDef gear;
  gear.kind = JointKind::gear;
  gear.second = JointId{3};
  CHECK_FALSE(sensible(CreateJoint{gear}));
}
