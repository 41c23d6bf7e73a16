#pragma once

/// Files of `run --save T:FILE` and `run --resume FILE`.

#include <cstdint>
#include <string>
#include <vector>

#include "scenarios/runner.h"

namespace proofreel {

struct SaveTarget {
  std::int64_t tick = 0;
  std::string file;
};

/// What `--save T:FILE`, given so many times, asks for: T rounds to the nearest tick. Throws UsageError when one is
/// written wrongly, lies after the end, or names a file that another one names, and EnvironmentError when a file cannot
/// be written.
std::vector<SaveTarget> save_targets(const std::vector<std::string>& options, const Scenario& scenario);

/// After the end of the run. Throws ScenarioError and EnvironmentError; then none of the files has been touched that
/// come from there on.
void write_saved(const std::vector<SaveTarget>& targets, const Runner& runner);

/// Throws ScenarioError when there is no such file, or it is none of ours.
SavedRun read_saved(const std::string& file);

}  // namespace proofreel
