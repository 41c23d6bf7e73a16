#pragma once

/// What a run of a scenario came to: measures, expectations, hashes and energies.

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "engine/simulation.h"
#include "scenarios/energy_watch.h"
#include "scenarios/scenario.h"

namespace proofreel {

/// Of a split screen, the names of measures and expectations begin with the pane they belong to: "title: name".
struct MeasureResult {
  std::string name;
  double final = 0;
  double min = 0;
  double max = 0;
  std::optional<double> max_error;  ///< max |measure - reference| over the samples a reference speaks of
  std::string unknown_for;          ///< the variable for which it is not known after resuming; empty when it is known
};

struct ExpectationResult {
  std::string text;
  bool held = true;
  std::int64_t tick = 0;    ///< where it first failed, or was last looked at
  std::string unknown_for;  ///< the variable for which nobody knows after resuming; empty when it is known
  bool failed() const { return unknown_for.empty() && !held; }
};

/// What was measured at one sampled tick.
struct Sample {
  std::int64_t tick = 0;
  std::vector<double> values;  ///< of measure_names, in their order; NaN where it is not known
};

/// What a measure or expectation of this pane is called: "title: name" where there are several panes.
std::string name_in_pane(const Scenario& pane, const std::string& name);
/// Of the scenario's measures, pane by pane.
std::vector<std::string> measure_names(const Scenario& scenario);

struct RunReport {
  std::string scenario;
  std::int64_t ticks = 0;
  std::uint64_t trajectory_hash = 0;
  std::uint64_t state_hash = 0;
  std::vector<MeasureResult> measures;
  std::vector<ExpectationResult> expectations;
  Energy initial_energy;
  Energy final_energy;
  double max_energy_drift = 0;              ///< J, |total - booked work - initial total|, over all samples
  std::optional<EnergyGrowth> energy_grew;  ///< beyond the booked work; never set for peers, which book none
  std::optional<Failure> failure;
  std::optional<std::int64_t> resumed_at;  ///< the tick from which on it was looked at, when that is not the first
  bool all_held() const;
};

}  // namespace proofreel
