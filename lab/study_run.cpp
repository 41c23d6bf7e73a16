#include "lab/study_run.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <span>

#include "engine/archive.h"
#include "lab/csv.h"
#include "lab/grid.h"
#include "lab/timed_simulation.h"
#include "scenarios/scenario.h"
#include "scenarios/timeline.h"

namespace proofreel {

template <>
struct LastOf<RunStatus> {
  static constexpr RunStatus value = RunStatus::not_offered;
};

template <typename Archive, Exchanged<Trace> T>
void exchange(Archive& archive, T& trace) {
  auto& [status, why, times, values, expected, drift, kinetic, simulated, share, knows, rows, evaluations] = trace;
  archive(status, why, times, values, expected, drift, kinetic, simulated, share, knows, rows, evaluations);
}

namespace {

/// Below this the scale of an error does not go.
constexpr double smallest_scale = 1e-3;

/// A scenario with the simulation its script acts on, for as long as this lives.
class Stage {
 public:
  Stage(const Study& study, const StudyRun& run) : scenario_(load_scenario(study.file, run.set)) {
    const StudiedMethod& method = study.methods[run.method];
    const Scene& scene = scenario_->scene;
    simulation_ = method.peer ? make_peer(*method.peer, scene, method.preset) : make_simulation(scene);
    scenario_->script->bind(simulation_.get());
  }
  ~Stage() { scenario_->script->bind(nullptr); }
  Stage(const Stage&) = delete;
  Stage& operator=(const Stage&) = delete;

  Scenario& scenario() { return *scenario_; }
  Script& script() { return *scenario_->script; }
  Simulation& simulation() { return *simulation_; }

 private:
  std::unique_ptr<Scenario> scenario_;
  std::unique_ptr<Simulation> simulation_;
};

class Tracer {
 public:
  Tracer(const Study& study, Stage& stage) : study_(study), stage_(stage) {
    trace_.values.resize(study.measures.size());
    trace_.expected.resize(study.measures.size());
    initial_j_ = stage.simulation().energy().total();
    for (const StudiedMeasure& measure : study.measures) {
      const Measure& known = stage.scenario().measures[static_cast<std::size_t>(measure.index)];
      for (const double seconds : known.reference_times) {
        spoken_of_.insert(tick_at(seconds, stage.scenario().scene.rate));
      }
    }
  }

  Trace run(double limit_s) {
    Simulation& simulation = stage_.simulation();
    const std::int64_t last = stage_.scenario().ticks();
    const int rate = stage_.scenario().scene.rate;
    const double start = thread_cpu_s();
    StageTimes times;
    simulation.time_stages(&times);
    simulation.count_work();
    sample(0);
    for (std::int64_t tick = 1; tick <= last; ++tick) {
      stage_.script().before_step();
      simulation.step();
      stage_.script().after_step();
      trace_.simulated_s = static_cast<double>(tick) / rate;
      if (simulation.failure()) return stop(RunStatus::failed, simulation.failure()->what);
      if (is_sampled(tick, rate) || spoken_of_.contains(tick) || (tick == last && ends_in_time(tick, rate)))
        sample(tick);
      if (tick % 64 == 0 && thread_cpu_s() - start > limit_s) return stop(RunStatus::too_slow, "stopped at its limit");
    }
    trace_.status = RunStatus::ended;
    note_work(times);
    if (const std::optional<WorkDone> work = simulation.work_done()) {
      trace_.row_updates = work->row_updates;
      trace_.evaluations = work->evaluations;
    }
    return std::move(trace_);
  }

 private:
  /// At rates whose ticks miss the end the last tick lies at a time of its own, which no other run shares.
  bool ends_in_time(std::int64_t tick, int rate) const {
    return std::abs(static_cast<double>(tick) / rate - study_.duration_s) < 1e-9;
  }
  bool is_sampled(std::int64_t tick, int rate) const { return tick * study_.samples_per_s % rate == 0; }

  void sample(std::int64_t tick) {
    trace_.times_s.push_back(static_cast<double>(tick) / stage_.scenario().scene.rate);
    const Energy energy = stage_.simulation().energy();
    trace_.energy_drift_j.push_back(energy.total() - energy.booked_work - initial_j_);
    trace_.largest_kinetic_j = std::max(trace_.largest_kinetic_j, energy.kinetic);
    for (std::size_t i = 0; i < study_.measures.size(); ++i) {
      const StudiedMeasure& measure = study_.measures[i];
      trace_.values[i].push_back(stage_.script().measure(measure.index));
      trace_.expected[i].push_back(measure.has_reference ? stage_.script().reference(measure.index, tick)
                                                         : std::nullopt);
    }
  }

  Trace stop(RunStatus status, const std::string& what) {
    trace_.status = status;
    trace_.why = "at " + exact(trace_.simulated_s) + " s of scene time: " + what;
    return std::move(trace_);
  }

