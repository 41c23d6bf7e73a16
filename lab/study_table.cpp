#include "lab/study_table.h"

#include "render/usage_error.h"

namespace proofreel {
namespace {

const CsvRecord& result_columns() {
  static const CsvRecord columns{
      "measure",     "error",        "energy_error", "cpu_s",        "row_updates",     "status", "why",
      "simulated_s", "cpu_ms_per_s", "evaluations",  "instructions", "collision_share", "step_s", "run"};
  return columns;
}

std::string text_of(std::optional<std::int64_t> number) { return number ? std::to_string(*number) : std::string(); }

std::optional<double> per_simulated_s(const StudyResult& result) {
  if (!result.cpu_s || result.simulated_s <= 0) return std::nullopt;
  return 1e3 * *result.cpu_s / result.simulated_s;
}

std::optional<std::int64_t> count_in(const std::string& text) {
  const std::optional<double> number = number_in(text);
  const bool counts = number && *number >= 0 && *number < 9e15;  // whatever else became of the file
  return counts ? std::optional(static_cast<std::int64_t>(*number)) : std::nullopt;
}

std::string engine_of(const StudiedMethod& method) {
  if (!method.peer) return "proofreel";
  return name_of(*method.peer) + std::string(method.preset == PeerPreset::accurate ? " accurate" : "");
}

/// A line's measure, its error, and all else.
struct StoredLine {
  std::string key;
  std::string measure;
  std::optional<double> error;
  StudyResult rest;
};

std::optional<StoredLine> line_in(const CsvRecord& record, std::size_t keys) {
  const std::size_t first = 2 + keys;
  if (record.size() != first + result_columns().size()) return std::nullopt;
  const auto field = [&](std::size_t i) -> const std::string& { return record[first + i]; };
  const std::optional<RunStatus> status = run_status_named(field(5));
  if (!status) return std::nullopt;
  StoredLine line{field(13), field(0), number_in(field(1)), {}};
  line.rest.status = *status;
  line.rest.energy_error = number_in(field(2));
  line.rest.cpu_s = number_in(field(3));
  line.rest.row_updates = count_in(field(4));
  line.rest.why = field(6);
  line.rest.simulated_s = number_in(field(7)).value_or(0);
  line.rest.evaluations = count_in(field(9));
  line.rest.instructions = count_in(field(10));
  line.rest.collision_share = number_in(field(11));
  return line;
}

/// One line more of what is known of a run.
void learn(StudyResult& known, const StoredLine& line, const Study& study) {
  std::vector<std::optional<double>> errors = std::move(known.errors);
  errors.resize(study.measures.size());
  known = line.rest;
  for (std::size_t i = 0; i < study.measures.size(); ++i) {
    if (study.measures[i].name == line.measure) errors[i] = line.error;
  }
  known.errors = std::move(errors);
}

}  // namespace

CsvRecord header_of(const Study& study) {
  CsvRecord header{"scenario", "engine"};
  header.insert(header.end(), study.keys.begin(), study.keys.end());
  header.insert(header.end(), result_columns().begin(), result_columns().end());
  return header;
}

std::vector<CsvRecord> records_of(const Study& study, const StudyRun& run, const StudyResult& r) {
  std::vector<CsvRecord> records;
  for (std::size_t i = 0; i < study.measures.size(); ++i) {
    CsvRecord record{study.scenario, engine_of(study.methods[run.method])};
    record.insert(record.end(), run.values.begin(), run.values.end());
    const std::optional<double> error = i < r.errors.size() ? r.errors[i] : std::nullopt;
    for (std::string& field : CsvRecord{
             study.measures[i].name, text_of(error), text_of(r.energy_error), text_of(r.cpu_s), text_of(r.row_updates),
             name_of(r.status), r.why, exact(r.simulated_s), text_of(per_simulated_s(r)), text_of(r.evaluations),
             text_of(r.instructions), text_of(r.collision_share), exact(run.step_s), run.key}) {
      record.push_back(std::move(field));
    }
    records.push_back(std::move(record));
  }
  return records;
}

StudyTable::StudyTable(const std::string& path, const Study& study) : file_(path, header_of(study)), study_(study) {
  std::vector<CsvRecord> whole;
  std::unordered_map<std::string, std::size_t> lines_of;
  for (const CsvRecord& record : file_.found()) {
    std::optional<StoredLine> line = line_in(record, study.keys.size());
    if (!line) continue;
    if (record[0] != study.scenario)
      throw UsageError(path + " holds a study of " + record[0] + ": name another folder with -o, or remove it.");
    whole.push_back(record);
    ++lines_of[line->key];
    learn(known_[line->key], *line, study);
  }
  // A run is known by all of its lines: one per measure, every time it was written down.
  for (const auto& [key, lines] : lines_of) {
    if (lines % study.measures.size() != 0) known_.erase(key);
  }
  file_.rewrite(whole);
}

const StudyResult* StudyTable::find(const StudyRun& run, double limit_s) const {
  const auto found = known_.find(run.key);
  if (found == known_.end()) return nullptr;
  const StudyResult& result = found->second;
  return result.status == RunStatus::too_slow && result.cpu_s.value_or(0) < limit_s ? nullptr : &result;
}

void StudyTable::add(const StudyRun& run, const StudyResult& result) {
  file_.append(records_of(study_, run, result));
  known_[run.key] = result;
}

void StudyTable::rewrite(const std::vector<StudyResult>& results) const {
  std::vector<CsvRecord> records;
  for (std::size_t i = 0; i < results.size(); ++i) {
    for (CsvRecord& record : records_of(study_, study_.runs[i], results[i])) records.push_back(std::move(record));
  }
  file_.rewrite(records);
}

}  // namespace proofreel
