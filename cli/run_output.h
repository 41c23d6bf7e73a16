#pragma once

/// How `run` tells what happened: as text, as JSON, as CSV.

#include <string>
#include <vector>

#include "golden/json.h"
#include "scenarios/runner.h"

namespace proofreel {

/// Who has stepped a run.
struct Stepper {
  std::string name = "proofreel";
  std::string version = PROOFREEL_VERSION;
  Json settings = nullptr;  ///< of a peer: what it was stepped with; our engine's follow from the scenario and `--set`
  bool is_peer() const { return !settings.is_null(); }
};

/// A few lines for people.
std::string text_of(const RunReport& report, const Stepper& stepper);

/// One object: scenario, ticks, trajectory_hash, state_hash (16 hex digits each), measures {name: {final, min, max,
/// max_error}}, expectations [{text, held, tick}], energy {initial, final, max_drift}, energy_grew (null,
/// or {tick, joules}: energy beyond the work done on the scene), wall_s, warnings, engine {name, version, settings};
/// and resumed_at (a tick) when it was resumed. Numbers in SI; max_error is null for measures without reference, and
/// whatever is not known after resuming is null. Of a peer (engine.settings is not null) hashes are of its own motion
/// and promise nothing on another machine, max_drift contains the work done during steps, and energy_grew is null.
Json json_of(const RunReport& report, const Stepper& stepper, const std::vector<std::string>& warnings, double wall_s);

/// A list of {text, held, tick}.
Json json_of(const std::vector<ExpectationResult>& expectations);

/// A header (t and the measures' names), then one row per sample. Numbers are written so that they read back exactly.
std::string csv_of(const Scenario& scenario, const std::vector<Sample>& samples);

/// Sentences about what is not known after resuming.
std::vector<std::string> unknowns_of(const RunReport& report);

/// Sentences about the expectations that do not hold.
std::vector<std::string> failures_of(const std::string& scenario, const std::vector<ExpectationResult>& expectations);

}  // namespace proofreel
