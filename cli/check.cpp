#include <algorithm>
#include <cstdlib>
#include <iostream>
#include <memory>
#include <optional>
#include <thread>

#include "cli/commands.h"
#include "cli/golden_store.h"
#include "cli/in_order.h"
#include "cli/run_output.h"
#include "golden/check.h"
#include "render/usage_error.h"
#ifdef PROOFREEL_PICTURES
#include "golden/pictures.h"
#endif

namespace proofreel {
namespace {

struct Options {
  CommonOptions common;
  std::vector<std::string> scenarios;
  std::string golden;
  bool hash_only = false;
  bool json = false;
  int jobs = 0;  ///< 0: as many as the machine has cores
};

/// All that was found out, and what could not be.
struct Results {
  std::vector<CheckResult> checks;
  std::vector<std::string> errors;   ///< of scenarios that cannot be run
  std::vector<std::string> orphans;  ///< ids in the store that no scenario has

  int status() const {
    if (!errors.empty()) return 2;
    const bool all = std::all_of(checks.begin(), checks.end(), [](const CheckResult& c) { return c.passed(); });
    return all && orphans.empty() ? 0 : 1;
  }
};

/// Runs one scenario and judges it, with or without pictures.
using CheckOne = std::function<CheckResult(const std::string& file, const GoldenStore& store)>;

CheckOne by_hashes(const Options& options) {
  return [overrides = options.common.overrides()](const std::string& file, const GoldenStore& store) {
    return check_scenario(file, overrides, store, {});
  };
}

#ifdef PROOFREEL_PICTURES
CheckOne by_pictures(const Options& options) {
  const auto pictures = std::make_shared<Pictures>(gl_backend_named(options.common.gl));
  return [pictures, overrides = options.common.overrides()](const std::string& file, const GoldenStore& store) {
    return check_scenario(file, overrides, store, pictures->tools(store));
  };
}
#else
CheckOne by_pictures(const Options&) {
  throw UsageError("This build has no pictures (PROOFREEL_PICTURES=OFF): it can only check --hash-only.");
}
#endif

std::string place_of(const Finding& finding) {
  return finding.frame ? std::string("frame ").append(std::to_string(*finding.frame)) : std::string("scenario");
}

std::string text_of(const CheckResult& check) {
  std::string text(check.passed() ? "passed  " : "FAILED  ");
  text.append(check.scenario).append("\n");
  for (const Finding& finding : check.findings) {
    if (finding.verdict == Verdict::exact) continue;
    text.append("  ").append(place_of(finding)).append(": ").append(name_of(finding.verdict)).append(": ");
    text.append(finding.message).append("\n");
  }
  return text;
}

Json json_of(const Finding& finding) {
  Json json{{"frame", nullptr},
            {"verdict", name_of(finding.verdict)},
            {"message", finding.message},
            {"different", finding.comparison.different},
            {"total", finding.comparison.total},
            {"max_channel", finding.comparison.max_channel}};
  if (finding.frame) json["frame"] = *finding.frame;
  return json;
}

Json json_of(const CheckResult& check) {
  Json findings = Json::array();
  for (const Finding& finding : check.findings) findings.push_back(json_of(finding));
  return {{"scenario", check.scenario},
          {"passed", check.passed()},
          {"findings", findings},
          {"expectations", json_of(check.expectations)}};
}

Json json_of(const Results& results) {
  Json checks = Json::array();
  for (const CheckResult& check : results.checks) checks.push_back(json_of(check));
  return {{"passed", results.status() == 0},
          {"scenarios", checks},
          {"orphans", results.orphans},
          {"errors", results.errors}};
}

void report(const Options& options, const CheckResult& check) {
  if (!options.common.quiet) say_all(check.warnings);
  if (options.json || (options.common.quiet && check.passed())) return;
  std::cout << text_of(check) << std::flush;
  say_all(failures_of(check.scenario, check.expectations));
}

/// What became of one scenario: judged, or why it cannot be run.
struct Checked {
  std::optional<CheckResult> result;
  std::string error;
};

Checked checked(const CheckOne& check_one, const StoredScenario& scenario) {
  try {
    return {check_one(scenario.file, scenario.store), {}};
  } catch (const ScenarioError& error) {
    return {std::nullopt, error.what()};
  }
}

int jobs_of(const Options& options) {
  return options.jobs > 0 ? options.jobs : std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
}

/// Small pictures are drawn on the threads of the jobs alone, unless the user has decided: llvmpipe's own threads would
/// only take turns with them. The pixels are the same for every number.
void draw_on_jobs_alone(int jobs) {
  if (jobs > 1) setenv("LP_NUM_THREADS", "0", 0);
}

/// Every job has pictures of its own, since a GL context belongs to one thread.
Results check_all(const Options& options, const std::vector<StoredScenario>& scenarios) {
  Results results;
  InOrder<Checked> checks([&]() -> InOrder<Checked>::Worker {
    return [&scenarios, check_one = options.hash_only ? by_hashes(options) : by_pictures(options)](std::size_t i) {
      return checked(check_one, scenarios[i]);
    };
  });
  checks.run(scenarios.size(), jobs_of(options), [&](Checked one) {
    if (one.result) {
      results.checks.push_back(std::move(*one.result));
      report(options, results.checks.back());
    } else {
      say(one.error);
      results.errors.push_back(one.error);
    }
  });
  return results;
}

std::vector<std::string> ids_of(const std::vector<CheckResult>& checks) {
  std::vector<std::string> ids;
  for (const CheckResult& check : checks) ids.push_back(check.scenario);
  return ids;
}

int check(const Options& options) {
  draw_on_jobs_alone(jobs_of(options));
  Results results = check_all(options, scenarios_meant(options.scenarios, options.golden));
  if (results.errors.empty()) results.orphans = orphans_of(options.scenarios, options.golden, ids_of(results.checks));
  if (options.json)
    std::cout << json_text(json_of(results), 2) << "\n";
  else
    for (const std::string& id : results.orphans) std::cout << "orphan  " << id << ": no scenario asks for it\n";
  return results.status();
}

}  // namespace

Subcommand check_command(CLI::App& program) {
  const auto options = std::make_shared<Options>();
  CLI::App* app = add_command(program, "check", "Hold scenarios against their golden states and pictures",
                              "proofreel check pyramid --json", options->common);
  app->add_option("SCENARIO", options->scenarios, "Files, ids or folders; the whole collection when none is given");
  app->add_option("--golden", options->golden, "The store, instead of the nearest folder `golden`")->type_name("DIR");
  app->add_flag("--hash-only", options->hash_only, "Compare states only, draw nothing");
  app->add_flag("--json", options->json, "Print one JSON object instead of text");
  app->add_option("--jobs", options->jobs, "Scenarios checked side by side; as many as there are cores unless told")
      ->type_name("N")
      ->check(CLI::Range(1, 256));
  refuse_not_built(*app, {"--report", "--junit", "--shard"});
  return {app, [options] { return check(*options); }};
}

}  // namespace proofreel
