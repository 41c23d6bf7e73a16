#pragma once

/// Studies and their results, made up or run.

#include <string>
#include <vector>

#include "lab/study.h"
#include "lab/study_run.h"

namespace proofreel::test {

/// Methods with runs at rates 60, 120, ... of one measure, "angle".
inline Study study_of(const std::vector<std::string>& names, int runs_each) {
  Study study;
  study.scenario = "swing";
  study.title = "A <swing> & more";
  study.duration_s = 1;
  study.keys = {"integrator", "rate"};
  study.refined = "rate";
  study.samples_per_s = 60;
  study.measures = {{"angle", 0, true}};
  for (const std::string& name : names) {
    study.methods.push_back({name, {}, PeerPreset::standard, {}});
    for (int i = 0; i < runs_each; ++i) {
      const int rate = 60 << i;
      StudyRun run{
          study.methods.size() - 1, {{"rate", std::to_string(rate)}}, {name, std::to_string(rate)}, 1.0 / rate, {}};
      run.key = name + std::to_string(rate);
      study.runs.push_back(run);
    }
  }
  return study;
}

/// Of one simulated second.
inline StudyResult result_of(double error, double cost_ms) {
  StudyResult result;
  result.status = RunStatus::ended;
  result.errors = {error};
  result.energy_error = error / 2;
  result.simulated_s = 1;
  result.cpu_s = 1e-3 * cost_ms;
  return result;
}

}  // namespace proofreel::test
