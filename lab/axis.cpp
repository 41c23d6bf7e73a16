#include "lab/axis.h"

#include <set>

#include "lab/grid.h"
#include "render/usage_error.h"
#include "scenarios/overrides.h"

namespace proofreel {
namespace {

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

std::string full_key(const Axis& axis) {
  try {
    return parse_override({axis.key, axis.values.front()}).path;
  } catch (const ScenarioError& error) {
    throw_if_blamed(error);
    throw;
  }
}

void check_axis(const std::string& file, const Axis& axis, const std::vector<Override>& set) {
  for (const std::string& value : axis.values) {
    try {
      load_scenario(file, overlaid(set, {{axis.key, value}}));
    } catch (const ScenarioError& error) {
      throw_if_blamed(error);
    }
  }
}

std::vector<Axis> parse_axes(const std::vector<std::string>& given) {
  std::vector<Axis> axes;
  std::set<std::string> keys;
  for (const std::string& text : given) {
    axes.push_back(parse_axis(text));
    const bool is_new = keys.insert(full_key(axes.back())).second;
    if (!is_new) throw UsageError("--vary names " + axes.back().key + " twice.");
  }
  return axes;
}

}  // namespace proofreel
