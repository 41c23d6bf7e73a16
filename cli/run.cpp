#include <chrono>
#include <iostream>
#include <memory>
#include <optional>

#include "cli/commands.h"
#include "cli/interrupt.h"
#include "cli/progress.h"
#include "cli/run_output.h"
#include "cli/run_peer.h"
#include "cli/saved_files.h"
#include "cli/scenario_files.h"
#include "render/output_file.h"

namespace proofreel {
namespace {

struct Options {
  CommonOptions common;
  std::string scenario;
  std::string csv;
  bool json = false;
  std::vector<std::string> save;  ///< T:FILE each
  std::string resume;
  std::optional<std::string> peer;
};

std::unique_ptr<Runner> make_runner(const Options& options, Scenario& scenario, const std::vector<SaveTarget>& targets,
                                    std::unique_ptr<Simulation> peer) {
  if (peer) return std::make_unique<Runner>(scenario, std::move(peer));
  if (!options.resume.empty()) return std::make_unique<Runner>(scenario, read_saved(options.resume), options.resume);
  std::vector<std::int64_t> ticks;
  for (const SaveTarget& target : targets) ticks.push_back(target.tick);
  return std::make_unique<Runner>(scenario, ticks);
}

RunReport run_to_the_end(Runner& runner, std::int64_t ticks, bool quiet) {
  ProgressLine progress("ticks", quiet);
  while (!runner.finished()) {
    runner.step();
    stop_if_interrupted();
    progress.update(runner.tick(), ticks);
  }
  return runner.finish();
}

int run(const Options& options) {
  const std::unique_ptr<Scenario> scenario = load_scenario(scenario_file(options.scenario), options.common.overrides());
  if (!options.common.quiet) say_all(scenario->warnings);
  const std::size_t said = scenario->warnings.size();
  PeerRun peer;
  if (options.peer) peer = peer_run(*options.peer, *scenario);
  const std::vector<SaveTarget> targets = save_targets(options.save, *scenario);
  if (!targets.empty()) note_interrupts();
  const auto start = std::chrono::steady_clock::now();
  const std::unique_ptr<Runner> runner = make_runner(options, *scenario, targets, std::move(peer.simulation));
  const RunReport report = run_to_the_end(*runner, scenario->ticks(), options.common.quiet);
  const double wall_s = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  write_saved(targets, *runner);
  if (!options.csv.empty()) write_file(options.csv, csv_of(*scenario, runner->samples()));
  if (options.json)
    std::cout << json_text(json_of(report, peer.stepper, scenario->warnings, wall_s), 2) << "\n";
  else
    std::cout << text_of(report, peer.stepper);
  const std::vector<std::string> on_the_way(scenario->warnings.begin() + static_cast<std::ptrdiff_t>(said),
                                            scenario->warnings.end());
  if (!options.common.quiet) say_all(on_the_way);
  if (!options.common.quiet) say_all(unknowns_of(report));
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
  app->add_option("--save", options->save, "Write what it takes to go on from T (seconds) to this file; repeatable")
      ->type_name("T:FILE")
      ->allow_extra_args(false);
  app->add_option("--resume", options->resume, "Go on from what --save has written")
      ->type_name("FILE")
      ->excludes("--save");
  app->add_option("--peer", options->peer, "Step by box2d or chipmunk, one step a tick; they are made for rate=60")
      ->type_name("ENGINE")
      ->excludes("--save", "--resume");
  return {app, [options] { return run(*options); }};
}

}  // namespace proofreel
