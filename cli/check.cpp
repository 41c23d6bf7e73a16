#include <algorithm>
#include <filesystem>
#include <iostream>
#include <memory>

#include "cli/commands.h"
#include "cli/golden_store.h"
#include "cli/run_output.h"
#include "cli/scenario_files.h"
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
    return check_scenario(file, overrides, store, {}, {});
  };
}

#ifdef PROOFREEL_PICTURES
CheckOne by_pictures(const Options& options) {
  const auto pictures = std::make_shared<Pictures>(gl_backend_named(options.common.gl));
  const auto draw = [pictures](const Scenario& s, const Frame& f) { return pictures->draw(s, f); };
  return [pictures, draw, overrides = options.common.overrides()](const std::string& file, const GoldenStore& store) {
    const auto judge_picture = [&](const Golden& golden, const GoldenFrame& then, const ObservedFrame& now) {
      return pictures->judge(store, golden, then, now);
    };
    return check_scenario(file, overrides, store, draw, judge_picture);
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

/// References without a scenario are looked for when the whole collection (a folder called scenarios) was checked.
std::vector<std::string> orphans_of(const Options& options, const std::vector<CheckResult>& checks) {
  const std::string folder = options.scenarios.empty() ? scenarios_folder() : options.scenarios.front();
  const std::filesystem::path path = std::filesystem::weakly_canonical(folder);
  if (options.scenarios.size() > 1 || path.filename() != "scenarios") return {};
  std::vector<std::string> ids;
  for (const CheckResult& check : checks) ids.push_back(check.scenario);
  std::sort(ids.begin(), ids.end());
  return orphan_ids(store_for((path / "any").string(), options.golden), ids);
}

void report(const Options& options, const CheckResult& check) {
  if (!options.common.quiet) say_all(check.warnings);
  if (options.json || (options.common.quiet && check.passed())) return;
  std::cout << text_of(check) << std::flush;
  say_all(failures_of(check.scenario, check.expectations));
}

int check(const Options& options) {
  const CheckOne check_one = options.hash_only ? by_hashes(options) : by_pictures(options);
  Results results;
  for (const StoredScenario& scenario : scenarios_meant(options.scenarios, options.golden)) {
    try {
      results.checks.push_back(check_one(scenario.file, scenario.store));
      report(options, results.checks.back());
    } catch (const ScenarioError& error) {
      say(error.what());
      results.errors.push_back(error.what());
    }
  }
  if (results.errors.empty()) results.orphans = orphans_of(options, results.checks);
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
  refuse_not_built(*app, {"--report", "--junit", "--shard", "--jobs"});
  return {app, [options] { return check(*options); }};
}

}  // namespace proofreel
