#include "lab/explain.h"

#include <algorithm>

#include "scenarios/runner.h"

namespace proofreel {
namespace {

/// An effect's own stage, or the line its work is counted in.
struct Cost {
  Effect effect;
  std::optional<StepStage> stage;
  const char* part_of = "";
};

constexpr Cost costs[] = {
    {Effect::gravity, StepStage::gravity, ""},
    {Effect::drag, StepStage::drag, ""},
    {Effect::wind, std::nullopt, "drag"},
    {Effect::attractor, StepStage::attractor, ""},
    {Effect::nbody, StepStage::nbody, ""},
    {Effect::springs, StepStage::springs, ""},
    {Effect::rocket, StepStage::rocket, ""},
    {Effect::contacts, StepStage::contact_solver, ""},
    {Effect::friction, std::nullopt, "contacts"},
    {Effect::restitution, StepStage::restitution, ""},
    {Effect::ccd, std::nullopt, "narrow_phase"},
    {Effect::joints, StepStage::joint_solver, ""},
    {Effect::sensors, std::nullopt, "narrow_phase"},
};

const Cost& cost_of(Effect effect) {
  return *std::find_if(std::begin(costs), std::end(costs), [&](const Cost& cost) { return cost.effect == effect; });
}

class Table {
 public:
  Table(const StageTimes& times, std::int64_t ticks) : times_(times), ticks_(ticks) {}

  void add(std::string name, bool on, std::string why, std::optional<StepStage> stage, const char* part_of = "") {
    std::optional<double> cost;
    if (on && stage) cost = 1e6 * times_.of(*stage) / static_cast<double>(std::max<std::int64_t>(ticks_, 1));
    rows_.push_back({std::move(name), on, std::move(why), cost, on ? part_of : ""});
  }
  std::vector<ExplainedStage> take() { return std::move(rows_); }

 private:
  const StageTimes& times_;
  std::int64_t ticks_;
  std::vector<ExplainedStage> rows_;
};

}  // namespace

Explanation explain(Scenario& scenario) {
  StageTimes times;
  std::unique_ptr<Simulation> simulation = make_simulation(scenario.scene);
  simulation->time_stages(&times);
  Runner runner(scenario, std::move(simulation));
  while (!runner.finished()) runner.step();

  Table table(times, runner.tick());
  for (const EffectDecision& decision : runner.simulation().effects()) {
    if (decision.effect == Effect::contacts) {
      table.add("broad_phase", decision.on, decision.why, StepStage::broad_phase);
      table.add("narrow_phase", decision.on, decision.why, StepStage::narrow_phase);
    }
    const Cost& cost = cost_of(decision.effect);
    table.add(name_of(decision.effect), decision.on, decision.why, cost.stage, cost.part_of);
  }
  table.add("motion", true, "bodies move, and what they did is kept", StepStage::motion);
  Explanation explanation{scenario.id, runner.tick(), 0, table.take()};
  for (const ExplainedStage& stage : explanation.stages) explanation.us_per_tick += stage.us_per_tick.value_or(0);
  return explanation;
}

}  // namespace proofreel
