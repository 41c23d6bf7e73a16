#include "cli/scenario_files.h"

#include <algorithm>
#include <filesystem>
#include <set>

#include "render/usage_error.h"

namespace proofreel {
namespace {

namespace fs = std::filesystem;

bool is_scenario(const fs::path& path) {
  std::error_code error;
  return path.extension() == ".lua" && fs::is_regular_file(path, error);
}

/// Whether a file below `folder` lies in a folder called `include` there.
bool is_included(const fs::path& path, const fs::path& folder) {
  const fs::path below = path.parent_path().lexically_relative(folder);
  return std::find(below.begin(), below.end(), "include") != below.end();
}

}  // namespace

std::string scenarios_folder() {
  std::error_code error;
  for (fs::path folder = fs::current_path(error); !folder.empty(); folder = folder.parent_path()) {
    if (fs::is_directory(folder / "scenarios", error)) return (folder / "scenarios").string();
    if (folder == folder.parent_path()) break;
  }
  return PROOFREEL_SCENARIOS;
}

std::string scenario_file(const std::string& path_or_id) {
  if (is_scenario(path_or_id)) return path_or_id;
  const fs::path in_collection = fs::path(scenarios_folder()) / (path_or_id + ".lua");
  if (is_scenario(in_collection)) return in_collection.string();
  if (fs::path(path_or_id).extension() == ".lua") throw UsageError("There is no scenario file " + path_or_id + ".");
  throw UsageError("There is no scenario \"" + path_or_id + "\": neither a file nor an id below " + scenarios_folder() +
                   "; `proofreel list` shows the ids.");
}

std::vector<std::string> scenario_files_in(const std::string& folder) {
  std::error_code error;
  if (!fs::is_directory(folder, error)) throw UsageError("There is no folder " + folder + ".");
  std::vector<std::string> files;
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(folder, error)) {
    if (is_scenario(entry.path()) && !is_included(entry.path(), folder)) files.push_back(entry.path().string());
  }
  if (files.empty()) throw UsageError("There is no scenario (.lua) in " + folder + ".");
  std::sort(files.begin(), files.end());
  return files;
}

std::vector<std::string> scenario_files_meant(const std::vector<std::string>& named, const std::string& folder) {
  if (named.empty()) return scenario_files_in(folder);
  std::vector<std::string> files;
  std::set<fs::path> seen;
  const auto add = [&](const std::string& file) {
    if (seen.insert(fs::weakly_canonical(file)).second) files.push_back(file);
  };
  for (const std::string& name : named) {
    if (!fs::is_directory(name)) {
      add(scenario_file(name));
      continue;
    }
    for (const std::string& file : scenario_files_in(name)) add(file);
  }
  return files;
}

}  // namespace proofreel
