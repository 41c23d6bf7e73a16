#include "scenarios/examiner.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "scenarios/timeline.h"

namespace proofreel {
namespace {

void add_sample(MeasureResult& result, double value, bool first) {
  result.final = value;
  result.min = first ? value : std::min(result.min, value);
  result.max = first ? value : std::max(result.max, value);
}

}  // namespace

Examiner::Examiner(const Scenario& scenario, std::int64_t last_tick)
    : scenario_(scenario), last_tick_(last_tick), looked_at_(scenario.expectations.size()) {
  for (const Measure& measure : scenario.measures)
    measures_.push_back({name_in_pane(scenario, measure.name), 0, 0, 0, {}, {}});
  for (const Expectation& expectation : scenario.expectations)
    expectations_.push_back({name_in_pane(scenario, expectation.text), true, 0, {}});
}

void Examiner::take_up(const SavedRun& run) {
  for (std::size_t i = 0; i < run.expectations.size(); ++i) {
    const SavedExpectation& saved = run.expectations[i];
    expectations_[i].held = saved.held;
    expectations_[i].tick = saved.tick;
    expectations_[i].unknown_for = is_settled(i, run) ? std::string() : saved.changed_variable;
    looked_at_[i] = saved.looked_at;
  }
  for (std::size_t i = 0; i < run.changed_variables.size(); ++i) measures_[i].unknown_for = run.changed_variables[i];
}

/// Whether nothing that is still to come can change how an expectation of a saved run stood.
bool Examiner::is_settled(std::size_t i, const SavedRun& run) const {
  const Expectation& expectation = scenario_.expectations[i];
  const bool over =
      expectation.when == Expectation::When::at && tick_at(expectation.at, scenario_.scene.rate) <= run.tick;
  return !run.expectations[i].held || (over && run.expectations[i].looked_at);
}

void Examiner::look_at_measures(std::int64_t tick, bool sampled, RunSaver* saver) {
  if (sampled) samples_.push_back({tick, {}});
  for (std::size_t i = 0; i < measures_.size(); ++i) look_at_measure(i, tick, sampled, saver);
}

void Examiner::look_at_measure(std::size_t i, std::int64_t tick, bool sampled, RunSaver* saver) {
  const int index = static_cast<int>(i);
  MeasureResult& result = measures_[i];
  if (!result.unknown_for.empty()) {
    if (sampled) samples_.back().values.push_back(std::numeric_limits<double>::quiet_NaN());
    return;
  }
  if (saver != nullptr && sampled) saver->watch(ScriptFunction::measure, index, tick);
  const auto reference = scenario_.script->reference(index, tick);
  if (!sampled && !reference) return;
  if (saver != nullptr && !sampled) saver->watch(ScriptFunction::measure, index, tick);
  const double value = scenario_.script->measure(index);
  if (sampled) {
    samples_.back().values.push_back(value);
    add_sample(result, value, samples_.size() == 1);
  }
  if (reference) result.max_error = std::max(result.max_error.value_or(0), std::abs(value - *reference));
}

void Examiner::add_last_sample_of(const std::vector<Sample>& other) {
  std::vector<double>& values = samples_.back().values;
  const std::vector<double>& theirs = other.back().values;
  values.insert(values.end(), theirs.begin(), theirs.end());
}

bool Examiner::is_due(const Expectation& expectation, std::int64_t tick) const {
  switch (expectation.when) {
    case Expectation::When::always:
      return true;
    case Expectation::When::at:
      return tick_at(expectation.at, scenario_.scene.rate) == tick;
    case Expectation::When::finally:
      return tick == last_tick_;
  }
  return false;
}

void Examiner::look_at_expectations(std::int64_t tick, RunSaver* saver) {
  for (std::size_t i = 0; i < expectations_.size(); ++i) {
    ExpectationResult& result = expectations_[i];
    if (!result.held || !result.unknown_for.empty() || !is_due(scenario_.expectations[i], tick)) continue;
    if (saver != nullptr) saver->watch(ScriptFunction::expectation, static_cast<int>(i), tick);
    result.held = scenario_.script->expectation(static_cast<int>(i));
    result.tick = tick;
    looked_at_[i] = true;
  }
}

void Examiner::give_up(std::int64_t tick) {
  for (std::size_t i = 0; i < looked_at_.size(); ++i) {
    if (!looked_at_[i]) expectations_[i] = {expectations_[i].text, false, tick, {}};
  }
}

std::vector<SavedExpectation> Examiner::to_be_saved() const {
  std::vector<SavedExpectation> saved;
  for (std::size_t i = 0; i < looked_at_.size(); ++i)
    saved.push_back({expectations_[i].held, looked_at_[i], expectations_[i].tick, {}});
  return saved;
}

}  // namespace proofreel
