#include "lab/study.h"

#include <catch2/catch.hpp>
#include <cmath>
#include <filesystem>
#include <map>
#include <set>

#include "lab/study_analysis.h"
#include "lab/study_table.h"
#include "lab/study_work.h"
#include "lab/target.h"
#include "render/usage_error.h"
#include "tests/lab/grid_scenes.h"
#include "tests/lab/study_scenes.h"

namespace proofreel {
namespace {

using namespace test;
using Catch::Matchers::Contains;

const auto quietly = [](std::int64_t, std::int64_t) {};
const auto wordlessly = [](const char*) {};

/// A ball thrown upwards, for a second, and what it should do.
std::string throw_up(const std::string& rest = "") {
  return "scenario { duration = 1, rate = 60, view = { center = {0, 0}, height = 8 } }\n"
         "local ball = body { name = \"ball\", at = {0, 0}, velocity = {0, 5}, shape = circle { radius = 0.5 } }\n"
         "measure(\"height\", function() return ball:position().y end)\n"
         "measure(\"speed\", function() return ball:velocity().y end)\n" +
         rest;
}
std::string known_throw() {
  return throw_up("reference(\"height\", function(t) return 5 * t - 9.81 * t * t / 2 end)\n");
}

class StudyFolder {
 public:
  std::string file(const std::string& lua, const std::string& id = "throw") const { return folder_.write(id, lua); }
  StudyRequest request(const std::string& lua, const std::vector<std::string>& vary,
                       const std::vector<Peer>& peers = {}, const std::vector<std::string>& measures = {}) const {
    return {file(lua), {}, parse_axes(vary), peers, measures};
  }
  StudyWork work(double limit_s = 10) const { return {folder_.out(), limit_s, 2, false, ""}; }
  StudyOutcome outcome(const Study& study) const { return work_off(study, work(), wordlessly, quietly); }
  std::string table() const { return folder_.out() + "/study.csv"; }

