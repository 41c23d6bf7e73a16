#include "lab/scorecard.h"

#include <filesystem>
#include <iostream>
#include <memory>

#include "cli/commands.h"
#include "cli/run_peer.h"
#include "cli/scenario_files.h"
#include "cli/score_options.h"
#include "golden/json.h"
#include "lab/score_text.h"

namespace proofreel {
namespace {

struct Options {
  GridOptions grid;
  std::vector<std::string> scenarios;
  std::vector<std::string> against;
};

std::vector<std::string> files_of(const Options& options) {
  const std::string hard = (std::filesystem::path(scenarios_folder()) / "hard").string();
  return scenario_files_meant(options.scenarios, hard);
}

/// One of `methods`: engine, method, scenarios (how many), cpu_ms_per_s (CPU milliseconds per simulated second, summed
/// over the `costed` scenarios it came to an end with), to_box2d (that over Box2D's, over the `shared` ones both did;
/// null without Box2D), and how many scenarios it stands, degrades, fails, is too slow or not offered in.
Json json_of(const MethodScore& score) {
  Json json{{"engine", score.engine},        {"method", name_of(score.heading)}, {"scenarios", score.scenarios},
            {"cpu_ms_per_s", score.cost_ms}, {"costed", score.costed},           {"to_box2d", nullptr},
            {"shared", score.shared}};
  for (int i = 0; i < standing_count; ++i) json[name_of(static_cast<Standing>(i))] = score.counts[i];
  if (score.to_box2d) json["to_box2d"] = *score.to_box2d;
  return json;
}

/// What keeps the default method from standing everywhere: {scenario, state, why} each.
Json default_problems(const Grid& grid, const std::vector<RunResult>& results) {
  Json problems = Json::array();
  for (std::size_t row = 0; row < grid.rows.size(); ++row) {
    const RunResult& result = results[grid.index(row, 0)];
    if (result.standing == Standing::stands) continue;
    problems.push_back({{"scenario", grid.rows[row].name}, {"state", name_of(result.standing)}, {"why", result.why}});
  }
  return problems;
}

void print(const MethodScore& score) {
  std::printf("%-42s %3d of %3d %9d %6d %9d %12d %10s", name_of(score.heading).c_str(), score.count(Standing::stands),
              score.scenarios, score.count(Standing::degrades), score.count(Standing::fails),
              score.count(Standing::too_slow), score.count(Standing::not_offered), cost_text(score.cost_ms).c_str());
  std::printf(" %-5s", ("(" + std::to_string(score.costed) + ")").c_str());
  if (score.to_box2d) std::printf(" %7.2f (%d)", *score.to_box2d, score.shared);
  std::printf("\n");
}

void print(const Grid& grid, const GridFiles& files) {
  std::printf("%-42s %10s %9s %6s %9s %12s %10s       %s\n", "method", "stands", "degrades", "fails", "too slow",
              "not offered", "CPU ms/s", "to Box2D");
  for (const MethodScore& score : files.scores) print(score);
  for (const Json& problem : default_problems(grid, files.results)) {
    std::printf("%s %s: %s\n", problem.at("scenario").get<std::string>().c_str(),
                problem.at("state").get<std::string>().c_str(), problem.at("why").get<std::string>().c_str());
  }
}

int scorecard(const Options& options) {
  require_folder(options.grid);
  const Grid grid = scorecard_grid(files_of(options), peers_meant(options.against), options.grid.common.overrides());
  const GridFiles files = make_grid_files(grid, "scorecard", true, options.grid);
  const bool passed = default_stands(grid, files.results);
  if (options.grid.json) {
    Json methods = Json::array();
    for (const MethodScore& score : files.scores) methods.push_back(json_of(score));
    const Json json{{"passed", passed},
                    {"scenarios", grid.rows.size()},
                    {"methods", methods},
                    {"default_method", default_problems(grid, files.results)}};
    std::cout << json_text(json, 2) << "\n";
  } else {
    print(grid, files);
  }
  return passed ? 0 : 1;
}

}  // namespace

Subcommand scorecard_command(CLI::App& program) {
  const auto options = std::make_shared<Options>();
  CLI::App* app = add_command(program, "scorecard", "Hard cases by every method and by other engines: what stands",
                              "proofreel scorecard --against box2d,chipmunk -o card", options->grid.common);
  app->add_option("SCENARIO", options->scenarios, "Files, ids or folders; scenarios/hard when none is given");
  app->add_option("--against", options->against, "Other engines: box2d, chipmunk")->delimiter(',')->type_name("PEERS");
  add_grid_options(*app, options->grid);
  return {app, [options] { return scorecard(*options); }};
}

}  // namespace proofreel
