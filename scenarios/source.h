#pragma once

/// The only place of this folder that touches files.

#include <string>
#include <string_view>

namespace proofreel {

/// The text of a scenario file without its byte order mark. Throws ScenarioError when it is missing, not a plain file,
/// or larger than 16 MB.
std::string read_source(const std::string& path);

/// The path of a file that the scenario at `scenario_path` includes as `name`. Throws std::runtime_error when `name`
/// leads out of the scenario's folder, symbolic links included, or there is no such file.
std::string included_path(const std::string& scenario_path, std::string_view name);

/// The scenario's id: its path below the last folder called "scenarios", or its file name; without ".lua".
std::string id_of(const std::string& path);

}  // namespace proofreel
