#include "lab/grid_table.h"

#include <filesystem>

namespace proofreel {
namespace {

/// Of a result's columns; the scenario, the engine and the keys come before them.
const CsvRecord& result_columns() {
  static const CsvRecord columns{
      "state",         "cpu_ms_per_s",  "simulated_s", "cpu_s",           "failed_at_s", "why",   "energy_drift_j",
      "booked_work_j", "overlap_share", "joint_gap_m", "trajectory_hash", "same_twice",  "still", "run"};
  return columns;
}

std::string yes_or_no(std::optional<bool> value) {
  if (!value) return {};
  return *value ? "yes" : "no";
}

}  // namespace

CsvRecord header_of(const Grid& grid) {
  CsvRecord header{"scenario", "engine"};
  header.insert(header.end(), grid.keys.begin(), grid.keys.end());
  header.insert(header.end(), result_columns().begin(), result_columns().end());
  return header;
}

CsvRecord record_of(const RunRequest& request, const RunResult& r) {
  CsvRecord record{request.scenario, engine_of(request)};
  record.insert(record.end(), request.values.begin(), request.values.end());
  for (std::string& field :
       CsvRecord{name_of(r.standing), text_of(r.cost_ms()), exact(r.simulated_s), exact(r.cpu_s), text_of(r.at_s),
                 r.why, text_of(r.energy_drift_j), text_of(r.booked_work_j), text_of(r.overlap_share),
                 text_of(r.joint_gap_m), r.trajectory_hash, yes_or_no(r.same_twice), r.still, request.key}) {
    record.push_back(std::move(field));
  }
  return record;
}

std::optional<StoredResult> result_in(const CsvRecord& record, std::size_t keys) {
  const std::size_t first = 2 + keys;
  if (record.size() != first + result_columns().size()) return std::nullopt;
  const auto field = [&](std::size_t i) -> const std::string& { return record[first + i]; };
  const std::optional<Standing> standing = standing_named(field(0));
  const std::optional<double> simulated = number_in(field(2));
  const std::optional<double> cpu = number_in(field(3));
  if (!standing || !simulated || !cpu) return std::nullopt;
  RunResult r;
  r.standing = *standing;
  r.simulated_s = *simulated;
  r.cpu_s = *cpu;
  r.at_s = number_in(field(4));
  r.why = field(5);
  r.energy_drift_j = number_in(field(6));
  r.booked_work_j = number_in(field(7));
  r.overlap_share = number_in(field(8));
  r.joint_gap_m = number_in(field(9));
  r.trajectory_hash = field(10);
  if (!field(11).empty()) r.same_twice = field(11) == "yes";
  r.still = field(12);
  return StoredResult{field(13), r};
}

GridTable::GridTable(const std::string& path, const Grid& grid) : file_(path, header_of(grid)) {
  std::vector<CsvRecord> whole;
  for (const CsvRecord& record : file_.found()) {
    std::optional<StoredResult> stored = result_in(record, grid.keys.size());
    if (!stored) continue;
    whole.push_back(record);
    known_[stored->key] = std::move(stored->result);
  }
  file_.rewrite(whole);
}

const RunResult* GridTable::find(const RunRequest& request, double limit_s) const {
  const auto found = known_.find(request.key);
  if (found == known_.end()) return nullptr;
  const RunResult& result = found->second;
  if (result.standing == Standing::too_slow && result.cpu_s < limit_s) return nullptr;
  const auto still = std::filesystem::path(file_.path()).parent_path() / result.still;
  return result.still.empty() || std::filesystem::exists(still) ? &result : nullptr;
}

void GridTable::add(const RunRequest& request, const RunResult& result) {
  file_.append({record_of(request, result)});
  known_[request.key] = result;
}

void GridTable::rewrite(const Grid& grid, const std::vector<RunResult>& results) const {
  std::vector<CsvRecord> records;
  for (std::size_t i = 0; i < results.size(); ++i) records.push_back(record_of(grid.runs[i], results[i]));
  file_.rewrite(records);
}

}  // namespace proofreel
