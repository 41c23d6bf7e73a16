#pragma once

/// Which parts a scenario's step is put together from, why, and what each of them costs.

#include <optional>
#include <string>
#include <vector>

#include "scenarios/scenario.h"

namespace proofreel {

struct ExplainedStage {
  std::string name;  ///< of an effect, or of a part that belongs to one
  bool on = false;
  std::string why;
  std::optional<double> us_per_tick;  ///< microseconds; nothing for what is off, or part of another line
  std::string part_of;                ///< the line that has its time, when that is another one
};

struct Explanation {
  std::string scenario;
  std::int64_t ticks = 0;
  double us_per_tick = 0;   ///< all stages together
  int substeps = 1;         ///< per tick
  std::int64_t bodies = 0;  ///< dynamic ones, at the last tick
  std::vector<ExplainedStage> stages;
};

/// Runs the scenario to its end, which takes the time it takes. What acts is told as of the last tick: a script may
/// have called for more than it began with.
Explanation explain(Scenario& scenario);

/// Instructions that one dynamic body takes in one substep, everything the step does included, as valgrind counts them.
/// `run` is the command that runs the explained scenario. Throws EnvironmentError where valgrind is missing.
double instructions_per_body_step(const Explanation& explanation, const std::vector<std::string>& run);

}  // namespace proofreel
