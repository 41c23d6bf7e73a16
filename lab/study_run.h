#pragma once

/// Runs of a study, in this process: what was measured on the way, and how long the steps take.

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "lab/study.h"

namespace proofreel {

/// What was measured in a run.
struct Trace {
  RunStatus status = RunStatus::failed;
  std::string why;                                           ///< it did not end well; a sentence
  std::vector<double> times_s;                               ///< of the samples
  std::vector<std::vector<double>> values;                   ///< [measure][sample]
  std::vector<std::vector<std::optional<double>>> expected;  ///< by the references, where they say something
  std::vector<double> energy_drift_j;                        ///< total - booked work - initial total
  double largest_kinetic_j = 0;
  double simulated_s = 0;
  double collision_share = 0;  ///< of the CPU time of all steps
  bool knows_collision = false;
  std::optional<std::int64_t> row_updates;
  std::optional<std::int64_t> evaluations;
};

/// The trace as bytes, and back; nothing when they are no whole trace.
std::string packed(const Trace& trace);
std::optional<Trace> unpacked_trace(const std::string& bytes);

/// Steps one run to its end and samples it. Nothing in it is timed but the share of collision.
Trace trace_of(const Study& study, const StudyRun& run, double limit_s);

/// The same method at a step `finer_steps` times smaller than the method's finest. Throws ScenarioError where there is
/// no such step.
StudyRun finer_run(const Study& study, std::size_t method);

/// CPU time of the run's steps, s: the least of several runs. Call it where nothing else runs.
double cpu_time_of(const Study& study, const StudyRun& run, double limit_s);

/// max over the samples of |q - expected| / scale, where the scale is the largest |expected|, and at least 1e-3.
/// Nothing when no sample has an expectation.
std::optional<double> error_of(const std::vector<double>& values, const std::vector<std::optional<double>>& expected);
/// The same, sample by sample.
std::vector<std::optional<double>> errors_of(const std::vector<double>& values,
                                             const std::vector<std::optional<double>>& expected);

}  // namespace proofreel
