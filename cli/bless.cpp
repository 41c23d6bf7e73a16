#include "golden/bless.h"

#include <cstdlib>
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

/// What is about to be done.
void announce(const BlessPlan& plan, bool quiet) {
  if (!quiet) say_all(plan.warnings);
  for (const std::string& change : plan.changes) std::cout << plan.scenario << ": " << change << "\n";
  if (plan.changes.empty() && !quiet) std::cout << plan.scenario << ": unchanged\n";
  std::cout << std::flush;
}

/// Whether all expectations hold; says which do not.
bool expectations_hold(const BlessPlan& plan) {
  const std::vector<std::string> failures = failures_of(plan.scenario, plan.expectations);
  say_all(failures);
  if (!failures.empty()) say(plan.scenario + ": the references are written, but check will fail until this holds");
  return failures.empty();
}

/// References of scenarios that are gone: removed when asked for, else told about.
void tidy_collection(const Options& options, const std::vector<std::string>& ids) {
  for (const std::string& orphan : orphans_of(options.scenarios, options.golden, ids)) {
    if (!options.prune) {
      std::cout << orphan << ": no scenario asks for it any more; --prune removes it.\n";
      continue;
    }
    const BlessPlan plan = plan_removal(*collection_store(options.scenarios, options.golden), orphan);
    announce(plan, options.common.quiet);
    plan.carry_out();
  }
}

int bless(const Options& options) {
  refuse_in_ci();
  refuse_overrides(options.common.overrides());
  note_interrupts();
  Pictures pictures(gl_backend_named(options.common.gl));
  bool all_held = true;
  std::vector<std::string> ids;
  for (const StoredScenario& scenario : scenarios_meant(options.scenarios, options.golden)) {
    stop_if_interrupted();
    const BlessPlan plan = plan_blessing(scenario.file, {}, scenario.store, pictures, options.prune);
    announce(plan, options.common.quiet);
    plan.carry_out();
    all_held = expectations_hold(plan) && all_held;
    ids.push_back(plan.scenario);
  }
  tidy_collection(options, ids);
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
