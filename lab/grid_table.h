#pragma once

/// A grid's runs as a CSV file, which is also its memory: a run that has a line there is not done again.

#include <string>
#include <unordered_map>

#include "lab/csv_file.h"
#include "lab/grid.h"

namespace proofreel {

/// The names of the columns: scenario, engine, the grid's keys, and then state, cpu_ms_per_s (CPU milliseconds per
/// simulated second), simulated_s, cpu_s, failed_at_s, why, energy_drift_j, booked_work_j, overlap_share, joint_gap_m,
/// trajectory_hash, same_twice (yes, no), still, run (what tells runs apart). Empty is what does not apply.
CsvRecord header_of(const Grid& grid);
CsvRecord record_of(const RunRequest& request, const RunResult& result);
/// The result in a line under a header of `keys` keys, and the run it belongs to; nothing when it is none.
struct StoredResult {
  std::string key;
  RunResult result;
};
std::optional<StoredResult> result_in(const CsvRecord& record, std::size_t keys);

class GridTable {
 public:
  /// Reads what is there; a last line that was cut off is forgotten. Throws UsageError when the file holds something
  /// else, EnvironmentError when it cannot be written.
  GridTable(const std::string& path, const Grid& grid);

  /// What is known of a run. What was too slow within less than `limit_s` is not.
  const RunResult* find(const RunRequest& request, double limit_s) const;
  /// Adds a line to the file, at once and as a whole. Throws EnvironmentError.
  void add(const RunRequest& request, const RunResult& result);
  /// The file becomes the lines of these runs, in this order. Throws EnvironmentError.
  void rewrite(const Grid& grid, const std::vector<RunResult>& results) const;

 private:
  CsvFile file_;
  std::unordered_map<std::string, RunResult> known_;
};

}  // namespace proofreel
