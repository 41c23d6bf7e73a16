#include "lab/grid_work.h"

#include <filesystem>
#include <set>

#include "lab/children.h"
#include "lab/grid_run.h"
#include "lab/grid_table.h"
#include "render/output_file.h"
#include "scenarios/environment_error.h"

namespace proofreel {
namespace {

namespace fs = std::filesystem;

/// Beyond a run's own limit: for loading, measuring, the second run of a second, and drawing.
constexpr double grace_s = 10;

/// A line and a picture through one pipe.
std::string packed(const RunRequest& request, const RunOutcome& outcome) {
  const std::string line = csv_line(record_of(request, outcome.result));
  return std::to_string(line.size()) + ":" + line + outcome.still;
}

RunOutcome unpacked(const std::string& bytes, std::size_t keys) {
  const std::size_t colon = bytes.find(':');
  const std::size_t size = std::stoul(bytes.substr(0, colon));
  const CsvRecord record = csv_records(bytes.substr(colon + 1, size)).at(0);
  return {result_in(record, keys).value().result, bytes.substr(colon + 1 + size)};
}

RunResult stopped(double limit_s) {
  RunResult result;
  result.standing = Standing::too_slow;
  result.cpu_s = limit_s;
  result.why = "stopped within a step that came to no end in time";
  return result;
}

RunResult crashed(const std::string& died_of) {
  RunResult result;
  result.why = "the engine crashed: " + died_of;
  return result;
}

/// A file name nobody stumbles over.
std::string plain(std::string text) {
  for (char& c : text) {
    const bool letter = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9');
    if (!letter && c != '-' && c != '.') c = '_';
  }
  return text;
}

std::string still_name(const RunRequest& request) {
  std::string name = request.scenario + "-" + engine_of(request);
  for (const std::string& value : request.values) name.append(value.empty() ? "" : "-").append(value);
  constexpr std::size_t longest = 120;
  return "stills/" + plain(name.substr(0, longest)) + "-" + request.key.substr(0, 8) + ".png";
}

class Worker {
 public:
  Worker(const Grid& grid, const GridWork& work, const WorkProgress& progress)
      : grid_(grid), work_(work), progress_(progress), table_((fs::path(work.folder) / work.table).string(), grid) {}

  void run() {
    const std::vector<std::size_t> todo = unknown();
    const auto work_of = [&](std::size_t i) {
      const RunRequest& request = grid_.runs[todo[i]];
      return ChildWork{[&request, this] { return packed(request, outcome_of(request)); },
                       whole_limit * work_.limit_s + grace_s};
    };
    const auto keep_end = [&](std::size_t i, const ChildEnd& end) { keep(todo[i], end); };
    work_off_children(todo.size(), work_.at_once, work_of, keep_end, progress_);
  }

  std::vector<RunResult> results() const {
    std::vector<RunResult> results;
    for (const RunRequest& request : grid_.runs) {
      const RunResult* result = table_.find(request, 0);
      if (result == nullptr) throw EnvironmentError("Pictures went away from " + work_.folder + ": start it again.");
      results.push_back(*result);
    }
    table_.rewrite(grid_, results);
    return results;
  }

 private:
  std::vector<std::size_t> unknown() const {
    std::vector<std::size_t> todo;
    std::set<std::string> seen;
    for (std::size_t i = 0; i < grid_.runs.size(); ++i) {
      const RunRequest& request = grid_.runs[i];
      if (seen.insert(request.key).second && table_.find(request, work_.limit_s) == nullptr) todo.push_back(i);
    }
    return todo;
  }

  /// In the child. A machine that cannot draw stops everything; whatever else goes wrong is that run's result.
  RunOutcome outcome_of(const RunRequest& request) const {
    try {
      return run_once(request, work_.limit_s, work_.gl);
    } catch (const EnvironmentError&) {
      throw;
    } catch (const std::exception& error) {
      return {crashed(error.what()), {}};
    }
  }

  void keep(std::size_t index, const ChildEnd& end) {
    const RunRequest& request = grid_.runs[index];
    RunOutcome outcome;
    if (end.out_of_time) {
      outcome.result = stopped(work_.limit_s);
    } else if (!end.died_of.empty()) {
      outcome.result = crashed(end.died_of);
    } else {
      outcome = unpacked(end.answer, grid_.keys.size());
    }
    if (!outcome.still.empty()) {
      outcome.result.still = still_name(request);
      write_file((fs::path(work_.folder) / outcome.result.still).string(), outcome.still);
    }
    table_.add(request, outcome.result);
  }

  const Grid& grid_;
  const GridWork& work_;
  const WorkProgress& progress_;
  GridTable table_;
};

}  // namespace

std::vector<RunResult> work_off(const Grid& grid, const GridWork& work, const WorkProgress& progress) {
  make_folder((fs::path(work.folder) / "stills").string());
  Worker worker(grid, work, progress);
  worker.run();
  return worker.results();
}

}  // namespace proofreel
