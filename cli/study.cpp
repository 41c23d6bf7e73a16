#include <iostream>
#include <memory>

#include "cli/commands.h"
#include "cli/scenario_files.h"
#include "cli/score_options.h"
#include "golden/json.h"
#include "lab/score_text.h"
#include "lab/study_map.h"
#include "render/usage_error.h"

namespace proofreel {
namespace {

struct Options {
  GridOptions grid;
  std::string scenario;
  std::vector<std::string> vary;
  bool map = false;
};

/// scenario, and runs: {set: {key: value}, state, cpu_ms_per_s (null where it came to no end), cheapest, why} each.
Json json_of(const Grid& grid, const std::vector<RunResult>& results) {
  Json runs = Json::array();
  const std::vector<bool> best = cheapest(grid, results);
  for (std::size_t i = 0; i < results.size(); ++i) {
    Json values = Json::object();
    for (std::size_t k = 0; k < grid.keys.size(); ++k) values[grid.keys[k]] = grid.runs[i].values[k];
    Json run{{"set", values},
             {"state", name_of(results[i].standing)},
             {"cpu_ms_per_s", nullptr},
             {"cheapest", static_cast<bool>(best[i])},
             {"why", results[i].why}};
    if (results[i].cost_ms()) run["cpu_ms_per_s"] = *results[i].cost_ms();
    runs.push_back(run);
  }
  return {{"scenario", grid.runs.front().scenario}, {"runs", runs}};
}

void print(const Grid& grid, const std::vector<RunResult>& results) {
  const std::vector<bool> best = cheapest(grid, results);
  for (std::size_t i = 0; i < results.size(); ++i) {
    const Heading& row = grid.rows[i / grid.columns.size()];
    const Heading& column = grid.columns[i % grid.columns.size()];
    const std::string where = label_of(grid, column) + ", " + label_of(grid, row);
    std::printf("%-40s %-12s %10s ms/s%s\n", where.c_str(), name_of(results[i].standing),
                cost_text(results[i].cost_ms()).c_str(), best[i] ? "   the cheapest that stands" : "");
  }
}

int study(const Options& options) {
  if (!options.map) throw UsageError("study draws maps so far: give --map, and --vary KEY=VALUES for the axes.");
  require_folder(options.grid);
  const std::vector<Axis> axes = map_axes(options.vary);
  const Grid grid = map_grid(scenario_file(options.scenario), axes, options.grid.common.overrides());
  const GridFiles files = make_grid_files(grid, "map", false, options.grid);
  if (options.grid.json) {
    std::cout << json_text(json_of(grid, files.results), 2) << "\n";
  } else {
    print(grid, files.results);
  }
  return 0;
}

}  // namespace

Subcommand study_command(CLI::App& program) {
  const auto options = std::make_shared<Options>();
  CLI::App* app = add_command(program, "study", "Where a scenario stands over two keys, and what that costs",
                              "proofreel study pyramid --map --vary rate=60,120 --vary substeps=1,2,4 -o map",
                              options->grid.common);
  app->add_option("SCENARIO", options->scenario, "Path of a .lua file, or an id such as pyramid")->required();
  app->add_flag("--map", options->map, "A map of two axes");
  app->add_option("--vary", options->vary, "An axis; instead of missing ones rate=60,120,240 and substeps=1,2,4,8")
      ->type_name("KEY=A,B,...")
      ->allow_extra_args(false);
  add_grid_options(*app, options->grid);
  refuse_not_built(*app, {"--against", "--measure", "--target", "--film"});
  return {app, [options] { return study(*options); }};
}

}  // namespace proofreel
