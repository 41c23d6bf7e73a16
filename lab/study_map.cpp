#include "lab/study_map.h"

#include <algorithm>
#include <array>
#include <set>

#include "render/usage_error.h"
#include "scenarios/overrides.h"

namespace proofreel {
namespace {

const std::array<Axis, 2>& default_axes() {
  static const std::array<Axis, 2> axes{{{"rate", {"60", "120", "240"}}, {"substeps", {"1", "2", "4", "8"}}}};
  return axes;
}

/// More would be neither read nor waited for.
constexpr std::size_t most_values = 40;

std::vector<std::string> divided(const std::string& text) {
  std::vector<std::string> parts(1);
  int depth = 0;
  for (const char c : text) {
    depth += c == '{' ? 1 : c == '}' ? -1 : 0;
    if (c == ',' && depth == 0) {
      parts.emplace_back();
    } else {
      parts.back() += c;
    }
  }
  return parts;
}

/// Errors that blame `--set`, as whose values we pass them on, blame `--vary`; others are not about the value.
void throw_if_blamed(const ScenarioError& error) {
  constexpr std::string_view blamed = "--set ";
  const std::string_view message = error.what();
  if (message.starts_with(blamed)) throw UsageError("--vary " + std::string(message.substr(blamed.size())));
}

/// The full key, so that `substeps` and `method.substeps` are one.
std::string full_key(const Axis& axis) {
  try {
    return parse_override({axis.key, axis.values.front()}).path;
  } catch (const ScenarioError& error) {
    throw_if_blamed(error);
    throw;
  }
}

/// What is wrong with a value is said before anything is run; that it does not go with the scene is a result.
void check_axis(const std::string& file, const Axis& axis, const std::vector<Override>& set) {
  for (const std::string& value : axis.values) {
    try {
      load_scenario(file, overlaid(set, {{axis.key, value}}));
    } catch (const ScenarioError& error) {
      throw_if_blamed(error);
    }
  }
}

}  // namespace

Axis parse_axis(const std::string& text) {
  const std::size_t equals = text.find('=');
  if (equals == 0 || equals == std::string::npos) {
    throw UsageError("--vary takes KEY=VALUE,VALUE,..., such as substeps=1,2,4, not \"" + text + "\".");
  }
  Axis axis{text.substr(0, equals), divided(text.substr(equals + 1))};
  if (axis.values.size() > most_values) {
    throw UsageError("--vary " + axis.key + " has more than " + std::to_string(most_values) + " values.");
  }
  const std::set<std::string> distinct(axis.values.begin(), axis.values.end());
  if (distinct.size() < axis.values.size() || distinct.contains("")) {
    throw UsageError("--vary " + text + ": every value must be there, and be there once.");
  }
  return axis;
}

std::vector<Axis> map_axes(const std::vector<std::string>& given) {
  std::vector<Axis> axes;
  std::set<std::string> keys;
  const auto add = [&](const Axis& axis) {
    const bool is_new = keys.insert(full_key(axis)).second;
    if (is_new) axes.push_back(axis);
    return is_new;
  };
  for (const std::string& text : given) {
    const Axis axis = parse_axis(text);
    if (!add(axis)) throw UsageError("--vary names " + axis.key + " twice.");
  }
  if (axes.size() > 2) throw UsageError("A map has two axes: give --vary no more than twice.");
  for (const Axis& axis : default_axes()) {
    if (axes.size() < 2) add(axis);
  }
  return axes;
}

Grid map_grid(const std::string& file, const std::vector<Axis>& axes, const std::vector<Override>& set) {
  const std::unique_ptr<Scenario> scenario = load_scenario(file, set);
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
