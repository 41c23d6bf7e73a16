#include "lab/grid.h"

#include <catch2/catch.hpp>

#include "lab/grid_table.h"
#include "lab/timed_simulation.h"
#include "render/png.h"
#include "tests/lab/grid_scenes.h"
#include "tests/lab/lab_scenes.h"

namespace proofreel {
namespace {

using namespace test;
using Catch::Matchers::Contains;

Grid grid_of_size(std::size_t rows, std::size_t columns) {
  Grid grid;
  grid.rows.resize(rows);
  grid.columns.resize(columns);
  grid.runs.resize(rows * columns);
  return grid;
}

TEST_CASE("A run stands when every expectation holds", "[grid]") {
  const RunResult r = GridFolder().result_of(fall(expecting("it falls", true) + expecting("quality: well", true)));
  REQUIRE(r.standing == Standing::stands);
  REQUIRE(r.why.empty());
  REQUIRE_FALSE(r.at_s);
  REQUIRE(r.simulated_s == 0.5);
  REQUIRE(r.cost_ms().value() > 0);
  REQUIRE(r.trajectory_hash.size() == 16);
  REQUIRE(r.energy_drift_j.value() < 1e-9);
}

TEST_CASE("A run degrades when nothing but quality is missed", "[grid]") {
  const RunResult r = GridFolder().result_of(fall(expecting("it falls", true) + expecting("quality: well", false)));
  REQUIRE(r.standing == Standing::degrades);
  REQUIRE(r.why == "at 0.5 s: quality: well");
  REQUIRE(r.at_s == 0.5);
}

TEST_CASE("A run fails when anything else is missed, and that is told first", "[grid]") {
  const std::string early = "expect(\"quality: slow\", function() return time() < 0.1 end, {always = true})\n";
  const std::string grave = "expect(\"stays up\", function() return time() < 0.2 end, {always = true})\n";
  const RunResult r = GridFolder().result_of(fall(early + grave));
  REQUIRE(r.standing == Standing::fails);
  REQUIRE(r.why == "at 0.2 s: stays up; at 0.1 s: quality: slow");
  REQUIRE(r.at_s == 0.2);
}

TEST_CASE("A simulation that loses its numbers fails, whatever is expected, and has no picture", "[grid]") {
  const std::string blow = "at(0.25, function() for i = 1, 9 do ball:impulse({1e308, 0}) end end)\n";
  const RunResult r = GridFolder().result_of(fall(blow + expecting("quality: well", true)));
  REQUIRE(r.standing == Standing::fails);
  REQUIRE_THAT(r.why, Contains("became infinite or not a number"));
  REQUIRE(r.at_s.value() == Approx(0.25).margin(0.02));
  REQUIRE(r.still.empty());
}

TEST_CASE("What a method or a peer does not do is not offered, with its reason", "[grid]") {
  const std::string two = fall("body { at = {3, 5}, shape = circle { radius = 0.5 } }\n" + expecting("it falls", true));
  const RunResult refused = GridFolder().result_of(two, {}, {{"integrator", "rk4"}});
  REQUIRE(refused.standing == Standing::not_offered);
  REQUIRE_THAT(refused.why, Contains("rk4"));
  REQUIRE_FALSE(refused.cost_ms());

  const std::string rolling = "ball:set{rolling_resistance = 0.1}\n" + expecting("it falls", true);
  const RunResult unknown = GridFolder().result_of(fall(rolling), Peer::chipmunk);
  REQUIRE(unknown.standing == Standing::not_offered);
  REQUIRE_THAT(unknown.why, Contains("rolling resistance, which Chipmunk does not know"));

  const std::string later = "at(0.25, function() motor{world, ball, speed = 1, max_torque = 1} end)\n";
  const RunResult late = GridFolder().result_of(fall(later + expecting("it falls", true)), Peer::box2d);
  REQUIRE(late.standing == Standing::not_offered);
  REQUIRE_THAT(late.why, Contains("at 0.25 s of scene time") && Contains("which Box2D does not know"));
}

TEST_CASE("A script that errs on the way, or at once, is a failure that names its line", "[grid]") {
  const RunResult later = GridFolder().result_of(fall("at(0.25, function() nothing() end)\n" + expecting("x", true)));
  REQUIRE(later.standing == Standing::fails);
  REQUIRE_THAT(later.why, Contains("line 3") && Contains("nothing"));
  REQUIRE(later.at_s == 0.25);
  const RunResult soon =
      GridFolder().result_of(fall("measure(\"m\", function() nothing() end)\n" + expecting("x", true)));
  REQUIRE(soon.standing == Standing::fails);
  REQUIRE_THAT(soon.why, Contains("line 3"));
}

TEST_CASE("A run that takes too long is stopped, and done again only with more time", "[grid]") {
  const GridFolder folder;
  const std::string endless =
      "scenario { duration = 1e5, rate = 1000 }\nground { y = 0 }\n"
      "for i = 1, 50 do body { at = {0, i}, shape = box { width = 1, height = 1 } } end\n";
  const Grid grid = folder.grid_of({endless + expecting("it ends", true)});
  const auto none = [](std::int64_t, std::int64_t) {};
  const RunResult r = work_off(grid, folder.work(0.1), none).front();
  REQUIRE(r.standing == Standing::too_slow);
  REQUIRE_THAT(r.why, Contains("after 0.1 s of steps"));
  REQUIRE(r.simulated_s > 0);
  REQUIRE(r.simulated_s < 1e5);
  REQUIRE_FALSE(r.cost_ms());

  std::int64_t done_again = 0;
  const auto count = [&](std::int64_t, std::int64_t total) { done_again = total; };
  work_off(grid, folder.work(0.1), count);
  REQUIRE(done_again == 0);
  work_off(grid, folder.work(0.15), count);
  REQUIRE(done_again == 1);
}

TEST_CASE("A run whose script takes most of its time is stopped too, and says so", "[grid]") {
  const std::string busy = "expect(\"x\", function() for i = 1, 2e5 do end return true end, {always = true})\n";
  const RunResult r = GridFolder().result_of(fall(busy), {}, {{"duration", "1e4"}}, 0.1);
  REQUIRE(r.standing == Standing::too_slow);
  REQUIRE_THAT(r.why, Contains("after 0.3 s, most of it outside the steps"));
}

TEST_CASE("A peer steps the same scenario, and draws it too", "[grid]") {
  const GridFolder folder;
  const std::string high = "expect(\"above\", function() return ball:position().y > 3 end)\n";
  for (const Peer peer : {Peer::box2d, Peer::chipmunk}) {
    const RunResult r = folder.result_of(fall(high), peer);
    REQUIRE(r.standing == Standing::stands);
    const Image still = read_png(folder.out() + "/" + r.still);
    REQUIRE(still.width_px == 480);
    REQUIRE(still.height_px == 270);
  }
}

TEST_CASE("A repeated run has the same bits twice", "[grid]") {
  const GridFolder folder;
  Grid grid = folder.grid_of({fall(expecting("it falls", true))});
  REQUIRE_FALSE(work_off(grid, folder.work(), [](auto, auto) {}).front().same_twice);
  grid.runs.front().repeated = true;
  grid.runs.front().key = "anew";
  REQUIRE(work_off(grid, folder.work(), [](auto, auto) {}).front().same_twice == true);
}

TEST_CASE("Overlaps and gaps at the end are measured", "[grid]") {
  const std::string apart =
      "scenario { duration = 0.1, gravity = {0, 0}, effects = {\"gravity\"} }\n"
      "body { shape = box { width = 1, height = 1 } }\nbody { at = {0.8, 0}, shape = box { width = 1, height = 1 } }\n";
  const RunResult r = GridFolder().result_of(apart + expecting("x", true));
  REQUIRE(r.overlap_share.value() == Approx(0.2));
  REQUIRE(r.joint_gap_m == 0.0);
}

TEST_CASE("The cheapest is one of each row, or one of all, and only what stands competes", "[grid]") {
  Grid grid = grid_of_size(2, 3);
  const std::vector<RunResult> results{
      costing(3), costing(1, Standing::degrades), costing(2), costing(1, Standing::fails), costing(9), costing(10)};
  REQUIRE(cheapest(grid, results) == std::vector<bool>{false, false, true, false, true, false});
  grid.one_scenario = true;
  REQUIRE(cheapest(grid, results) == std::vector<bool>{false, false, true, false, false, false});
}

TEST_CASE("Where nothing stands, nothing is the cheapest", "[grid]") {
  const std::vector<RunResult> results(2, costing(1, Standing::degrades));
  REQUIRE(cheapest(grid_of_size(1, 2), results) == std::vector<bool>{false, false});
}

TEST_CASE("What scenario{} says of a method's keys is what --set would have it say", "[grid]") {
  const GridFolder folder;
  const std::string file = folder.write("one", fall(expecting("x", true)));
  const std::vector<Override> settings{{"rate", "120"},
                                       {"substeps", "3"},
                                       {"contact_solver", "ngs"},
                                       {"contact_solver", "exact"},
                                       {"contact_solver", "sequential_impulses"},
                                       {"contact_solver", "event"},
                                       {"contact_solver", "soft_step"},
                                       {"contact_solver", "auto"},
                                       {"joint_solver", "iterative"},
                                       {"joint_solver", "direct"},
                                       {"precision", "single"},
                                       {"precision", "double"}};
  for (const Override& set : settings) REQUIRE(own_setting(*load_scenario(file, {set}), set.key) == set.value);
  REQUIRE_FALSE(own_setting(*load_scenario(file, {}), "title"));
}

TEST_CASE("Runs that can only come out the same have one key, others have their own", "[grid]") {
  const GridFolder folder;
  const auto scenario = load_scenario(folder.write("one", fall(expecting("x", true))), {});
  const auto key = [&](std::optional<Peer> peer, const std::vector<Override>& set) {
    return request(*scenario, peer, set, {}).key;
  };
  REQUIRE(key({}, {}) == key({}, {{"substeps", "2"}, {"method.precision", "double"}}));
  REQUIRE(key({}, {}) != key({}, {{"substeps", "4"}}));
  REQUIRE(key({}, {}) != key(Peer::box2d, {}));
  REQUIRE(key(Peer::box2d, {}) == key(Peer::box2d, {{"substeps", "4"}}));
  REQUIRE(key(Peer::box2d, {}) != key(Peer::chipmunk, {}));
  REQUIRE(key({}, {}) != key({}, {{"duration", "1"}}));
}

TEST_CASE("A scenario without expectations is refused", "[grid]") {
  const GridFolder folder;
  const auto scenario = load_scenario(folder.write("one", fall("")), {});
  REQUIRE_THROWS_WITH(request(*scenario, {}, {}, {}), Contains("has no expectation"));
}

TEST_CASE("The stopwatch runs while a step does, and the refusal of a command is kept", "[grid]") {
  const Scene scene = scene_of({body_with(disc_shape(1), {0, 0})});
  TimedSimulation::Notes notes;
  TimedSimulation timed(make_peer(Peer::chipmunk, scene), notes);
  REQUIRE(timed.body(static_cast<BodyId>(1)).mass > 0);
  REQUIRE(notes.cpu_s == 0);
  timed.step();
  REQUIRE(notes.cpu_s > 0);
  REQUIRE(timed.tick() == 1);
  REQUIRE_THROWS_AS(timed.apply(CreateJoint{joint_of(JointKind::motor, {}, {})}), UnknownToPeer);
  REQUIRE_THAT(notes.refused, Contains("motor"));
}

}  // namespace
}  // namespace proofreel