  void note_work(const StageTimes& times) {
    double all = 0;
    for (const double seconds : times.seconds) all += seconds;
    const double collision = times.of(StepStage::broad_phase) + times.of(StepStage::narrow_phase);
    trace_.knows_collision = all > 0;
    if (all > 0) trace_.collision_share = collision / all;
  }

  const Study& study_;
  Stage& stage_;
  Trace trace_;
  double initial_j_ = 0;
  std::set<std::int64_t> spoken_of_;  ///< ticks that references name
};

Trace without_samples(RunStatus status, const std::string& why) {
  Trace trace;
  trace.status = status;
  trace.why = why;
  return trace;
}

/// What it costs to read the watch twice, s.
double cost_of_watch() {
  constexpr int times = 2000;
  double sum = 0;
  for (int i = 0; i < times; ++i) {
    const double start = thread_cpu_s();
    sum += thread_cpu_s() - start;
  }
  return sum / times;
}

/// CPU time of all steps of one run. Where no script acts on the way, the watch is read once in a sample's time.
double timed_once(const Study& study, const StudyRun& run) {
  Stage stage(study, run);
  Simulation& simulation = stage.simulation();
  const std::int64_t last = stage.scenario().ticks();
  if (!stage.script().has_callbacks()) {
    const double start = thread_cpu_s();
    while (simulation.tick() < last && !simulation.failure()) simulation.step();
    return thread_cpu_s() - start;
  }
  const double watch_s = cost_of_watch();
  double sum = 0;
  while (simulation.tick() < last && !simulation.failure()) {
    stage.script().before_step();
    const double start = thread_cpu_s();
    simulation.step();
    sum += std::max(0.0, thread_cpu_s() - start - watch_s);
    stage.script().after_step();
  }
  return sum;
}

}  // namespace

std::string packed(const Trace& trace) {
  ArchiveWriter writer;
  writer(trace);
  const auto* first = reinterpret_cast<const char*>(writer.bytes().data());
  return {first, first + writer.bytes().size()};
}

std::optional<Trace> unpacked_trace(const std::string& bytes) {
  ArchiveReader reader(std::as_bytes(std::span(bytes)));
  Trace trace;
  reader(trace);
  return reader.ended_well() ? std::optional(std::move(trace)) : std::nullopt;
}

Trace trace_of(const Study& study, const StudyRun& run, double limit_s) {
  try {
    Stage stage(study, run);
    try {
      return Tracer(study, stage).run(limit_s);
    } catch (const ScenarioError& error) {
      return without_samples(RunStatus::failed, error.what());
    }
  } catch (const ScenarioError& error) {
    return without_samples(RunStatus::not_offered, error.what());
  } catch (const UnknownToPeer& error) {
    return without_samples(RunStatus::not_offered, error.what());
  }
}

StudyRun finer_run(const Study& study, std::size_t method) {
  StudyRun run = study.runs[runs_of(study, method).second - 1];
  const std::string key = study.refined.empty() || study.methods[method].peer ? "rate" : study.refined;
  const std::unique_ptr<Scenario> scenario = load_scenario(study.file, run.set);
  const double own = number_in(*own_setting(*scenario, key)).value_or(1);
  run.set = overlaid(run.set, {{key, exact(own * finer_steps)}});
  run.step_s /= finer_steps;
  run.key += "-finer";
  return run;
}

double cpu_time_of(const Study& study, const StudyRun& run, double limit_s) {
  constexpr int most_runs = 5;
  constexpr double enough_s = 0.15;
  double least = timed_once(study, run);
  double spent = least;
  for (int i = 1; i < most_runs && (i < 2 || spent < enough_s) && spent < limit_s / 2; ++i) {
    const double again = timed_once(study, run);
    spent += again;
    least = std::min(least, again);
  }
  return least;
}

std::vector<std::optional<double>> errors_of(const std::vector<double>& values,
                                             const std::vector<std::optional<double>>& expected) {
  double scale = smallest_scale;
  for (const std::optional<double>& e : expected) scale = std::max(scale, std::abs(e.value_or(0)));
  std::vector<std::optional<double>> errors;
  for (std::size_t i = 0; i < values.size(); ++i) {
    errors.push_back(expected[i] ? std::optional(std::abs(values[i] - *expected[i]) / scale) : std::nullopt);
  }
  return errors;
}

std::optional<double> error_of(const std::vector<double>& values, const std::vector<std::optional<double>>& expected) {
  std::optional<double> largest;
  for (const std::optional<double>& error : errors_of(values, expected)) {
    if (!error) continue;
    if (std::isnan(*error)) return error;
    largest = std::max(*error, largest.value_or(0));
  }
  return largest;
}

}  // namespace proofreel
