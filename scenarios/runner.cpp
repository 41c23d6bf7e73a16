#include "scenarios/runner.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstdio>

#include "scenarios/film.h"
#include "scenarios/recorder.h"
#include "scenarios/suggest.h"
#include "scenarios/timeline.h"

namespace proofreel {
namespace {

/// Binds a script to a simulation for as long as this lives.
class Binding {
 public:
  Binding(Script& script, Simulation& simulation) : script_(script) { script_.bind(&simulation); }
  ~Binding() { script_.bind(nullptr); }
  Binding(const Binding&) = delete;
  Binding& operator=(const Binding&) = delete;

 private:
  Script& script_;
};

void add_sample(MeasureResult& result, double value, bool first) {
  result.final = value;
  result.min = first ? value : std::min(result.min, value);
  result.max = first ? value : std::max(result.max, value);
}

bool draws_forces(const Picture& picture) {
  return std::any_of(picture.vectors.begin(), picture.vectors.end(), [](const VectorMark& mark) {
    return mark.of == VectorOf::force || mark.of == VectorOf::acceleration;
  });
}

std::string sentence(const Scenario& scenario, const Failure& failure) {
  const auto body = static_cast<std::size_t>(failure.body);
  const bool named = body >= 1 && body <= scenario.body_names.size();
  const std::string who = named ? "body " + quote(scenario.body_names[body - 1]) : std::string("the scene");
  char time[32];
  std::snprintf(time, sizeof time, "%.6g", static_cast<double>(failure.tick) / scenario.scene.rate);
  return scenario.path + ": the simulation stopped at tick " + std::to_string(failure.tick) + " (" + time + " s): in " +
         failure.stage + " the motion of " + who + " " + failure.what +
         "; use smaller forces or stiffness, or a higher rate";
}

}  // namespace

bool RunReport::all_held() const {
  return !failure && std::all_of(expectations.begin(), expectations.end(), [](const auto& e) { return e.held; });
}

struct Runner::Impl {
  Impl(Scenario& owner, std::unique_ptr<Simulation> stepped)
      : scenario(owner),
        simulation(std::move(stepped)),
        binding(*scenario.script, *simulation),
        last_tick(scenario.ticks()),
        recorder(scenario) {
    for (const Measure& measure : scenario.measures) report.measures.push_back({measure.name, 0, 0, 0, {}});
    for (const Expectation& expectation : scenario.expectations)
      report.expectations.push_back({expectation.text, true, 0});
    looked_at.resize(scenario.expectations.size());
    if (draws_forces(scenario.picture)) simulation->keep_forces();
    report.scenario = scenario.id;
    report.initial_energy = simulation->energy();
    report.trajectory_hash = chained_hash(0, simulation->state_hash());
    look();
  }

  bool finished() const { return simulation->tick() >= last_tick || simulation->failure(); }

  /// One tick; false when the simulation failed in it.
  bool advance() {
    scenario.script->before_step();
    simulation->step();
    if (simulation->failure()) return false;
    report.trajectory_hash = chained_hash(report.trajectory_hash, simulation->state_hash());
    scenario.script->after_step();
    look();
    return true;
  }

  /// Everything that is measured, recorded and expected at this tick.
  void look() {
    const std::int64_t tick = simulation->tick();
    const bool sampled = is_sample_tick(scenario, tick);
    recorder.record(*simulation);
    if (sampled) {
      recorder.sample_plots(tick);
      book_energy();
      samples.push_back({tick, {}});
    }
    for (std::size_t i = 0; i < scenario.measures.size(); ++i) look_at_measure(i, tick, sampled);
    for (std::size_t i = 0; i < scenario.expectations.size(); ++i) look_at_expectation(i, tick);
  }

  void book_energy() {
    const Energy now = simulation->energy();
    const double drift = now.total() - now.booked_work - report.initial_energy.total();
    report.max_energy_drift = std::max(report.max_energy_drift, std::abs(drift));
    report.final_energy = now;
  }

  void look_at_measure(std::size_t i, std::int64_t tick, bool sampled) {
    const int index = static_cast<int>(i);
    const auto reference = scenario.script->reference(index, tick);
    if (!sampled && !reference) return;
    const double value = scenario.script->measure(index);
    MeasureResult& result = report.measures[i];
    if (sampled) {
      samples.back().values.push_back(value);
      add_sample(result, value, samples.size() == 1);
    }
    if (reference) result.max_error = std::max(result.max_error.value_or(0), std::abs(value - *reference));
  }

  bool is_due(const Expectation& expectation, std::int64_t tick) const {
    switch (expectation.when) {
      case Expectation::When::always:
        return true;
      case Expectation::When::at:
        return tick_at(expectation.at, scenario.scene.rate) == tick;
      case Expectation::When::finally:
        return tick == last_tick;
    }
    return false;
  }

  void look_at_expectation(std::size_t i, std::int64_t tick) {
    ExpectationResult& result = report.expectations[i];
    if (!result.held || !is_due(scenario.expectations[i], tick)) return;
    result.held = scenario.script->expectation(static_cast<int>(i));
    result.tick = tick;
    looked_at[i] = true;
  }

  /// After a failure of the simulation, what was never looked at has not held.
  void give_up() {
    report.failure = simulation->failure();
    for (std::size_t i = 0; i < looked_at.size(); ++i) {
      if (!looked_at[i]) report.expectations[i] = {scenario.expectations[i].text, false, simulation->tick()};
    }
  }

  Scenario& scenario;
  std::unique_ptr<Simulation> simulation;
  Binding binding;
  std::int64_t last_tick;
  Recorder recorder;
  RunReport report;
  std::vector<Sample> samples;
  std::vector<bool> looked_at;  ///< expectations
};

Runner::Runner(Scenario& scenario) : Runner(scenario, make_simulation(scenario.scene)) {}

Runner::Runner(Scenario& scenario, std::unique_ptr<Simulation> simulation)
    : impl_(std::make_unique<Impl>(scenario, std::move(simulation))) {}

Runner::~Runner() = default;

void Runner::step() {
  assert(!finished());
  if (!impl_->advance()) throw ScenarioError(sentence(impl_->scenario, *impl_->simulation->failure()));
}

bool Runner::finished() const { return impl_->finished(); }
std::int64_t Runner::tick() const { return impl_->simulation->tick(); }
std::uint64_t Runner::trajectory_hash() const { return impl_->report.trajectory_hash; }
const Simulation& Runner::simulation() const { return *impl_->simulation; }
const std::vector<Sample>& Runner::samples() const { return impl_->samples; }

Frame Runner::frame(std::int64_t index) const {
  Snapshot snapshot;
  impl_->simulation->observe(snapshot);
  return make_frame(impl_->scenario, impl_->recorder, std::move(snapshot), index);
}

RunReport Runner::finish() {
  while (!finished()) impl_->advance();
  if (impl_->simulation->failure()) impl_->give_up();
  RunReport report = impl_->report;
  report.ticks = impl_->simulation->tick();
  report.state_hash = impl_->simulation->state_hash();
  return report;
}

}  // namespace proofreel
