#include "golden/junit.h"

#include "golden/html.h"
#include "golden/json.h"

namespace proofreel {
namespace {

/// Text as XML takes it: well-formed UTF-8 without control characters, which no way of writing makes legal there.
std::string xml_text(const std::string& text) {
  const std::string utf8 = Json::parse(json_text(Json(text))).get<std::string>();
  std::string plain;
  for (const char c : utf8) plain += static_cast<unsigned char>(c) < 0x20 && c != '\n' && c != '\t' ? ' ' : c;
  return html_escaped(plain);
}

std::string quoted(const char* name, const std::string& value) {
  return std::string(" ").append(name).append("=\"").append(xml_text(value)).append("\"");
}

std::string case_of(const ReportEntry& entry, const ReportItem& item) {
  std::string text = "    <testcase" + quoted("classname", "golden." + entry.name) + quoted("name", item.label);
  if (item.passed) return text.append("/>\n");
  const char* kind = item.verdict == "error" ? "error" : "failure";
  text.append(">\n      <").append(kind).append(quoted("type", item.verdict)).append(quoted("message", item.message));
  text.append(">").append(xml_text(item.message)).append("\nTo reproduce: ").append(xml_text(entry.reproduce));
  return text.append("</").append(kind).append(">\n    </testcase>\n");
}

/// Some servers drop suites without cases: what only had to run is a case, too.
std::vector<ReportItem> cases_of(const ReportEntry& entry) {
  if (!entry.items.empty()) return entry.items;
  ReportItem run;
  run.label = "runs";
  return {run};
}

struct Counts {
  std::size_t tests = 0, failures = 0, errors = 0;
  std::string text() const {
    return quoted("tests", std::to_string(tests)) + quoted("failures", std::to_string(failures)) +
           quoted("errors", std::to_string(errors));
  }
};

Counts counts_of(const std::vector<ReportItem>& items) {
  Counts counts{items.size(), 0, 0};
  for (const ReportItem& item : items) {
    if (!item.passed) ++(item.verdict == "error" ? counts.errors : counts.failures);
  }
  return counts;
}

}  // namespace

std::string junit_of(const Report& report) {
  Counts all;
  std::string suites;
  for (const ReportEntry& entry : report.entries) {
    const std::vector<ReportItem> items = cases_of(entry);
    const Counts counts = counts_of(items);
    all.tests += counts.tests, all.failures += counts.failures, all.errors += counts.errors;
    suites += "  <testsuite" + quoted("name", entry.name) + counts.text() + ">\n";
    for (const ReportItem& item : items) suites += case_of(entry, item);
    suites += "  </testsuite>\n";
  }
  return "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuites" + quoted("name", report.program) + all.text() +
         ">\n" + suites + "</testsuites>\n";
}

}  // namespace proofreel
