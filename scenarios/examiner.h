#pragma once

/// What is measured and expected along a run.

#include <cstdint>
#include <vector>

#include "scenarios/run_report.h"
#include "scenarios/run_saver.h"

namespace proofreel {

/// Asks the script for its measures, references and expectations, each at the ticks it speaks of, and keeps the
/// answers. Of one pane. `saver` is told before the script is asked; null for runs that are not saved.
class Examiner {
 public:
  /// The scenario must outlive the examiner; `last_tick` is that of the run.
  Examiner(const Scenario& scenario, std::int64_t last_tick);

  /// Begins with the expectations of a saved run as they stood; what cannot be known after it is marked.
  void take_up(const SavedRun& run);
  void look_at_measures(std::int64_t tick, bool sampled, RunSaver* saver);
  /// Puts the values another pane has sampled last behind those of this one's last sample.
  void add_last_sample_of(const std::vector<Sample>& other);
  void look_at_expectations(std::int64_t tick, RunSaver* saver);
  /// The simulation has failed: what was never looked at has not held.
  void give_up(std::int64_t tick);

  const std::vector<Sample>& samples() const { return samples_; }
  const std::vector<MeasureResult>& measures() const { return measures_; }
  const std::vector<ExpectationResult>& expectations() const { return expectations_; }
  /// How the expectations stand, for a run to go on with.
  std::vector<SavedExpectation> to_be_saved() const;

 private:
  bool is_settled(std::size_t i, const SavedRun& run) const;
  void look_at_measure(std::size_t i, std::int64_t tick, bool sampled, RunSaver* saver);
  bool is_due(const Expectation& expectation, std::int64_t tick) const;

  const Scenario& scenario_;
  std::int64_t last_tick_;
  std::vector<MeasureResult> measures_;
  std::vector<ExpectationResult> expectations_;
  std::vector<bool> looked_at_;  // expectations
  std::vector<Sample> samples_;
};

}  // namespace proofreel
