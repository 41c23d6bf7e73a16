#include "lab/study_map.h"

#include <array>
#include <set>

#include "render/usage_error.h"
#include "scenarios/runner.h"

namespace proofreel {
namespace {

const std::array<Axis, 2>& default_axes() {
  static const std::array<Axis, 2> axes{{{"rate", {"60", "120", "240"}}, {"substeps", {"1", "2", "4", "8"}}}};
  return axes;
}

}  // namespace

std::vector<Axis> map_axes(const std::vector<std::string>& given) {
  std::vector<Axis> axes = parse_axes(given);
  if (axes.size() > 2) throw UsageError("A map has two axes: give --vary no more than twice.");
  std::set<std::string> keys;
  for (const Axis& axis : axes) keys.insert(full_key(axis));
  for (const Axis& axis : default_axes()) {
    if (axes.size() < 2 && keys.insert(full_key(axis)).second) axes.push_back(axis);
  }
  return axes;
}

Grid map_grid(const std::string& file, const std::vector<Axis>& axes, const std::vector<Override>& set) {
  const std::unique_ptr<Scenario> scenario = load_scenario(file, set);
  must_be_one_scene(*scenario);
  for (const Axis& axis : axes) check_axis(file, axis, set);
  Grid grid;
  grid.title = "Map of " + scenario->id;
  grid.about =
      scenario->title + ": where it stands over " + axes[0].key + " and " + axes[1].key + ", and what it costs.";
  grid.column_axis = axes[0].key;
  grid.row_axis = axes[1].key;
  grid.keys = {axes[0].key, axes[1].key};
  grid.one_scenario = true;
  for (const std::string& value : axes[0].values) grid.columns.push_back({axes[0].key, value, ""});
  for (const std::string& row : axes[1].values) {
    grid.rows.push_back({axes[1].key, row, ""});
    for (const std::string& column : axes[0].values) {
      const std::vector<Override> varied{{axes[0].key, column}, {axes[1].key, row}};
      grid.runs.push_back(request(*scenario, std::nullopt, overlaid(set, varied), grid.keys));
    }
  }
  return grid;
}

}  // namespace proofreel
