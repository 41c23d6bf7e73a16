#include "lab/study_work.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>
#include <set>

#include "lab/callgrind.h"
#include "lab/kept_traces.h"
#include "lab/study_table.h"
#include "render/output_file.h"
#include "scenarios/scenario.h"

namespace proofreel {
namespace {

/// Beyond a run's own limit: for loading and measuring.
constexpr double grace_s = 10;

Trace trace_in(const ChildEnd& end) {
  Trace trace;
  if (end.died_of.empty() && !end.out_of_time) return unpacked_trace(end.answer).value_or(trace);
  trace.status = end.out_of_time ? RunStatus::too_slow : RunStatus::failed;
  trace.why = end.out_of_time ? "stopped at its limit" : "the engine crashed: " + end.died_of;
  return trace;
}

/// Steps runs in processes of their own.
std::vector<Trace> traced(const Study& study, const std::vector<StudyRun>& runs, const StudyWork& work, double limit_s,
                          const WorkProgress& progress, const std::function<void(std::size_t, const Trace&)>& keep) {
  std::vector<Trace> traces(runs.size());
  const auto work_of = [&](std::size_t i) {
    return ChildWork{[&, i] { return packed(trace_of(study, runs[i], limit_s)); }, limit_s + grace_s};
  };
  const auto keep_end = [&](std::size_t i, const ChildEnd& end) {
    traces[i] = trace_in(end);
    keep(i, traces[i]);
  };
  work_off_children(runs.size(), work.at_once, work_of, keep_end, progress);
  return traces;
}

/// The same of runs that are kept beside the study's own, those left out that are known from before.
std::vector<Trace> kept_or_traced(const Study& study, const std::vector<StudyRun>& runs, const StudyWork& work,
                                  double limit_s, const WorkProgress& progress) {
  const KeptTraces kept(work.folder);
  std::vector<Trace> traces(runs.size());
  std::vector<std::size_t> todo;
  std::vector<StudyRun> unknown;
  for (std::size_t i = 0; i < runs.size(); ++i) {
    if (std::optional<Trace> known = kept.find(runs[i])) {
      traces[i] = std::move(*known);
    } else {
      todo.push_back(i);
      unknown.push_back(runs[i]);
    }
  }
  traced(study, unknown, work, limit_s, progress, [&](std::size_t i, const Trace& trace) {
    kept.keep(unknown[i], trace);
    traces[todo[i]] = trace;
  });
  return traces;
}

bool compares_with_itself(const Study& study) {
  return std::any_of(study.measures.begin(), study.measures.end(), [](const auto& m) { return !m.has_reference; });
}

/// The finer runs that some methods' runs are compared with, by method.
using FinerTraces = std::map<std::size_t, Trace>;

FinerTraces finer_traces(const Study& study, const std::set<std::size_t>& methods, const StudyWork& work,
                         const WorkProgress& progress) {
  FinerTraces finer;
  if (!compares_with_itself(study)) return finer;
  std::vector<std::size_t> list;
  std::vector<StudyRun> runs;
  for (const std::size_t method : methods) {
    try {
      runs.push_back(finer_run(study, method));
      list.push_back(method);
    } catch (const ScenarioError& error) {
      Trace& none = finer[method];
      none.status = RunStatus::not_offered;
      none.why = error.what();
    }
  }
  // The finest run within its limit may need a reference that takes `finer_steps` times as long.
  std::vector<Trace> traces = kept_or_traced(study, runs, work, finer_steps * work.limit_s, progress);
  for (std::size_t i = 0; i < list.size(); ++i) finer.emplace(list[i], std::move(traces[i]));
  return finer;
}

/// Times of samples that differ by roundings only.
constexpr double same_time_s = 1e-9;

/// What the finer run measured is what measures without a reference should be.
void expect_finer(const Study& study, Trace& trace, const Trace& finer) {
  if (finer.status != RunStatus::ended) {
    trace.why = std::string("the finer run it is to be compared with: ") + name_of(finer.status) + ", " + finer.why;
    return;
  }
  for (std::size_t i = 0; i < study.measures.size(); ++i) {
    if (study.measures[i].has_reference) continue;
    for (std::size_t k = 0, f = 0; k < trace.times_s.size(); ++k) {
      while (f < finer.times_s.size() && finer.times_s[f] < trace.times_s[k] - same_time_s) ++f;
      const bool is_same = f < finer.times_s.size() && finer.times_s[f] < trace.times_s[k] + same_time_s;
      if (is_same) trace.expected[i][k] = finer.values[i][f];
    }
  }
}

class Worker {
 public:
  Worker(const Study& study, const StudyWork& work, const std::function<void(const char*)>& phase,
         const WorkProgress& progress)
      : study_(study),
        work_(work),
        phase_(phase),
        progress_(progress),
        table_((std::filesystem::path(work.folder) / "study.csv").string(), study) {}

