#pragma once

/// Gives the commands of a saved run again, in place of the script's callbacks.

#include <cstddef>
#include <cstdint>
#include <string>

#include "scenarios/saved_run.h"

namespace proofreel {

/// Whether a simulation can act on the command: what it names exists, and its data are sound. Those of a script always
/// are; those of a file need not be.
bool makes_sense(const Command& command, const Simulation& simulation);

class Replay {
 public:
  /// `file` is what messages call the run.
  Replay(SavedRun run, std::string file) : run_(std::move(run)), file_(std::move(file)) {}

  /// Applies what belongs to the simulation's tick, and lets the script know. Throws ScenarioError when a command makes
  /// no sense.
  void act(bool heard, Simulation& simulation, Script& script);
  /// Whether the simulation has come to where the saved run ended, along another trajectory: other builds may read the
  /// same files and yet step in another way.
  bool ended_elsewhere(const Simulation& simulation, std::uint64_t trajectory_hash) const;

 private:
  SavedRun run_;
  std::string file_;
  std::size_t next_ = 0;  ///< into the log
};

}  // namespace proofreel
