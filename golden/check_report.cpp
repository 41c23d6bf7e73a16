#include "golden/check_report.h"

namespace proofreel {
namespace {

std::string label_of(const Finding& finding) {
  if (finding.frame) return "frame " + std::to_string(*finding.frame);
  return finding.verdict == Verdict::orphan ? "stray file" : "final state";
}

ReportItem item_of(const Finding& finding) {
  ReportItem item{label_of(finding), name_of(finding.verdict), passes(finding.verdict), finding.message};
  item.different = finding.comparison.different;
  item.total = finding.comparison.total;
  item.max_channel = finding.comparison.max_channel;
  return item;
}

ReportItem item_of(const ExpectationResult& expectation) {
  ReportItem item{"expectation", expectation.held ? "held" : "expectation", expectation.held, expectation.text};
  if (!expectation.held) {
    item.message = "\"" + expectation.text + "\" does not hold at tick " + std::to_string(expectation.tick) + ".";
  }
  return item;
}

}  // namespace

ReportEntry entry_of(const CheckResult& check) {
  ReportEntry entry{check.scenario, {}, {}, {}, {}};
  for (const Finding& finding : check.findings) entry.items.push_back(item_of(finding));
  for (const ExpectationResult& expectation : check.expectations) entry.items.push_back(item_of(expectation));
  return entry;
}

ReportEntry entry_of_error(const std::string& name, const std::string& message) {
  ReportEntry entry{name, {}, {}, {}, {}};
  entry.items.push_back({"scenario", "error", false, message});
  return entry;
}

ReportEntry entry_of_orphan(const GoldenStore& store, const std::string& id) {
  ReportEntry entry{id, store.json_path(id).string(), {}, {}, {}};
  entry.items.push_back(
      {"reference", "orphan", false,
       "No scenario asks for this reference; bless --prune removes " + store.folder(id).string() + "."});
  entry.bless = "proofreel bless --prune";
  return entry;
}

}  // namespace proofreel