  StudyOutcome run() {
    find_energy_scale();
    find_errors();
    find_times();
    if (work_.instructions) count_instructions();
    StudyOutcome outcome{{}, energy_scale_j_};
    for (const StudyRun& run : study_.runs) outcome.results.push_back(*table_.find(run, 0));
    table_.rewrite(outcome.results);
    return outcome;
  }

 private:
  /// Of the scene as its file steps it, so that a study which is extended keeps its scale; where that comes to no end,
  /// of the finest run of the first method that does.
  void find_energy_scale() {
    phase_("energy scale");
    StudyRun own = study_.runs.front();
    own.set = study_.set;
    own.key += "-own";
    std::vector<StudyRun> candidates{own};
    for (std::size_t method = 0; method < study_.methods.size(); ++method) {
      candidates.push_back(study_.runs[runs_of(study_, method).second - 1]);
    }
    for (const StudyRun& run : candidates) {
      const Trace trace =
          kept_or_traced(study_, {run}, work_, work_.limit_s, [](std::int64_t, std::int64_t) {}).front();
      if (trace.status != RunStatus::ended || !(trace.largest_kinetic_j > 0)) continue;
      energy_scale_j_ = trace.largest_kinetic_j;
      return;
    }
  }

  std::vector<std::size_t> without(const std::function<bool(const StudyResult*)>& lacks) const {
    std::vector<std::size_t> todo;
    std::set<std::string> seen;
    for (std::size_t i = 0; i < study_.runs.size(); ++i) {
      const StudyRun& run = study_.runs[i];
      if (seen.insert(run.key).second && lacks(table_.find(run, work_.limit_s))) todo.push_back(i);
    }
    return todo;
  }

  void find_errors() {
    const std::vector<std::size_t> todo = without([](const StudyResult* known) { return known == nullptr; });
    std::set<std::size_t> methods;
    std::vector<StudyRun> runs;
    for (const std::size_t i : todo) {
      methods.insert(study_.runs[i].method);
      runs.push_back(study_.runs[i]);
    }
    phase_("finer runs");
    const FinerTraces finer = finer_traces(study_, methods, work_, progress_);
    phase_("errors");
    traced(study_, runs, work_, work_.limit_s, progress_, [&](std::size_t i, Trace trace) {
      const auto own = finer.find(runs[i].method);
      if (own != finer.end() && trace.status == RunStatus::ended) expect_finer(study_, trace, own->second);
      table_.add(runs[i], result_of(trace));
    });
  }

  StudyResult result_of(const Trace& trace) const {
    StudyResult result;
    result.status = trace.status;
    result.why = trace.why;
    result.simulated_s = trace.simulated_s;
    result.errors.resize(study_.measures.size());
    if (trace.status == RunStatus::too_slow) result.cpu_s = work_.limit_s;
    if (trace.status != RunStatus::ended) return result;
    for (std::size_t i = 0; i < study_.measures.size(); ++i) {
      result.errors[i] = error_of(trace.values[i], trace.expected[i]);
    }
    double drift = 0;
    for (const double joules : trace.energy_drift_j) drift = std::max(drift, std::abs(joules));
    if (energy_scale_j_ > 0) result.energy_error = drift / energy_scale_j_;
    result.row_updates = trace.row_updates;
    result.evaluations = trace.evaluations;
    if (trace.knows_collision) result.collision_share = trace.collision_share;
    return result;
  }

