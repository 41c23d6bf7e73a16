#pragma once

/// Runs a scenario tick by tick: script, step, measures, expectations, hashes. `run`, `render` and `check` all drive
/// this one class, so that they cannot disagree.

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "engine/simulation.h"
#include "scenarios/frame.h"
#include "scenarios/run_report.h"
#include "scenarios/saved_run.h"
#include "scenarios/scenario.h"

namespace proofreel {

/// Saving, resuming, peers, studies and scorecards are about one scene: throws ScenarioError where there are panes.
void must_be_one_scene(const Scenario& scenario);

/// The panes of a split screen are run side by side: each is at the last of its ticks that is not later than the first
/// pane's. Ticks, samples and frames are counted by the first; hashes, measures, expectations and energies are of all.
class Runner {
 public:
  /// The scenario must outlive the runner, and runs once.
  explicit Runner(Scenario& scenario);
  /// Steps a simulation made of the scenario's scene by somebody else: a peer, or a test. This and what is said of
  /// saving and resuming is for one scene: throws ScenarioError where there are panes.
  Runner(Scenario& scenario, std::unique_ptr<Simulation> simulation);
  /// Keeps what it takes to go on from these ticks later, in another process: see `saved`.
  Runner(Scenario& scenario, const std::vector<std::int64_t>& saved_ticks);
  /// Goes on with a saved run, without the script's callbacks. Measures speak of what is left; hashes, energies and
  /// expectations of the whole. Throws ScenarioError, naming `file`, when it cannot be resumed. Plots stay empty,
  /// trails and ghosts begin there.
  Runner(Scenario& scenario, const SavedRun& run, const std::string& file);
  ~Runner();
  Runner(const Runner&) = delete;
  Runner& operator=(const Runner&) = delete;

  /// One tick. Throws ScenarioError when the script fails, or when the simulation does (NaN: tick, body, stage).
  void step();
  bool finished() const;
  std::int64_t tick() const;
  std::uint64_t trajectory_hash() const;
  const Simulation& simulation() const;  ///< of the first pane
  /// The picture of this moment, as film frame `index`. Plots and trails hold what happened until now.
  Frame frame(std::int64_t index) const;
  /// All samples so far: one at every film frame's tick and one at the last.
  const std::vector<Sample>& samples() const;
  /// Steps what is left and says how it went. `after_tick` is called after every tick of it.
  RunReport finish(const std::function<void()>& after_tick = {});
  /// After the end: the run as it was at one of the ticks to save. Throws ScenarioError.
  SavedRun saved(std::int64_t tick) const;
  /// Goes on in another simulation, made of the same scene, that takes up the state of the present one; the script
  /// follows. Throws ScenarioError when one of the two does not offer that.
  void move_to(std::unique_ptr<Simulation> fresh);

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace proofreel
