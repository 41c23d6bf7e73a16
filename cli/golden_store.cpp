#include "cli/golden_store.h"

#include <filesystem>

#include "cli/scenario_files.h"
#include "render/usage_error.h"

namespace proofreel {

GoldenStore store_for(const std::string& scenario_file, const std::string& given) {
  if (!given.empty()) return GoldenStore(given);
  if (const std::optional<GoldenStore> nearest = nearest_store(scenario_file)) return *nearest;
  throw UsageError("There is no folder `golden` above " + scenario_file + ": make one, or name one with --golden DIR.");
}

std::vector<std::string> files_meant(const std::vector<std::string>& named) {
  if (named.empty()) return scenario_files_in(scenarios_folder());
  std::vector<std::string> files;
  for (const std::string& name : named) {
    if (std::filesystem::is_directory(name)) {
      for (std::string& file : scenario_files_in(name)) files.push_back(std::move(file));
    } else {
      files.push_back(scenario_file(name));
    }
  }
  return files;
}

}  // namespace proofreel
