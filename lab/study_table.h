#pragma once

/// A study's runs as a CSV file, which is also its memory: what has a line there is not done again.

#include <string>
#include <unordered_map>
#include <vector>

#include "lab/csv_file.h"
#include "lab/study.h"

namespace proofreel {

/// The names of the columns: scenario, engine, the study's keys, and then measure, error, energy_error, cpu_s (of all
/// steps), row_updates, status, why, simulated_s, cpu_ms_per_s, evaluations, instructions, collision_share, step_s,
/// run (what tells runs apart). A run has one line for every measure. Empty is what does not apply or is not known.
CsvRecord header_of(const Study& study);
std::vector<CsvRecord> records_of(const Study& study, const StudyRun& run, const StudyResult& result);

class StudyTable {
 public:
  /// Reads what is there; a last line that was cut off is forgotten. Throws UsageError when the file holds something
  /// else, EnvironmentError when it cannot be written.
  StudyTable(const std::string& path, const Study& study);

  /// What is known of a run. What was too slow within less than `limit_s` is not.
  const StudyResult* find(const StudyRun& run, double limit_s) const;
  /// Adds the lines of a run to the file, at once and as a whole: they hold from now on. Throws EnvironmentError.
  void add(const StudyRun& run, const StudyResult& result);
  /// The file becomes the lines of these results, in the order of the study's runs. Throws EnvironmentError.
  void rewrite(const std::vector<StudyResult>& results) const;

 private:
  CsvFile file_;
  const Study& study_;
  std::unordered_map<std::string, StudyResult> known_;
};

}  // namespace proofreel
