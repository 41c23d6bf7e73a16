#include "cli/check_output.h"

#include <algorithm>
#include <cstdlib>

#include "cli/options.h"
#include "cli/run_output.h"
#include "golden/annotations.h"
#include "golden/junit.h"
#include "render/output_file.h"

namespace proofreel {
namespace {

std::string place_of(const Finding& finding) {
  return finding.frame ? std::string("frame ").append(std::to_string(*finding.frame)) : std::string("scenario");
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

Json counts_of(const CheckResults& results) {
  const auto passed =
      std::count_if(results.checks.begin(), results.checks.end(), [](const CheckResult& c) { return c.passed(); });
  const std::size_t total = results.checks.size() + results.errors.size();
  return {{"passed", passed}, {"failed", total - static_cast<std::size_t>(passed)}, {"total", total}};
}

std::string variable(const char* name) {
  const char* value = std::getenv(name);
  return value == nullptr ? std::string() : std::string(value);
}

}  // namespace

int CheckResults::status() const {
  if (!errors.empty()) return 2;
  const bool all = std::all_of(checks.begin(), checks.end(), [](const CheckResult& c) { return c.passed(); });
  return all && orphans.empty() ? 0 : 1;
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

Json json_of(const CheckResults& results, const std::string& report_page) {
  Json checks = Json::array();
  for (const CheckResult& check : results.checks) checks.push_back(json_of(check));
  Json json{{"passed", results.status() == 0}, {"counts", counts_of(results)}, {"scenarios", checks},
            {"orphans", results.orphans},      {"errors", results.errors},     {"report", nullptr}};
  if (!report_page.empty()) json["report"] = report_page;
  return json;
}

CheckRecord::CheckRecord(ReportTargets targets, Shard shard) : targets_(std::move(targets)) {
  report_.program = std::string("proofreel ").append(PROOFREEL_VERSION);
  report_.shard = shard;
  if (!targets_.junit.empty()) OutputFile probe(targets_.junit);
  if (!targets_.folder.empty()) folder_.emplace(targets_.folder);
}

void CheckRecord::add(ReportEntry entry, CheckResult& check) {
  for (std::size_t i = 0; i < check.findings.size(); ++i) {
    Finding& finding = check.findings[i];
    const bool shown = folder_ && !check.passed();
    if (shown) folder_->add_pictures(entry.items[i], entry.name, finding.expected, finding.actual);
    finding.actual = {};
  }
  add(std::move(entry));
}

void CheckRecord::finish() const {
  if (folder_) folder_->finish(report_);
  write_outputs(report_, targets_.junit);
}

void write_outputs(const Report& report, const std::string& junit) {
  if (!junit.empty()) write_file(junit, junit_of(report));
  if (variable("GITHUB_ACTIONS") != "true") return;
  const std::string root = variable("GITHUB_WORKSPACE");
  say_all(annotations_of(report, root.empty() ? "." : root));
}

}  // namespace proofreel
