#pragma once

/// How `check` tells what it found: as text, as JSON, and as a report with all that is made of one.

#include <optional>
#include <string>
#include <vector>

#include "golden/check.h"
#include "golden/json.h"
#include "golden/report_folder.h"

namespace proofreel {

/// All that was found out, and what could not be.
struct CheckResults {
  std::vector<CheckResult> checks;
  std::vector<std::string> errors;   ///< of scenarios that cannot be run
  std::vector<std::string> orphans;  ///< ids in the store that no scenario has
  /// 0 when all passed, 1 when something did not, 2 when something could not be run.
  int status() const;
};

/// A line, and one more for everything that is not exact.
std::string text_of(const CheckResult& check);

/// One object: passed, counts {passed, failed, total} (scenarios; what could not be run has failed), scenarios
/// [{scenario, passed, findings [{frame or null, verdict, message, different, total, max_channel}], expectations}],
/// orphans (ids), errors (sentences), report (the page, or null).
Json json_of(const CheckResults& results, const std::string& report_page);

/// What is written beside standard output.
struct ReportTargets {
  std::string folder;  ///< of the page; empty: none
  std::string junit;   ///< a file; empty: none
};

/// A report that grows while scenarios are checked.
class CheckRecord {
 public:
  /// Probes whether what is asked for can be written, so that a long check does not end in vain. Throws UsageError and
  /// EnvironmentError.
  CheckRecord(ReportTargets targets, Shard shard);

  /// The findings' pictures go into the report's folder, and out of the memory.
  void add(ReportEntry entry, CheckResult& check);
  void add(ReportEntry entry) { report_.entries.push_back(std::move(entry)); }
  /// Writes all there is to write, and the annotations of GitHub Actions where it is them who run this.
  void finish() const;

  const Report& report() const { return report_; }
  /// Where the page is; empty when none was asked for.
  std::string page() const { return folder_ ? folder_->page().string() : std::string(); }

 private:
  ReportTargets targets_;
  std::optional<ReportFolder> folder_;
  Report report_;
};

/// Writes what was asked for of a finished report: JUnit and annotations.
void write_outputs(const Report& report, const std::string& junit);

}  // namespace proofreel
