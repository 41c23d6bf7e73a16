#include <filesystem>
#include <iostream>
#include <memory>

#include "cli/check_output.h"
#include "cli/commands.h"
#include "render/usage_error.h"

namespace proofreel {
namespace {

namespace fs = std::filesystem;

struct Options {
  CommonOptions common;
  std::vector<std::string> parts;
  ReportTargets targets;
  bool json = false;
};

void refuse_own_part(const Options& options) {
  for (const std::string& part : options.parts) {
    if (fs::weakly_canonical(part) != fs::weakly_canonical(options.targets.folder)) continue;
    throw UsageError("The joint report cannot replace " + part + ", which it is made of: name another folder with -o.");
  }
}

Json json_of(const Report& report, const std::string& page) {
  const auto total = static_cast<std::int64_t>(report.entries.size());
  Json failed = Json::array();
  for (const ReportEntry& entry : report.entries) {
    if (!entry.passed()) failed.push_back(entry.name);
  }
  return {{"passed", report.status() == 0},
          {"counts", {{"passed", total - report.failed()}, {"failed", report.failed()}, {"total", total}}},
          {"failed", failed},
          {"report", page}};
}

void tell(const Options& options, const Report& report, const std::string& page) {
  if (options.json) {
    std::cout << json_text(json_of(report, page), 2) << "\n";
    return;
  }
  for (const ReportEntry& entry : report.entries) {
    for (const ReportItem* item : failures_in(entry)) {
      std::cout << "FAILED  " << entry.name << " " << item->label << ": " << item->verdict << ": " << item->message
                << "\n";
    }
  }
  std::cout << report.failed() << " of " << report.entries.size() << " failed: " << page << "\n";
}

int merge(const Options& options) {
  if (options.targets.folder.empty()) throw UsageError("Name a folder for the joint report with -o DIR.");
  refuse_own_part(options);
  std::vector<Report> parts;
  for (const std::string& part : options.parts) parts.push_back(read_report(part));
  const Report whole = merged(parts);
  const ReportFolder folder(options.targets.folder);
  for (std::size_t i = 0; i < parts.size(); ++i) folder.add_pictures_of(parts[i], options.parts[i]);
  folder.finish(whole);
  write_outputs(whole, options.targets.junit);
  tell(options, whole, folder.page().string());
  return whole.status();
}

}  // namespace

Subcommand report_merge_command(CLI::App& program) {
  const auto options = std::make_shared<Options>();
  CLI::App* app = add_command(program, "report-merge", "Join the reports of shards (check --shard) into one",
                              "proofreel report-merge shard-1 shard-2 -o report", options->common);
  app->add_option("DIR", options->parts, "Folders written by check --report")->required();
  app->add_option("-o,--output", options->targets.folder, "Folder for the joint report")->type_name("DIR");
  app->add_option("--junit", options->targets.junit, "Write JUnit XML, too")->type_name("FILE");
  app->add_flag("--json", options->json, "Print one JSON object instead of text");
  return {app, [options] { return merge(*options); }};
}

}  // namespace proofreel
