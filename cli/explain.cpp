#include "lab/explain.h"

#include <cstdio>
#include <filesystem>
#include <iostream>
#include <memory>
#include <optional>

#include "cli/commands.h"
#include "cli/scenario_files.h"
#include "golden/json.h"

namespace proofreel {
namespace {

struct Options {
  CommonOptions common;
  std::string scenario;
  bool json = false;
  bool instructions = false;
};

Json json_of(const Explanation& explanation, std::optional<double> instructions) {
  Json stages = Json::array();
  for (const ExplainedStage& stage : explanation.stages) {
    Json row{{"name", stage.name}, {"on", stage.on}, {"why", stage.why}, {"us_per_tick", nullptr}};
    if (stage.us_per_tick) row["us_per_tick"] = *stage.us_per_tick;
    if (!stage.part_of.empty()) row["part_of"] = stage.part_of;
    stages.push_back(row);
  }
  Json whole{{"scenario", explanation.scenario},
             {"ticks", explanation.ticks},
             {"us_per_tick", explanation.us_per_tick},
             {"stages", stages}};
  if (instructions) whole["instructions_per_body_step"] = *instructions;
  return whole;
}

void print_row(const ExplainedStage& stage, double whole) {
  std::printf("  %-18s  %-3s  ", stage.name.c_str(), stage.on ? "on" : "off");
  if (stage.us_per_tick) {
    std::printf("%9.2f us  %3.0f %%  ", *stage.us_per_tick, whole > 0 ? 100 * *stage.us_per_tick / whole : 0);
  } else {
    std::printf("%20s", "");
  }
  const std::string part = stage.part_of.empty() ? "" : " (its time is part of " + stage.part_of + ")";
  std::printf("%s%s\n", stage.why.c_str(), part.c_str());
}

void print(const Explanation& explanation, std::optional<double> instructions) {
  std::printf("%s: %lld ticks, %.2f us per tick\n", explanation.scenario.c_str(),
              static_cast<long long>(explanation.ticks), explanation.us_per_tick);
  for (const ExplainedStage& stage : explanation.stages) print_row(stage, explanation.us_per_tick);
  if (!instructions) return;
  std::printf("%.1f instructions per body and substep (%lld dynamic bodies, %d substeps)\n", *instructions,
              static_cast<long long>(explanation.bodies), explanation.substeps);
}

/// This program, running the same scenario.
std::vector<std::string> run_command(const Options& options) {
  std::vector<std::string> words{std::filesystem::read_symlink("/proc/self/exe"), "run", options.scenario, "--quiet"};
  for (const std::string& set : options.common.set) {
    words.emplace_back("--set");
    words.push_back(set);
  }
  return words;
}

int explain_scenario(const Options& options) {
  const std::unique_ptr<Scenario> scenario = load_scenario(scenario_file(options.scenario), options.common.overrides());
  if (!options.common.quiet) say_all(scenario->warnings);
  const Explanation explanation = explain(*scenario);
  std::optional<double> count;
  if (options.instructions) count = instructions_per_body_step(explanation, run_command(options));
  if (options.json) {
    std::cout << json_text(json_of(explanation, count), 2) << "\n";
  } else {
    print(explanation, count);
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
  app->add_flag("--instructions", options->instructions,
                "Count instructions per body and substep too (slow; needs valgrind)");
  return {app, [options] { return explain_scenario(*options); }};
}

}  // namespace proofreel
