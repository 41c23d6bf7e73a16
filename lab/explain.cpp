#include "lab/explain.h"

#include <algorithm>

#include "lab/callgrind.h"
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
    {Effect::buoyancy, StepStage::buoyancy, ""},
    {Effect::field, StepStage::field, ""},
    {Effect::springs, StepStage::springs, ""},
    {Effect::rocket, StepStage::rocket, ""},
    {Effect::contacts, StepStage::contact_solver, ""},
    {Effect::friction, std::nullopt, "contacts"},
    {Effect::rolling_resistance, std::nullopt, "contacts"},
    {Effect::restitution, StepStage::restitution, ""},
    {Effect::surface_speed, std::nullopt, "contacts"},
    {Effect::ccd, std::nullopt, "narrow_phase"},
    {Effect::joints, StepStage::joint_solver, ""},
    {Effect::limits, std::nullopt, "joints"},
    {Effect::motors, std::nullopt, "joints"},
    {Effect::breakage, std::nullopt, "joints"},
    {Effect::sensors, std::nullopt, "narrow_phase"},
    {Effect::sleeping, StepStage::sleeping, ""},
};

const Cost& cost_of(Effect effect) {
  return *std::find_if(std::begin(costs), std::end(costs), [&](const Cost& cost) { return cost.effect == effect; });
}

std::int64_t dynamic_bodies(const Simulation& simulation) {
  Snapshot snapshot;
  simulation.observe(snapshot);
  return std::count_if(snapshot.bodies.begin(), snapshot.bodies.end(),
                       [](const BodyView& body) { return body.type == BodyType::dynamic; });
}

class Table {
 public:
  Table(const StageTimes& times, std::int64_t ticks) : times_(times), ticks_(ticks) {}

  void add(std::string name, bool on, std::string why, std::optional<StepStage> stage, const char* part_of = "") {
    // Where bodies are free, what acts on them is one loop with their motion.
    const bool of_its_own = on && stage && (times_.of(*stage) > 0 || *stage == StepStage::motion);
    std::optional<double> cost;
    if (of_its_own) cost = 1e6 * times_.of(*stage) / static_cast<double>(std::max<std::int64_t>(ticks_, 1));
    if (on && stage && !of_its_own) part_of = "motion";
    rows_.push_back({std::move(name), on, std::move(why), cost, on ? part_of : ""});
  }
  std::vector<ExplainedStage> take() { return std::move(rows_); }

 private:
  const StageTimes& times_;
  std::int64_t ticks_;
  std::vector<ExplainedStage> rows_;
};

}  // namespace

double instructions_per_body_step(const Explanation& explanation, const std::vector<std::string>& run) {
  const auto steps = static_cast<double>(explanation.ticks * explanation.substeps * explanation.bodies);
  return steps > 0 ? static_cast<double>(instructions(run, "*World::step()*")) / steps : 0;
}

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
    const std::string how = decision.how.empty() ? "" : "; " + decision.how;
    table.add(name_of(decision.effect), decision.on, decision.why + how, cost.stage, cost.part_of);
  }
  table.add("motion", true, "bodies move, and what they did is kept", StepStage::motion);
  const int substeps = scenario.scene.method.substeps;
  Explanation explanation{scenario.id, runner.tick(), 0, substeps, dynamic_bodies(runner.simulation()), table.take()};
  for (const ExplainedStage& stage : explanation.stages) explanation.us_per_tick += stage.us_per_tick.value_or(0);
  return explanation;
}

}  // namespace proofreel
