#pragma once

#include <optional>
#include <string>
#include <vector>

#include "lab/children.h"
#include "lab/grid.h"
#include "render/context.h"

namespace proofreel {

/// How a grid is worked off.
struct GridWork {
  std::string folder;   ///< where its table, pictures and page go
  std::string table;    ///< name of the table in it: "scorecard.csv"
  double limit_s = 10;  ///< CPU seconds the steps of a run may take
  int at_once = 1;      ///< runs at a time; beside others each takes longer
  std::optional<GlBackend> gl;
};

/// Makes the folder and runs what its table does not know yet, each run in a process of its own; every one that ends is
/// written down at once, with its still, so that whoever stops this and starts it again goes on where it was. Runs that
/// can only come out the same are done once. `progress` counts what is to be done now. Throws UsageError and
/// EnvironmentError.
std::vector<RunResult> work_off(const Grid& grid, const GridWork& work, const WorkProgress& progress);

}  // namespace proofreel
