#include "scenarios/run_saver.h"

#include <utility>

#include "scenarios/suggest.h"

namespace proofreel {
namespace {

bool makes_something(const Command& command) {
  return std::holds_alternative<CreateBody>(command) || std::holds_alternative<CreateJoint>(command);
}

}  // namespace

RunSaver::RunSaver(Scenario& scenario, const std::vector<std::int64_t>& ticks) : scenario_(scenario) {
  for (const std::int64_t tick : ticks) runs_[tick];
  scenario_.script->remember_variables();
  scenario_.script->log_commands(&given_);
}

RunSaver::~RunSaver() { scenario_.script->log_commands(nullptr); }

void RunSaver::keep(SavedRun run) {
  run.scenario = scenario_.id;
  run.source_hash = scenario_.source_hash;
  run.settings = scenario_.settings;
  for (const LoggedCommand& logged : log_) {
    if (makes_something(logged.command)) run.made.push_back(logged.command);
  }
  runs_[run.tick] = std::move(run);
}

void RunSaver::log(std::int64_t tick, bool heard) {
  for (Command& command : given_) log_.push_back({tick, heard, std::move(command)});
  given_.clear();
}

void RunSaver::watch(ScriptFunction what, int index, std::int64_t tick) {
  if (auto name = scenario_.script->changed_variable(what, index)) changes_[{what, index}] = {tick, std::move(*name)};
}

std::string RunSaver::changed_since(ScriptFunction what, int index, std::int64_t tick) const {
  const auto found = changes_.find({what, index});
  return found != changes_.end() && found->second.tick >= tick ? found->second.variable : std::string();
}

SavedRun RunSaver::saved(std::int64_t tick, std::int64_t last_tick, std::uint64_t last_hash) const {
  const std::string field = changed_since(ScriptFunction::field, 0, tick);
  if (!field.empty()) {
    throw ScenarioError(scenario_.path + " cannot be saved: a force field can see the variable " + quote(field) +
                        ", which the script changes on the way, and variables are not saved");
  }
  SavedRun run = runs_.at(tick);
  if (run.state.empty())
    throw ScenarioError(scenario_.path + " cannot be saved: the simulation stopped before the time to save at");
  run.logged_until = last_tick;
  run.last_trajectory_hash = last_hash;
  for (std::size_t i = 0; i < run.expectations.size(); ++i) {
    run.expectations[i].changed_variable = changed_since(ScriptFunction::expectation, static_cast<int>(i), tick);
  }
  for (std::size_t i = 0; i < scenario_.measures.size(); ++i) {
    run.changed_variables.push_back(changed_since(ScriptFunction::measure, static_cast<int>(i), tick));
  }
  for (const LoggedCommand& logged : log_) {
    if (logged.tick > tick || (logged.tick == tick && !logged.heard)) run.log.push_back(logged);
  }
  return run;
}

}  // namespace proofreel
