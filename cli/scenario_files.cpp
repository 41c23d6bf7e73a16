#include "cli/scenario_files.h"

#include <algorithm>
#include <filesystem>

#include "render/usage_error.h"

namespace proofreel {
namespace {

namespace fs = std::filesystem;

bool is_scenario(const fs::path& path) {
  std::error_code error;
  return path.extension() == ".lua" && fs::is_regular_file(path, error);
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
  for (auto entry = fs::recursive_directory_iterator(folder, error); entry != fs::recursive_directory_iterator();
       entry.increment(error)) {
    if (entry->path().filename() == "include") entry.disable_recursion_pending();
    if (is_scenario(entry->path())) files.push_back(entry->path().string());
  }
  if (files.empty()) throw UsageError("There is no scenario (.lua) in " + folder + ".");
  std::sort(files.begin(), files.end());
  return files;
}

}  // namespace proofreel
