#include "lab/scorecard.h"

#include "scenarios/runner.h"

namespace proofreel {
namespace {

/// One of the engine's methods. The scene's own number of substeps is 0, its own contact solver "": mostly that is
/// "auto", and "event" where located impacts are what the scene is about.
struct MethodColumn {
  const char* contact_solver;
  const char* joint_solver;
  int substeps;
  const char* precision;
};

/// From what is taken by default to what is kept for comparison.
constexpr MethodColumn method_columns[] = {
    {"", "direct", 0, "double"},
    {"", "direct", 0, "single"},
    {"", "direct", 1, "double"},
    {"", "direct", 2, "double"},
    {"", "direct", 8, "double"},
    {"", "iterative", 0, "double"},
    {"soft_step", "direct", 0, "double"},
    {"soft_step", "direct", 0, "single"},
    {"soft_step", "direct", 8, "double"},
    {"soft_step", "direct", 16, "double"},
    {"sequential_impulses", "direct", 0, "double"},
    {"sequential_impulses", "direct", 8, "double"},
    {"ngs", "direct", 0, "double"},
    {"ngs", "direct", 8, "double"},
    {"exact", "direct", 0, "double"},
    {"event", "direct", 0, "double"},
};

/// What both peers are made for.
constexpr const char* peer_rate = "60";

std::string substeps_text(int substeps) { return substeps == 0 ? "own" : std::to_string(substeps); }

Heading heading_of(const MethodColumn& method) {
  std::string group = *method.contact_solver == '\0' ? "default" : method.contact_solver;
  if (std::string_view(method.joint_solver) == "iterative") group += ", iterative joints";
  return {group, substeps_text(method.substeps), method.precision};
}

Heading heading_of(Peer peer) {
  return {name_of(peer), std::string(peer_rate) + " Hz", peer == Peer::box2d ? "single" : "double"};
}

std::vector<Override> settings_of(const MethodColumn& method) {
  std::vector<Override> set{{"joint_solver", method.joint_solver}, {"precision", method.precision}};
  if (*method.contact_solver != '\0') set.push_back({"contact_solver", method.contact_solver});
  if (method.substeps > 0) set.push_back({"substeps", std::to_string(method.substeps)});
  return set;
}

void add_row(Grid& grid, const Scenario& scenario, const std::vector<Peer>& against, const std::vector<Override>& set) {
  must_be_one_scene(scenario);
  grid.rows.push_back({"", scenario.id, scenario.title});
  for (const MethodColumn& method : method_columns) {
    grid.runs.push_back(request(scenario, std::nullopt, overlaid(set, settings_of(method)), grid.keys));
    grid.runs.back().repeated = &method == &method_columns[0];
  }
  const std::vector<Override> for_peers = overlaid({{"rate", peer_rate}}, set);
  for (const Peer peer : against) grid.runs.push_back(request(scenario, peer, for_peers, grid.keys));
}

std::optional<std::size_t> column_of_box2d(const Grid& grid) {
  for (std::size_t c = 0; c < grid.columns.size() && !grid.rows.empty(); ++c) {
    if (grid.runs[c].peer == Peer::box2d) return c;
  }
  return std::nullopt;
}

/// Sums over the rows both columns came to an end in.
void hold_against(MethodScore& score, const Grid& grid, const std::vector<RunResult>& results, std::size_t column,
                  std::size_t other) {
  double sum = 0;
  double others = 0;
  for (std::size_t row = 0; row < grid.rows.size(); ++row) {
    const std::optional<double> mine = results[grid.index(row, column)].cost_ms();
    const std::optional<double> theirs = results[grid.index(row, other)].cost_ms();
    if (!mine || !theirs) continue;
    sum += *mine;
    others += *theirs;
    ++score.shared;
  }
  if (others > 0) score.to_box2d = sum / others;
}

}  // namespace

Grid scorecard_grid(const std::vector<std::string>& files, const std::vector<Peer>& against,
                    const std::vector<Override>& set) {
  Grid grid;
  grid.title = "Scorecard";
  grid.about =
      "Scenes that are hard to keep stable, by every method of the engine and by its peers at their declared defaults. "
      "The first column is what is taken by default; "
      "\u201cown\u201d are the substeps the scene itself asks for.";
  grid.column_axis = "substeps";
  grid.row_axis = "scenario";
  grid.keys = {"contact_solver", "joint_solver", "substeps", "precision", "rate"};
  for (const MethodColumn& method : method_columns) grid.columns.push_back(heading_of(method));
  for (const Peer peer : against) grid.columns.push_back(heading_of(peer));
  for (const std::string& file : files) add_row(grid, *load_scenario(file, set), against, set);
  return grid;
}

std::vector<MethodScore> scores_of(const Grid& grid, const std::vector<RunResult>& results) {
  const std::optional<std::size_t> box2d = column_of_box2d(grid);
  std::vector<MethodScore> scores;
  for (std::size_t column = 0; column < grid.columns.size(); ++column) {
    MethodScore score;
    score.heading = grid.columns[column];
    score.engine = grid.rows.empty() ? "" : engine_of(grid.runs[column]);
    score.scenarios = static_cast<int>(grid.rows.size());
    for (std::size_t row = 0; row < grid.rows.size(); ++row) {
      const RunResult& result = results[grid.index(row, column)];
      ++score.counts[static_cast<std::size_t>(result.standing)];
      score.cost_ms += result.cost_ms().value_or(0);
      score.costed += result.cost_ms() ? 1 : 0;
    }
    if (box2d) hold_against(score, grid, results, column, *box2d);
    scores.push_back(score);
  }
  return scores;
}

bool default_stands(const Grid& grid, const std::vector<RunResult>& results) {
  for (std::size_t row = 0; row < grid.rows.size(); ++row) {
    if (results[grid.index(row, 0)].standing != Standing::stands) return false;
  }
  return true;
}

}  // namespace proofreel