 private:
  GridFolder folder_;
};

std::string refusal(const StudyRequest& request) {
  try {
    plan_study(request);
  } catch (const std::exception& error) {
    return error.what();
  }
  return "nothing was refused";
}

TEST_CASE("Semi-implicit Euler's error in free fall is g T h / 2, and that is what a study finds", "[study]") {
  const StudyFolder folder;
  const Study study =
      plan_study(folder.request(known_throw(), {"integrator=symplectic_euler", "rate=60,120,240", "substeps=1"}));
  const StudyOutcome outcome = folder.outcome(study);
  double scale = 0;  // the largest |reference| at the samples
  for (int i = 0; i <= 60; ++i) scale = std::max(scale, std::abs(5 * i / 60.0 - 9.81 * i * i / 7200.0));
  for (std::size_t i = 0; i < 3; ++i) {
    REQUIRE(outcome.results[i].status == RunStatus::ended);
    REQUIRE(*outcome.results[i].errors[0] == Approx(9.81 * study.runs[i].step_s / 2 / scale).epsilon(1e-9));
    REQUIRE(*outcome.results[i].cpu_s > 0);
  }
}

TEST_CASE("A run is on the curve of its method, from large steps to small ones", "[study]") {
  const StudyFolder folder;
  const Study study =
      plan_study(folder.request(known_throw(), {"rate=240,60,120", "integrator=verlet,rk4", "substeps=2"}));
  REQUIRE(study.refined == "rate");
  REQUIRE(study.keys == std::vector<std::string>{"integrator", "substeps", "rate"});
  REQUIRE(study.methods.size() == 2);
  REQUIRE(study.methods[1].name == "rk4, substeps 2");
  REQUIRE(runs_of(study, 1) == std::pair<std::size_t, std::size_t>(3, 6));
  REQUIRE(study.runs[3].step_s == Approx(1.0 / 120));
  REQUIRE(study.runs[5].step_s == Approx(1.0 / 480));
  REQUIRE(study.samples_per_s == 60);
  std::set<std::string> keys;
  for (const StudyRun& run : study.runs) keys.insert(run.key);
  REQUIRE(keys.size() == study.runs.size());
}

TEST_CASE("Samples are taken where all rates have ticks", "[study]") {
  const StudyFolder folder;
  REQUIRE(plan_study(folder.request(known_throw(), {"rate=50,60"})).samples_per_s == 10);
  REQUIRE(plan_study(folder.request(known_throw(), {"rate=30,7"})).samples_per_s == 1);
}

TEST_CASE("References that name times are compared at these, and ticks that miss the end are not", "[study]") {
  const StudyFolder folder;
  const std::string at_times = throw_up("reference(\"height\", { {0.35, 5 * 0.35 - 9.81 * 0.35 ^ 2 / 2 + 1} })\n");
  const Study named = plan_study(folder.request(at_times, {"rate=60,120"}));
  const StudyResult off_by_one = folder.outcome(named).results.front();
  REQUIRE(*off_by_one.errors[0] == Approx(1 / (5 * 0.35 - 9.81 * 0.35 * 0.35 / 2 + 1)));
  const StudyFolder uneven;
  StudyRequest request = uneven.request(throw_up(), {"integrator=verlet", "rate=60,120,240"}, {}, {"height"});
  request.set = {{"duration", "0.993"}};
  for (const StudyResult& result : uneven.outcome(plan_study(request)).results) REQUIRE(*result.errors[0] < 1e-12);
}

TEST_CASE("Who cannot take part is left out with the reason", "[study]") {
  const StudyFolder folder;
  const std::string hung = known_throw() +
                           "distance { world, ball, from = {0, 1}, to = {0, 0}, length = 1 }\n"
                           "buoyancy { level = -50, density = 1 }\n";
  const Study study = plan_study(folder.request(hung, {"integrator=verlet,rk4"}, {Peer::box2d}));
  REQUIRE(study.methods.size() == 1);
  REQUIRE(study.left_out.size() == 2);
  REQUIRE_THAT(study.left_out[0], Contains("rk4: integrator \"rk4\" cannot step joints"));
  REQUIRE_THAT(study.left_out[1], Contains("water") && Contains("Box2D"));
}

TEST_CASE("What makes no sense is refused before anything is run", "[study]") {
  const StudyFolder folder;
  REQUIRE_THAT(refusal(folder.request(known_throw(), {"rate=60"}, {}, {"hight"})),
               Contains("did you mean \"height\"?"));
  REQUIRE_THAT(refusal(folder.request(known_throw(), {"integrator=verlett"})), Contains("did you mean \"verlet\"?"));
  REQUIRE_THAT(refusal(folder.request("scenario { duration = 1 }\n", {"rate=60"})), Contains("measures nothing"));
  REQUIRE_THROWS_AS(parse_axes({"rate=60", "rate=120"}), UsageError);
  REQUIRE_THROWS_AS(parse_axes({"ratee=60"}), UsageError);
}

TEST_CASE("Peers run at their defaults and at the accurate preset, and are worse at what we know exactly", "[study]") {
  const StudyFolder folder;
  const Study study =
      plan_study(folder.request(known_throw(), {"integrator=verlet", "rate=60,120"}, {Peer::box2d, Peer::chipmunk}));
  REQUIRE(study.methods.size() == 5);
  REQUIRE(study.methods[2].name == "Box2D, accurate");
  const StudyOutcome outcome = folder.outcome(study);
  REQUIRE(*outcome.results[1].errors[0] < 1e-12);
  for (std::size_t i = 2; i < outcome.results.size(); ++i) {
    INFO(i);
    REQUIRE(outcome.results[i].status == RunStatus::ended);
    REQUIRE(*outcome.results[i].errors[0] > 1e-3);
  }
}

TEST_CASE("Without a reference a method is compared with itself at a sixteenth of its smallest step", "[study]") {
  const StudyFolder folder;
  const Study study = plan_study(
      folder.request(throw_up(), {"integrator=symplectic_euler", "rate=60,120", "substeps=1"}, {}, {"height"}));
  REQUIRE_FALSE(study.measures[0].has_reference);
  const StudyOutcome outcome = folder.outcome(study);
  // The finer run has an error of its own, of which the others' is short.
  const double scale = 5.0 * 5.0 / (2 * 9.81);
  const double finer_s = 1.0 / (16 * 120);
  REQUIRE(*outcome.results[0].errors[0] == Approx(9.81 * (1.0 / 60 - finer_s) / 2 / scale).epsilon(0.01));
  REQUIRE(*outcome.results[1].errors[0] == Approx(9.81 * (1.0 / 120 - finer_s) / 2 / scale).epsilon(0.01));
}

TEST_CASE("The finer run that others are compared with is not run twice", "[study]") {
  const StudyFolder folder;
  const Study study = plan_study(
      folder.request(throw_up(), {"integrator=symplectic_euler", "rate=60,120", "substeps=1"}, {}, {"height"}));
  const StudyOutcome first = folder.outcome(study);
  std::filesystem::remove(folder.table());
  std::string phase;
  std::map<std::string, std::int64_t> done;
  const StudyOutcome again = work_off(
      study, folder.work(), [&](const char* name) { phase = name; },
      [&](std::int64_t, std::int64_t total) { done[phase] = total; });
  REQUIRE(done["finer runs"] == 0);
  REQUIRE(done["errors"] == 2);
  REQUIRE(again.results[0].errors == first.results[0].errors);
  REQUIRE(again.energy_scale_j == first.energy_scale_j);
}

TEST_CASE("A run that fails, or takes too long, is part of the result", "[study]") {
  const StudyFolder folder;
  const std::string stiff = known_throw() + "spring { world, ball, from = {0, 1}, to = {0, 0}, stiffness = 1e9 }\n";
  const Study failing = plan_study(folder.request(stiff, {"integrator=verlet", "rate=60", "substeps=1"}));
  const StudyResult failed = folder.outcome(failing).results.front();
  REQUIRE((failed.status == RunStatus::failed || *failed.errors[0] > 1e3));
  const StudyFolder another;
  const std::string broken = known_throw() + "at(0.5, function() error(\"broken\") end)\n";
  const StudyResult script = another.outcome(plan_study(another.request(broken, {"rate=60"}))).results.front();
  REQUIRE(script.status == RunStatus::failed);
  REQUIRE_THAT(script.why, Contains("broken"));
  REQUIRE_FALSE(script.errors[0]);
  const StudyFolder slow;
  const Study long_one = plan_study(slow.request(known_throw(), {"rate=1000000"}));
  const StudyResult stopped = work_off(long_one, slow.work(0.05), wordlessly, quietly).results.front();
  REQUIRE(stopped.status == RunStatus::too_slow);
}

TEST_CASE("What is known is not run again: only what was cut off, changed or is new", "[study]") {
  const StudyFolder folder;
  const StudyRequest request = folder.request(known_throw(), {"integrator=verlet,rk4", "rate=60,120"});
  const Study study = plan_study(request);
  const StudyOutcome first = folder.outcome(study);
  const std::string whole = read_text(folder.table());
  std::int64_t most = 0;
  const auto count = [&](std::int64_t, std::int64_t total) { most = std::max(most, total); };
  work_off(study, folder.work(), wordlessly, count);
  REQUIRE(most == 0);
  REQUIRE(read_text(folder.table()) == whole);

  // One line is cut off: that run, and its time, are found again.
  write_text(folder.table(), whole.substr(0, whole.rfind('\n', whole.size() - 2) + 10));
  const StudyOutcome again = work_off(study, folder.work(), wordlessly, count);
  REQUIRE(most == 1);
  REQUIRE(again.results[3].errors == first.results[3].errors);

  folder.file(known_throw() + "-- changed\n");
  most = 0;
  work_off(plan_study(request), folder.work(), wordlessly, count);
  REQUIRE(most == 4);
}

TEST_CASE("The table has a line for every run and measure, and refuses another study's", "[study]") {
  const StudyFolder folder;
  const Study study =
      plan_study(folder.request(known_throw() + "reference(\"speed\", function(t) return 5 - 9.81 * t end)\n",
                                {"integrator=verlet", "rate=60,120"}));
  folder.outcome(study);
  const std::vector<CsvRecord> records = csv_records(read_text(folder.table()));
  REQUIRE(records.size() == 5);
  REQUIRE(records[0][0] == "scenario");
  REQUIRE(records[0][4] == "measure");
  REQUIRE(records[2][4] == "speed");
  REQUIRE(records[1][2] == "verlet");
  const Study other = plan_study(folder.request(known_throw(), {"rate=60"}));
  REQUIRE_THROWS_AS(folder.outcome(other), UsageError);
}

TEST_CASE("The table of another scenario, and a file that is no table, are left as they were", "[study]") {
  const StudyFolder folder;
  folder.outcome(plan_study(folder.request(known_throw(), {"rate=60"})));
  const std::string table = read_text(folder.table());
  const StudyRequest other{folder.file(known_throw(), "another"), {}, parse_axes({"rate=60"}), {}, {}};
  REQUIRE_THROWS_WITH(folder.outcome(plan_study(other)), Contains("holds a study of"));
  REQUIRE(read_text(folder.table()) == table);
  write_text(folder.table(), "my diary");
  REQUIRE_THROWS_WITH(folder.outcome(plan_study(other)), Contains("holds a table of other columns"));
  REQUIRE(read_text(folder.table()) == "my diary");
}

TEST_CASE("What was broken off is not taken for a failure", "[study]") {
  const StudyFolder folder;
  const Study study = plan_study(folder.request(known_throw(), {"rate=60,120,240"}));
  struct Interrupted {};
  const auto interrupt = [](std::int64_t done, std::int64_t) {
    if (done == 1) throw Interrupted{};
  };
  REQUIRE_THROWS_AS(work_off(study, folder.work(), wordlessly, interrupt), Interrupted);
  REQUIRE(read_text(folder.table()).find("failed") == std::string::npos);
  for (const StudyResult& result : folder.outcome(study).results) REQUIRE(result.status == RunStatus::ended);
}

StudyRequest search(const StudyFolder& folder, const std::string& lua, const std::vector<std::string>& vary) {
  StudyRequest request = folder.request(lua, vary);
  request.axes = axes_of_search(request.axes);
  return request;
}

TEST_CASE("The planner's answer meets its target, and the next cheaper rate does not", "[study]") {
  const StudyFolder folder;
  const Study study = plan_study(search(folder, known_throw(), {"integrator=symplectic_euler,verlet", "substeps=1"}));
  constexpr double target = 2e-2;
  const std::vector<PlannedMethod> plans = plan_for(study, target, folder.work(), quietly);
  REQUIRE(plans.size() == 2);
  REQUIRE(plans[0].name.starts_with("verlet"));
  REQUIRE(*plans[0].rate == rate_grain);
  REQUIRE_FALSE(plans[0].error_below);
  const int rate = *plans[1].rate;
  REQUIRE(plans[1].line ==
          "method = { integrator = \"symplectic_euler\", substeps = 1 }, rate = " + std::to_string(rate));
  REQUIRE(*error_at_rate(study, 0, rate, 10) <= target);
  REQUIRE(*error_at_rate(study, 0, rate - rate_grain, 10) > target);
  REQUIRE(*plans[1].error_below > target);
  // The line, pasted, is what was promised.
  const std::string pasted =
      "scenario { duration = 1, " + plans[1].line + " }" + known_throw().substr(known_throw().find('\n'));
  const Study check = plan_study(search(folder, pasted, {"substeps=1"}));
  REQUIRE(*error_at_rate(check, 0, rate, 10) <= target);
}

TEST_CASE("The planner's error is the one that a study at that rate finds", "[study]") {
  const StudyFolder folder;
  const StudyRequest request = folder.request(known_throw(), {"integrator=symplectic_euler", "rate=120", "substeps=1"});
  const Study study = plan_study(request);
  REQUIRE(*error_at_rate(study, 0, 120, 10) == *folder.outcome(study).results[0].errors[0]);
}

TEST_CASE("The planner says of whom nothing helps", "[study]") {
  const StudyFolder folder;
  const std::string wrong = throw_up("reference(\"height\", function(t) return 1 end)\n");
  const auto plans = plan_for(plan_study(search(folder, wrong, {"integrator=verlet"})), 1e-3, folder.work(), quietly);
  REQUIRE_FALSE(plans[0].rate);
  REQUIRE_THAT(plans[0].why_not, Contains("come to its end in time and reach it"));
}

TEST_CASE("Traces come back from their process as they were", "[study]") {
  Trace trace;
  trace.status = RunStatus::too_slow;
  trace.why = "stopped";
  trace.times_s = {0, 0.5};
  trace.values = {{1, NAN}, {3, 4}};
  trace.expected = {{1.0, std::nullopt}, {std::nullopt, 4.0}};
  trace.energy_drift_j = {0, -1e-300};
  trace.row_updates = 12;
  const std::string bytes = packed(trace);
  const Trace back = unpacked_trace(bytes).value();
  REQUIRE(back.status == trace.status);
  REQUIRE(back.why == "stopped");
  REQUIRE(back.times_s == trace.times_s);
  REQUIRE(std::isnan(back.values[0][1]));
  REQUIRE(back.expected == trace.expected);
  REQUIRE(back.energy_drift_j == trace.energy_drift_j);
  REQUIRE(back.row_updates == trace.row_updates);
  REQUIRE_FALSE(back.evaluations);
  for (std::size_t length = 0; length < bytes.size(); ++length) REQUIRE_FALSE(unpacked_trace(bytes.substr(0, length)));
}

TEST_CASE("An error is relative to the largest reference, and a NaN is not overlooked", "[study]") {
  REQUIRE(*error_of({1, 2, 3}, {1.0, 2.5, 2.0}) == Approx(1 / 2.5));
  REQUIRE(*error_of({1e-4}, {0.0}) == Approx(0.1));
  REQUIRE(std::isnan(*error_of({1, NAN, 1}, {1.0, 1.0, 5.0})));
  REQUIRE_FALSE(error_of({1, 2}, {std::nullopt, std::nullopt}));
}

}  // namespace
}  // namespace proofreel
