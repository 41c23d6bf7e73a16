#pragma once

/// What `scorecard` and `study` have in common on the command line.

#include <string>
#include <vector>

#include "cli/options.h"
#include "lab/grid_work.h"
#include "lab/scorecard.h"

namespace proofreel {

struct GridOptions {
  CommonOptions common;
  std::string folder;
  double limit_s = 10;
  bool json = false;
};

/// -o, --limit and --json; `--threads` says how many runs go on at once.
void add_grid_options(CLI::App& command, GridOptions& options);

/// Throws UsageError without -o.
void require_folder(const GridOptions& options);

/// What was written down.
struct GridFiles {
  std::vector<RunResult> results;
  std::vector<MethodScore> scores;  ///< empty where none were asked for
};

/// Works the grid off with a line of progress, and writes NAME.csv, NAME.html and NAME.png.
GridFiles make_grid_files(const Grid& grid, const std::string& name, bool with_scores, const GridOptions& options);

}  // namespace proofreel
