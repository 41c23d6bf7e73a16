#pragma once

/// The scorecard: scenarios that are hard to keep stable, by every method of the engine and by its peers.

#include <optional>
#include <string>
#include <vector>

#include "lab/grid.h"

namespace proofreel {

/// A row per scenario; a column per method, the default one first, then one per peer at its declared defaults. `set`
/// holds for all runs, unless the method says otherwise. Throws ScenarioError for a file that cannot be run as it is.
Grid scorecard_grid(const std::vector<std::string>& files, const std::vector<Peer>& against,
                    const std::vector<Override>& set);

/// How one method or peer did in all scenarios.
struct MethodScore {
  Heading heading;
  std::string engine;
  int counts[standing_count] = {};  ///< by Standing
  int scenarios = 0;
  double cost_ms = 0;              ///< CPU milliseconds per simulated second, over the runs that came to an end
  int costed = 0;                  ///< how many these are
  std::optional<double> to_box2d;  ///< cost against Box2D's, over the scenarios both came to an end with
  int shared = 0;                  ///< how many these are

  int count(Standing standing) const { return counts[static_cast<std::size_t>(standing)]; }
};

/// A score per column. The first column of Box2D is what costs are held against, where there is one.
std::vector<MethodScore> scores_of(const Grid& grid, const std::vector<RunResult>& results);

/// Whether the default method, the first column, stands in every scenario.
bool default_stands(const Grid& grid, const std::vector<RunResult>& results);

}  // namespace proofreel
