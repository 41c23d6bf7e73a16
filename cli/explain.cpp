#include "lab/explain.h"

#include <cstdio>
#include <iostream>
#include <memory>

#include "cli/commands.h"
#include "cli/scenario_files.h"
#include "golden/json.h"

namespace proofreel {
namespace {

struct Options {
  CommonOptions common;
  std::string scenario;
  bool json = false;
};

Json json_of(const Explanation& explanation) {
  Json stages = Json::array();
  for (const ExplainedStage& stage : explanation.stages) {
    Json row{{"name", stage.name}, {"on", stage.on}, {"why", stage.why}, {"us_per_tick", nullptr}};
    if (stage.us_per_tick) row["us_per_tick"] = *stage.us_per_tick;
    if (!stage.part_of.empty()) row["part_of"] = stage.part_of;
    stages.push_back(row);
  }
  return {{"scenario", explanation.scenario},
          {"ticks", explanation.ticks},
          {"us_per_tick", explanation.us_per_tick},
          {"stages", stages}};
}

void print_row(const ExplainedStage& stage, double whole) {
  std::printf("  %-12s  %-3s  ", stage.name.c_str(), stage.on ? "on" : "off");
  if (stage.us_per_tick) {
    std::printf("%9.2f us  %3.0f %%  ", *stage.us_per_tick, whole > 0 ? 100 * *stage.us_per_tick / whole : 0);
  } else {
    std::printf("%20s", "");
  }
  const std::string part = stage.part_of.empty() ? "" : " (its time is part of " + stage.part_of + ")";
  std::printf("%s%s\n", stage.why.c_str(), part.c_str());
}

void print(const Explanation& explanation) {
  std::printf("%s: %lld ticks, %.2f us per tick\n", explanation.scenario.c_str(),
              static_cast<long long>(explanation.ticks), explanation.us_per_tick);
  for (const ExplainedStage& stage : explanation.stages) print_row(stage, explanation.us_per_tick);
}

int explain_scenario(const Options& options) {
  const std::unique_ptr<Scenario> scenario = load_scenario(scenario_file(options.scenario), options.common.overrides());
  if (!options.common.quiet) say_all(scenario->warnings);
  const Explanation explanation = explain(*scenario);
  if (options.json) {
    std::cout << json_text(json_of(explanation), 2) << "\n";
  } else {
    print(explanation);
  }
  return 0;
}

}  // namespace

Subcommand explain_command(CLI::App& program) {
  const auto options = std::make_shared<Options>();
  CLI::App* app = add_command(program, "explain", "Which parts of the step a scenario calls for, why, and their cost",
                              "proofreel explain pendulum", options->common);
  app->add_option("SCENARIO", options->scenario, "Path of a .lua file, or an id such as pyramid")->required();
  app->add_flag("--json", options->json, "Print one JSON object instead of text");
  refuse_not_built(*app, {"--instructions"});
  return {app, [options] { return explain_scenario(*options); }};
}

}  // namespace proofreel
