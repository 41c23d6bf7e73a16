#pragma once

/// Scenarios that come out in every way a run can come out.

#include <string>
#include <vector>

#include "lab/grid_work.h"
#include "tests/render/scratch_folder.h"

namespace proofreel::test {

/// Half a second of a ball in free fall, and `rest`.
inline std::string fall(const std::string& rest, const std::string& keys = "") {
  return "scenario { duration = 0.5, rate = 60, view = { center = {0, 0}, height = 8 }" + keys +
         " }\n"
         "local ball = body { name = \"ball\", at = {0, 5}, shape = circle { radius = 0.5 } }\n" +
         rest;
}

inline std::string expecting(const std::string& text, bool held) {
  return "expect(\"" + text + "\", function() return " + (held ? "true" : "false") + " end)\n";
}

/// What came out of a run of one second that took this many milliseconds of CPU time.
inline RunResult costing(double cost_ms, Standing standing = Standing::stands) {
  RunResult result;
  result.standing = standing;
  result.simulated_s = 1;
  result.cpu_s = 1e-3 * cost_ms;
  return result;
}

/// A folder with scenarios, and one to work in.
class GridFolder {
 public:
  std::string write(const std::string& id, const std::string& lua) const {
    write_text(folder_ / ("scenarios/" + id + ".lua"), lua);
    return folder_ / ("scenarios/" + id + ".lua");
  }
  std::string out() const { return folder_ / "out"; }
  std::string table() const { return out() + "/runs.csv"; }
  GridWork work(double limit_s = 10) const { return {out(), "runs.csv", limit_s, 1, {}}; }

  /// One run in a grid of its own, over no keys.
  RunResult result_of(const std::string& lua, std::optional<Peer> peer = {}, const std::vector<Override>& set = {},
                      double limit_s = 10) const {
    return work_off(grid_of({lua}, peer, set), work(limit_s), [](auto, auto) {}).front();
  }

  Grid grid_of(const std::vector<std::string>& luas, std::optional<Peer> peer = {},
               const std::vector<Override>& set = {}) const {
    Grid grid;
    grid.columns = {{"", "only", ""}};
    for (const std::string& lua : luas) {
      const std::string file = write("s" + std::to_string(grid.rows.size()), lua);
      const auto scenario = load_scenario(file, {});
      grid.rows.push_back({"", scenario->id, ""});
      grid.runs.push_back(request(*scenario, peer, set, grid.keys));
    }
    return grid;
  }

 private:
  ScratchFolder folder_;
};

}  // namespace proofreel::test
