#include "lab/grid_run.h"

#include <algorithm>
#include <cmath>

#include "golden/hex.h"
#include "lab/measures.h"
#include "lab/timed_simulation.h"
#include "render/canvas.h"
#include "render/draw.h"
#include "render/png.h"
#include "scenarios/formatted.h"
#include "scenarios/runner.h"

namespace proofreel {
namespace {

constexpr Size still_size{480, 270};

/// A run in the making.
struct Attempt {
  std::unique_ptr<Scenario> scenario;
  TimedSimulation::Notes notes;
  std::unique_ptr<Runner> runner;
  std::int64_t second = 0;  ///< the tick at which one second is over, or the last one
  std::uint64_t hash_after_second = 0;
  std::string error;  ///< of the script
};

RunResult without_result(Standing standing, std::string why) {
  RunResult result;
  result.standing = standing;
  result.why = std::move(why);
  return result;
}

/// Which scenario it is, the reader knows anyway.
std::string without_path(const std::string& message, const std::string& path) {
  const std::string prefix = path + ": ";
  return message.starts_with(prefix) ? message.substr(prefix.size()) : message;
}

std::string seconds_text(double seconds) { return formatted("%.4g s", seconds); }

/// Throws ScenarioError or UnknownToPeer, both of which say what is not offered. What the script itself does wrong at
/// the start is left in `error`, and there is no runner then.
void prepare(Attempt& attempt, const RunRequest& request) {
  attempt.scenario = load_scenario(request.file, request.set);
  const Scene& scene = attempt.scenario->scene;
  std::unique_ptr<Simulation> simulation = request.peer ? make_peer(*request.peer, scene) : make_simulation(scene);
  attempt.second = std::min<std::int64_t>(scene.rate, attempt.scenario->ticks());
  auto timed = std::make_unique<TimedSimulation>(std::move(simulation), attempt.notes);
  try {
    attempt.runner = std::make_unique<Runner>(*attempt.scenario, std::move(timed));
  } catch (const ScenarioError& error) {
    attempt.error = without_path(error.what(), request.file);
  }
}

/// Until the end, tick `last` or a limit.
void step(Attempt& attempt, std::int64_t last, double limit_s) {
  const double start = thread_cpu_s();
  Runner& runner = *attempt.runner;
  try {
    while (!runner.finished() && runner.tick() < last && attempt.notes.cpu_s < limit_s &&
           thread_cpu_s() - start < whole_limit * limit_s) {
      runner.step();
      if (runner.tick() == attempt.second) attempt.hash_after_second = runner.trajectory_hash();
    }
  } catch (const ScenarioError& error) {
    if (!runner.simulation().failure()) attempt.error = without_path(error.what(), attempt.scenario->path);
  }
}

bool is_about_quality(const ExpectationResult& expectation) { return expectation.text.starts_with("quality:"); }

/// What did not hold, the gravest first, then in order of time.
std::vector<ExpectationResult> failed(const RunReport& report) {
  std::vector<ExpectationResult> list;
  for (const ExpectationResult& e : report.expectations) {
    if (e.failed()) list.push_back(e);
  }
  std::stable_sort(list.begin(), list.end(), [](const ExpectationResult& a, const ExpectationResult& b) {
    return std::pair(is_about_quality(a), a.tick) < std::pair(is_about_quality(b), b.tick);
  });
  return list;
}

void judge(RunResult& result, const RunReport& report, int rate) {
  const std::vector<ExpectationResult> list = failed(report);
  const bool only_quality = std::all_of(list.begin(), list.end(), is_about_quality);
  result.standing = report.failure || !only_quality ? Standing::fails
                    : list.empty()                  ? Standing::stands
                                                    : Standing::degrades;
  const auto seconds = [rate](std::int64_t tick) { return static_cast<double>(tick) / rate; };
  if (report.failure) {
    result.at_s = seconds(report.failure->tick);
    result.why =
        "at " + seconds_text(*result.at_s) + ": in " + report.failure->stage + " the motion " + report.failure->what;
    return;
  }
  for (const ExpectationResult& e : list) {
    if (!result.at_s) result.at_s = seconds(e.tick);
    result.why.append(result.why.empty() ? "" : "; ").append("at ").append(seconds_text(seconds(e.tick)));
    result.why.append(": ").append(e.text);
  }
}

bool is_finite(const Snapshot& snapshot) {
  return std::all_of(snapshot.bodies.begin(), snapshot.bodies.end(), [](const BodyView& body) {
    return std::isfinite(body.state.center.x) && std::isfinite(body.state.center.y) && std::isfinite(body.state.angle);
  });
}

void measure_end(RunResult& result, const Scenario& scenario, const Snapshot& snapshot) {
  std::vector<FilterDef> filters;
  for (const BodyDef& body : scenario.scene.bodies) filters.push_back(body.filter);
  result.overlap_share = penetration_of(snapshot, filters).of_smaller;
  result.joint_gap_m = joint_gaps(snapshot).largest;
}

void take_figures(RunResult& result, const RunReport& report) {
  result.energy_drift_j = report.max_energy_drift;
  result.booked_work_j = report.final_energy.booked_work;
  result.trajectory_hash = hex(report.trajectory_hash);
}

std::string still_of(const Scenario& scenario, Frame frame, std::optional<GlBackend> gl) {
  const std::unique_ptr<GlContext> context = make_context(gl);
  Canvas canvas(*context, still_size.width_px, still_size.height_px);
  Image image;
  frame.layers = {Layer::bodies, Layer::joints, Layer::contacts};
  frame.captions.clear();  // nobody could read them
  draw_frame(canvas, frame, {scenario.picture.theme}, image);
  const std::vector<std::uint8_t> png = encode_png(image);
  return {png.begin(), png.end()};
}

bool has_same_bits_again(const RunRequest& request, const Attempt& first, double limit_s) {
  Attempt again;
  prepare(again, request);
  step(again, first.second, limit_s);
  return again.hash_after_second == first.hash_after_second;
}

/// How far a run came that did not reach its end.
void judge_stop(RunResult& result, Attempt& attempt, double limit_s) {
  const std::string when = "at " + seconds_text(result.simulated_s) + " of scene time";
  if (!attempt.notes.refused.empty()) {
    result.standing = Standing::not_offered;
    result.why = when + ": " + attempt.notes.refused;
  } else if (!attempt.error.empty()) {
    result.standing = Standing::fails;
    result.why = attempt.error;
    result.at_s = result.simulated_s;
  } else {
    result.standing = Standing::too_slow;
    const bool by_steps = attempt.notes.cpu_s >= limit_s;
    result.why = "stopped " + when + ", after " + seconds_text(by_steps ? limit_s : whole_limit * limit_s) +
                 (by_steps ? " of steps" : ", most of it outside the steps");
  }
}

}  // namespace

RunOutcome run_once(const RunRequest& request, double limit_s, std::optional<GlBackend> gl) {
  Attempt attempt;
  try {
    prepare(attempt, request);
  } catch (const ScenarioError& error) {
    return {without_result(Standing::not_offered, without_path(error.what(), request.file)), {}};
  } catch (const UnknownToPeer& error) {
    return {without_result(Standing::not_offered, error.what()), {}};
  }
  if (!attempt.runner) return {without_result(Standing::fails, attempt.error), {}};
  const Scenario& scenario = *attempt.scenario;
  step(attempt, scenario.ticks(), limit_s);
  RunResult result;
  Runner& runner = *attempt.runner;
  result.cpu_s = attempt.notes.cpu_s;
  result.simulated_s = static_cast<double>(runner.tick()) / scenario.scene.rate;
  if (runner.finished() && attempt.error.empty()) {
    const RunReport report = runner.finish();
    judge(result, report, scenario.scene.rate);
    take_figures(result, report);
  } else {
    judge_stop(result, attempt, limit_s);
    if (result.standing == Standing::too_slow) result.cpu_s = std::max(result.cpu_s, limit_s);
  }
  const Frame frame = runner.frame(0);
  if (result.standing == Standing::not_offered || !is_finite(frame.snapshot)) return {result, {}};
  measure_end(result, scenario, frame.snapshot);
  if (request.repeated && result.cost_ms()) result.same_twice = has_same_bits_again(request, attempt, limit_s);
  return {result, still_of(scenario, frame, gl)};
}

}  // namespace proofreel
