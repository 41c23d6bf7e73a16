#include "golden/bless.h"

#include <cstdlib>
#include <filesystem>
#include <iostream>
#include <memory>

#include "cli/commands.h"
#include "cli/golden_store.h"
#include "cli/interrupt.h"
#include "cli/run_output.h"
#include "render/usage_error.h"

namespace proofreel {
namespace {

struct Options {
  CommonOptions common;
  std::vector<std::string> scenarios;
  std::string golden;
  bool prune = false;
};

void refuse_in_ci() {
  const char* ci = std::getenv("CI");
  if (ci == nullptr || std::string(ci) != "true") return;
  throw UsageError("bless does not run with CI=true: references are accepted by somebody who has looked at them.");
}

/// A reference must follow from what lies in the repository.
void refuse_overrides(const std::vector<Override>& overrides) {
  if (overrides.empty()) return;
  throw UsageError("bless takes no --set: a reference must follow from the scenario's file alone. Change the file.");
}

void report(const BlessResult& result, bool quiet) {
  if (!quiet) say_all(result.warnings);
  for (const std::string& change : result.changes) std::cout << result.scenario << ": " << change << "\n";
  if (result.changes.empty() && !quiet) std::cout << result.scenario << ": unchanged\n";
  std::cout << std::flush;
  const std::vector<std::string> failures = failures_of(result.scenario, result.expectations);
  say_all(failures);
  if (!failures.empty()) say(result.scenario + ": the references are written, but check will fail until this holds");
}

bool all_hold(const BlessResult& result) { return failures_of(result.scenario, result.expectations).empty(); }

int bless(const Options& options) {
  refuse_in_ci();
  refuse_overrides(options.common.overrides());
  note_interrupts();
  Pictures pictures(gl_backend_named(options.common.gl));
  bool all_held = true;
  for (const StoredScenario& scenario : scenarios_meant(options.scenarios, options.golden)) {
    stop_if_interrupted();
    const BlessResult result = bless_scenario(scenario.file, {}, scenario.store, pictures, options.prune);
    report(result, options.common.quiet);
    all_held = all_held && all_hold(result);
  }
  return all_held ? 0 : 1;
}

}  // namespace

Subcommand bless_command(CLI::App& program) {
  const auto options = std::make_shared<Options>();
  CLI::App* app = add_command(program, "bless", "Accept what is rendered now as golden", "proofreel bless pyramid",
                              options->common);
  app->add_option("SCENARIO", options->scenarios, "Files, ids or folders; the whole collection when none is given");
  app->add_option("--golden", options->golden, "The store, instead of the nearest folder `golden`")->type_name("DIR");
  app->add_flag("--prune", options->prune, "Remove references nothing asks for any more");
  return {app, [options] { return bless(*options); }};
}

}  // namespace proofreel
