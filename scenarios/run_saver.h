#pragma once

/// Keeps along a run what it takes to go on with it later from some of its ticks (saved_run.h).

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "scenarios/saved_run.h"

namespace proofreel {

class RunSaver {
 public:
  /// `ticks` are those to save. The script must not have run since it was loaded, and outlive this.
  RunSaver(Scenario& scenario, const std::vector<std::int64_t>& ticks);
  ~RunSaver();
  RunSaver(const RunSaver&) = delete;
  RunSaver& operator=(const RunSaver&) = delete;

  bool wants(std::int64_t tick) const { return runs_.contains(tick); }
  /// The run as it is when all is done that belongs to its tick. The log is added later.
  void keep(SavedRun run);
  /// Takes down the commands the script has given since the last call.
  void log(std::int64_t tick, bool heard);
  /// The function is about to be asked at this tick: looks whether a variable that it can see has changed.
  void watch(ScriptFunction what, int index, std::int64_t tick);
  /// What was kept at this tick, whole, after a run that ended at `last_tick` with that trajectory hash. Throws
  /// ScenarioError when it never came there, and when a force field can see a variable that changed.
  SavedRun saved(std::int64_t tick, std::int64_t last_tick, std::uint64_t last_hash) const;

 private:
  /// The last tick at which a function could see a changed variable.
  struct Change {
    std::int64_t tick = -1;
    std::string variable;
  };
  std::string changed_since(ScriptFunction what, int index, std::int64_t tick) const;

  Scenario& scenario_;
  std::map<std::int64_t, SavedRun> runs_;
  std::vector<Command> given_;  ///< since the last call of `log`
  std::vector<LoggedCommand> log_;
  std::map<std::pair<ScriptFunction, int>, Change> changes_;
};

}  // namespace proofreel
