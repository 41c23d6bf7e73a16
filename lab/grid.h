#pragma once

/// Scenarios run over and over, by several methods and engines: what is to be run, and what came out. Scorecards are
/// such grids (a row per scenario), and so are the maps of a study (one scenario over two keys).

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "lab/peers/peers.h"
#include "scenarios/scenario.h"

namespace proofreel {

/// What a scenario's expectations say of a run.
enum class Standing : std::uint8_t {
  stands,       ///< all hold
  degrades,     ///< only such do not hold as begin with "quality:"
  fails,        ///< others do not hold, or the simulation came to no end
  too_slow,     ///< it was stopped at the limit of its CPU time
  not_offered,  ///< the engine, or this method of it, does not do what the scene asks for
};
inline constexpr int standing_count = 5;

/// "stands", "too slow".
const char* name_of(Standing standing);
std::optional<Standing> standing_named(std::string_view name);
/// One sign each, so that nobody needs colours to tell them apart; UTF-8.
const char* sign_of(Standing standing);

/// One scenario, stepped once.
struct RunRequest {
  std::string file;
  std::string scenario;             ///< its id
  std::optional<Peer> peer;         ///< who steps it; without one, our engine
  std::vector<Override> set;        ///< what is replaced in scenario{}
  std::vector<std::string> values;  ///< of Grid::keys; empty for what the engine has no choice in
  bool repeated = false;            ///< whether its first second is run once more, to compare the bits
  std::string key;                  ///< the same exactly for runs that can only come out the same
};

struct RunResult {
  Standing standing = Standing::fails;
  std::string why;             ///< what did not hold and when, or why there is no result; sentences
  std::optional<double> at_s;  ///< scene time at which the first of that was seen
  double simulated_s = 0;
  double cpu_s = 0;                      ///< of stepping alone
  std::optional<double> energy_drift_j;  ///< largest, against initial energy and booked work
  std::optional<double> booked_work_j;
  std::optional<double> overlap_share;  ///< at the end: largest overlap, in thicknesses of the thinner body
  std::optional<double> joint_gap_m;    ///< at the end: largest
  std::string trajectory_hash;
  std::optional<bool> same_twice;  ///< whether its first second had the same bits when it was run again
  std::string still;               ///< picture of the end, relative to the grid's folder; empty when there is none

  /// CPU milliseconds per simulated second; nothing for a run that did not come to an end.
  std::optional<double> cost_ms() const;
};

/// A column or a row: what it is part of, what it is called, and what goes without saying.
struct Heading {
  std::string group;
  std::string name;
  std::string detail;
};

struct Grid {
  std::string title;
  std::string about;              ///< a sentence or two for readers of its page
  std::string column_axis;        ///< what `Heading::name` of the columns is: "substeps"
  std::string row_axis;           ///< the same of the rows
  std::vector<std::string> keys;  ///< of scenario{}, which vary
  std::vector<Heading> columns;
  std::vector<Heading> rows;
  std::vector<RunRequest> runs;  ///< row by row
  bool one_scenario = false;     ///< then the cheapest run that stands is one of all, else one of each row

  std::size_t index(std::size_t row, std::size_t column) const { return row * columns.size() + column; }
};

/// "proofreel", or the peer.
std::string engine_of(const RunRequest& run);

/// What scenario{} says of a key that methods vary (rate, substeps, integrator, contact_solver, joint_solver,
/// precision), as
/// `--set` would have it; nothing for other keys.
std::optional<std::string> own_setting(const Scenario& scenario, const std::string& key);

/// A run of the scenario with `set` replaced, as part of a grid over `keys`. Scenarios that name no expectation are
/// refused (ScenarioError): nobody could say whether they stand.
RunRequest request(const Scenario& scenario, std::optional<Peer> peer, const std::vector<Override>& set,
                   const std::vector<std::string>& keys);

/// What `set` replaces, and what `above` replaces; where both name a key, `above` has its way.
std::vector<Override> overlaid(const std::vector<Override>& set, const std::vector<Override>& above);

/// For every run, whether it is the cheapest that stands among those it competes with.
std::vector<bool> cheapest(const Grid& grid, const std::vector<RunResult>& results);

}  // namespace proofreel