  /// What has not come to its end needs no time.
  void find_times() {
    phase_("times");
    const std::vector<std::size_t> todo = without([](const StudyResult* known) {
      return known != nullptr && known->status == RunStatus::ended && !known->cpu_s.has_value();
    });
    constexpr int most_repetitions = 5;
    const auto work_of = [&](std::size_t i) {
      const StudyRun& run = study_.runs[todo[i]];
      return ChildWork{[&] { return exact(cpu_time_of(study_, run, work_.limit_s)); },
                       most_repetitions * work_.limit_s + grace_s};
    };
    const auto keep = [&](std::size_t i, const ChildEnd& end) {
      const StudyRun& run = study_.runs[todo[i]];
      StudyResult result = *table_.find(run, 0);
      result.cpu_s = number_in(end.answer);
      if (!result.cpu_s) {  // it has an error, but nobody knows at what price
        result.status = end.out_of_time ? RunStatus::too_slow : RunStatus::failed;
        result.why = "while it was timed: " + (end.out_of_time ? std::string("stopped at its limit") : end.died_of);
      }
      table_.add(run, result);
    };
    work_off_children(todo.size(), 1, work_of, keep, progress_);
  }

  void count_instructions() {
    phase_("instructions");
    const std::vector<std::size_t> todo = without([](const StudyResult* known) {
      return known != nullptr && known->status == RunStatus::ended && !known->instructions.has_value();
    });
    const auto total = static_cast<std::int64_t>(todo.size());
    for (std::int64_t done = 0; done < total; ++done) {
      progress_(done, total);
      const StudyRun& run = study_.runs[todo[static_cast<std::size_t>(done)]];
      const StudiedMethod& method = study_.methods[run.method];
      if (method.preset == PeerPreset::accurate) continue;  // `run` steps peers at their defaults alone
      StudyResult result = *table_.find(run, 0);
      result.instructions =
          instructions(command_of(run, method), method.peer ? "*PeerSimulation::step()*" : "*World::step()*");
      table_.add(run, result);
    }
    progress_(total, total);
  }

  std::vector<std::string> command_of(const StudyRun& run, const StudiedMethod& method) const {
    std::vector<std::string> words{work_.program, "run", study_.file, "--quiet", "--json"};
    for (const Override& each : run.set) {
      words.push_back("--set");
      words.push_back(each.key + "=" + each.value);
    }
    if (method.peer) {
      words.push_back("--peer");
      words.push_back(*method.peer == Peer::box2d ? "box2d" : "chipmunk");
    }
    return words;
  }

  const Study& study_;
  const StudyWork& work_;
  const std::function<void(const char*)>& phase_;
  const WorkProgress& progress_;
  StudyTable table_;
  double energy_scale_j_ = 0;
};

}  // namespace

StudyOutcome work_off(const Study& study, const StudyWork& work, const std::function<void(const char*)>& phase,
                      const WorkProgress& progress) {
  make_folder(work.folder);
  return Worker(study, work, phase, progress).run();
}

std::vector<Trace> traces_of(const Study& study, const std::vector<std::size_t>& indices, const StudyWork& work,
                             const WorkProgress& progress) {
  std::vector<StudyRun> runs;
  std::set<std::size_t> methods;
  for (const std::size_t i : indices) {
    runs.push_back(study.runs[i]);
    methods.insert(study.runs[i].method);
  }
  const FinerTraces finer = finer_traces(study, methods, work, progress);
  std::vector<Trace> traces = kept_or_traced(study, runs, work, work.limit_s, progress);
  for (std::size_t i = 0; i < traces.size(); ++i) {
    const auto own = finer.find(runs[i].method);
    if (own != finer.end() && traces[i].status == RunStatus::ended) expect_finer(study, traces[i], own->second);
  }
  return traces;
}

}  // namespace proofreel
