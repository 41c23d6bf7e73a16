#pragma once

/// What pictures show of the past: trails, plots, and where a followed body was last seen. Memory is bounded by the
/// seconds each of them shows.

#include <cstdint>
#include <deque>
#include <optional>
#include <utility>
#include <vector>

#include "engine/simulation.h"
#include "scenarios/frame.h"
#include "scenarios/scenario.h"

namespace proofreel {

class Recorder {
 public:
  explicit Recorder(const Scenario& scenario) : scenario_(scenario) {}

  /// After every tick, and before the first.
  void record(const Simulation& simulation);
  /// At every sampled tick: asks the script for the values of all curves.
  void sample_plots(std::int64_t tick);

  /// At every sampled tick; the first one is what the run started with.
  void note_energy(const Energy& energy);
  const EnergyExtent& energy() const { return energy_.value(); }

  /// Each ends where its body is now, `snapshot` being of the last recorded tick.
  std::vector<TrailView> trails(const Snapshot& snapshot) const;
  std::vector<PlotView> plots() const;
  /// One for every ghost mark: where its body stood at every multiple of `every`, up to now.
  std::vector<GhostView> ghosts() const;
  /// Where the body that camera move `move` follows is, or was when it was removed.
  std::optional<Vec2d> followed(std::size_t move) const;

 private:
  struct Trail {
    std::int64_t stride = 1;  ///< ticks between points
    std::deque<std::pair<std::int64_t, Vec2d>> points;
  };
  struct PlotSample {
    double time = 0;
    std::vector<double> values;  ///< of the curves; of a phase portrait, then its x
  };
  struct Plot {
    std::deque<PlotSample> samples;
    Reach x;  ///< of all samples ever taken
    Reach y;
  };

  void record_trail(std::size_t index, const Simulation& simulation);
  void record_ghost(std::size_t index, const Simulation& simulation);

  const Scenario& scenario_;
  std::vector<Trail> trails_;
  std::vector<Plot> plots_;
  std::vector<std::optional<Vec2d>> followed_;
  std::vector<std::vector<Posed>> ghosts_;
  std::optional<EnergyExtent> energy_;
};

}  // namespace proofreel
