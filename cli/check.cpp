#include <algorithm>
#include <charconv>
#include <cstdlib>
#include <filesystem>
#include <iostream>
#include <memory>
#include <optional>

#include "cli/check_output.h"
#include "cli/commands.h"
#include "cli/golden_store.h"
#include "cli/in_order.h"
#include "cli/run_output.h"
#include "cli/scenario_files.h"
#include "golden/check_report.h"
#include "golden/shell.h"
#include "render/usage_error.h"
#include "scenarios/source.h"
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
  ReportTargets targets;
  Shard shard;
  int jobs = 0;  ///< 0: as many as the machine has cores
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

/// K/N. Throws UsageError.
Shard shard_in(const std::string& text) {
  Shard shard;
  const char *const end = text.data() + text.size(), *const slash = text.data() + std::min(text.find('/'), text.size());
  const auto number = std::from_chars(text.data(), slash, shard.number);
  const auto count = std::from_chars(std::min(slash + 1, end), end, shard.count);
  const bool read = number.ec == std::errc{} && number.ptr == slash && count.ec == std::errc{} && count.ptr == end;
  if (read && shard.number >= 1 && shard.number <= shard.count && shard.count <= 1000) return shard;
  throw UsageError("--shard takes K/N, such as 2/4 for the second of four (at most 1000), not \"" + text + "\".");
}

std::vector<StoredScenario> in_shard(std::vector<StoredScenario> scenarios, Shard shard) {
  std::erase_if(scenarios, [shard](const StoredScenario& s) { return !is_in(shard, id_of(s.file)); });
  return scenarios;
}

/// The id where that means this file, else the file.
std::string word_for(const std::string& file) {
  std::error_code error;
  const std::string id = id_of(file);
  const std::filesystem::path collected = std::filesystem::path(scenarios_folder()) / (id + ".lua");
  return shell_word(std::filesystem::equivalent(collected, file, error) ? id : file);
}

std::string command(const char* name, const std::string& file, const Options& options) {
  std::string line = std::string("proofreel ").append(name).append(" ").append(word_for(file));
  if (!options.golden.empty()) line += " --golden " + shell_word(options.golden);
  return line;
}

/// What is told of one scenario, with the commands that lead on from here.
ReportEntry with_commands(ReportEntry entry, const std::string& file, const Options& options) {
  entry.file = file;
  entry.reproduce = command("check", file, options);
  if (options.hash_only) entry.reproduce += " --hash-only";
  for (const std::string& set : options.common.set) entry.reproduce += " --set " + shell_word(set);
  const auto can_be_blessed = [](const ReportItem& item) {
    return !item.passed && item.verdict != "nondeterministic" && item.verdict != "expectation" &&
           item.verdict != "error";
  };
  const bool blessable = std::any_of(entry.items.begin(), entry.items.end(), can_be_blessed);
  if (blessable && options.common.set.empty()) entry.bless = command("bless", file, options);
  return entry;
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

/// Small pictures are drawn on the threads of the jobs alone, unless the user has decided: llvmpipe's own threads would
/// only take turns with them. The pixels are the same for every number.
void draw_on_jobs_alone(int jobs) {
  if (jobs > 1) setenv("LP_NUM_THREADS", "0", 0);
}

/// Every job has pictures of its own, since a GL context belongs to one thread.
CheckResults check_all(const Options& options, const std::vector<StoredScenario>& scenarios, CheckRecord& record) {
  CheckResults results;
  InOrder<Checked> checks([&]() -> InOrder<Checked>::Worker {
    return [&scenarios, check_one = options.hash_only ? by_hashes(options) : by_pictures(options)](std::size_t i) {
      return checked(check_one, scenarios[i]);
    };
  });
  std::size_t next = 0;
  checks.run(scenarios.size(), jobs_or_cores(options.jobs), [&](Checked one) {
    const std::string& file = scenarios[next++].file;
    if (one.result) {
      results.checks.push_back(std::move(*one.result));
      CheckResult& last = results.checks.back();
      report(options, last);
      record.add(with_commands(entry_of(last), file, options), last);
    } else {
      say(one.error);
      results.errors.push_back(one.error);
      record.add(with_commands(entry_of_error(id_of(file), one.error), file, options));
    }
  });
  return results;
}

/// Each by one shard.
void add_orphans(const Options& options, const std::vector<StoredScenario>& all, CheckResults& results,
                 CheckRecord& record) {
  std::vector<std::string> ids;
  for (const StoredScenario& scenario : all) ids.push_back(id_of(scenario.file));
  for (const std::string& id : orphans_of(options.scenarios, options.golden, std::move(ids))) {
    if (!is_in(options.shard, id)) continue;
    results.orphans.push_back(id);
    record.add(entry_of_orphan(*collection_store(options.scenarios, options.golden), id));
  }
}

void tell(const Options& options, const CheckResults& results, const std::string& page) {
  if (options.json) {
    std::cout << json_text(json_of(results, page), 2) << "\n";
    return;
  }
  for (const std::string& id : results.orphans) std::cout << "orphan  " << id << ": no scenario asks for it\n";
  if (!page.empty() && !options.common.quiet) say("The report is " + page + ".");
}

int check(const Options& options) {
  const std::vector<StoredScenario> all = scenarios_meant(options.scenarios, options.golden);
  CheckRecord record(options.targets, options.shard);
  draw_on_jobs_alone(jobs_or_cores(options.jobs));
  CheckResults results = check_all(options, in_shard(all, options.shard), record);
  add_orphans(options, all, results, record);
  record.finish();
  tell(options, results, record.page());
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
  app->add_option("--report", options->targets.folder, "Write a page that shows what failed and how")->type_name("DIR");
  app->add_option("--junit", options->targets.junit, "Write JUnit XML for a CI server")->type_name("FILE");
  app->add_option_function<std::string>(
         "--shard", [options](const std::string& k) { options->shard = shard_in(k); },
         "Check the K-th of N parts of all this; see report-merge")
      ->type_name("K/N");
  app->add_option("--jobs", options->jobs, "Scenarios checked side by side; as many as there are cores unless told")
      ->type_name("N")
      ->check(CLI::Range(1, 256));
  return {app, [options] { return check(*options); }};
}

}  // namespace proofreel
