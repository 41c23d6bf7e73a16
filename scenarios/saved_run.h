#pragma once

/// A run that can be gone on with later, in another process: the state of its simulation at one tick, and all commands
/// its script gave from then on. Resuming runs no callbacks but gives the same commands again at the same ticks; so the
/// motion is the same to the last bit, and measures are whatever the scenario measures.
///
/// A script's variables are not saved. Whatever can see one that changed during the saved run is not known after
/// resuming, and says so; a force field that can is a reason to refuse.

#include <cstddef>
#include <cstdint>
#include <map>
#include <span>
#include <string>
#include <vector>

#include "engine/simulation.h"
#include "scenarios/scenario.h"

namespace proofreel {

struct LoggedCommand {
  std::int64_t tick = 0;  ///< the simulation's
  bool heard = false;     ///< by what the step to that tick set off; otherwise due at that tick, before the next step
  Command command;
};

/// How an expectation stood at the saved tick.
struct SavedExpectation {
  bool held = true;
  bool looked_at = false;
  std::int64_t tick = 0;
  std::string changed_variable;  ///< that it can see; empty when there is none
};

struct SavedRun {
  std::string scenario;  ///< its id
  std::uint64_t source_hash = 0;
  std::map<std::string, std::string> settings;
  std::int64_t tick = 0;
  std::int64_t logged_until = 0;  ///< the last tick of the saved run
  std::uint64_t last_trajectory_hash = 0;
  std::vector<std::byte> state;  ///< of the simulation
  std::uint64_t trajectory_hash = 0;
  Energy initial_energy;
  std::vector<SavedExpectation> expectations;
  std::vector<std::string> changed_variables;  ///< by measure: one that it can see; empty when there is none
  std::vector<Command> made;                   ///< what bodies and joints callbacks had made until then
  std::vector<LoggedCommand> log;              ///< from then on, in order
};

std::vector<std::byte> bytes_of(const SavedRun& run);

/// Throws ScenarioError, naming `file`, when these are not the bytes of a saved run.
SavedRun saved_run_in(std::span<const std::byte> bytes, const std::string& file);

/// Throws ScenarioError, naming `file`, when the run is not one of this scenario, or cannot be gone on with: "...
/// cannot be resumed: callbacks were not logged beyond t=2 s ...".
void check_resumable(const SavedRun& run, const Scenario& scenario, const std::string& file);

}  // namespace proofreel
