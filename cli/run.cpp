#include <chrono>
#include <iostream>
#include <memory>

#include "cli/commands.h"
#include "cli/progress.h"
#include "cli/run_output.h"
#include "cli/scenario_files.h"
#include "render/output_file.h"

namespace proofreel {
namespace {

struct Options {
  CommonOptions common;
  std::string scenario;
  std::string csv;
  bool json = false;
};

RunReport run_to_the_end(Runner& runner, std::int64_t ticks, bool quiet) {
  ProgressLine progress("ticks", quiet);
  while (!runner.finished()) {
    runner.step();
    progress.update(runner.tick(), ticks);
  }
  return runner.finish();
}

int run(const Options& options) {
  const std::unique_ptr<Scenario> scenario = load_scenario(scenario_file(options.scenario), options.common.overrides());
  if (!options.common.quiet) say_all(scenario->warnings);
  const std::size_t said = scenario->warnings.size();
  const auto start = std::chrono::steady_clock::now();
  Runner runner(*scenario);
  const RunReport report = run_to_the_end(runner, scenario->ticks(), options.common.quiet);
  const double wall_s = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  if (!options.csv.empty()) write_file(options.csv, csv_of(*scenario, runner.samples()));
  if (options.json)
    std::cout << json_text(json_of(report, scenario->warnings, wall_s), 2) << "\n";
  else
    std::cout << text_of(report);
  const std::vector<std::string> on_the_way(scenario->warnings.begin() + static_cast<std::ptrdiff_t>(said),
                                            scenario->warnings.end());
  if (!options.common.quiet) say_all(on_the_way);
  say_all(failures_of(report.scenario, report.expectations));
  return report.all_held() ? 0 : 1;
}

}  // namespace

Subcommand run_command(CLI::App& program) {
  const auto options = std::make_shared<Options>();
  CLI::App* app = add_command(program, "run", "Step a scenario without drawing; measures, expectations, hashes",
                              "proofreel run pendulum --json --csv pendulum.csv", options->common);
  app->add_option("SCENARIO", options->scenario, "Path of a .lua file, or an id such as pyramid")->required();
  app->add_option("--csv", options->csv, "Write time and measures of every sample to this file")->type_name("FILE");
  app->add_flag("--json", options->json, "Print one JSON object instead of text");
  refuse_not_built(*app, {"--peer", "--save", "--resume"});
  return {app, [options] { return run(*options); }};
}

}  // namespace proofreel
