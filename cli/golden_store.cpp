#include "cli/golden_store.h"

#include <filesystem>
#include <map>

#include "cli/scenario_files.h"
#include "render/usage_error.h"
#include "scenarios/source.h"

namespace proofreel {
GoldenStore store_for(const std::string& scenario_file, const std::string& given) {
  if (!given.empty()) return GoldenStore(given);
  if (const std::optional<GoldenStore> nearest = nearest_store(scenario_file)) return *nearest;
  throw UsageError("There is no folder `golden` above " + scenario_file + ": make one, or name one with --golden DIR.");
}

std::vector<StoredScenario> scenarios_meant(const std::vector<std::string>& named, const std::string& given) {
  std::vector<StoredScenario> meant;
  std::map<std::filesystem::path, std::string> file_of_reference;
  for (const std::string& file : scenario_files_meant(named, scenarios_folder())) {
    const GoldenStore store = store_for(file, given);
    const std::string id = id_of(file);
    const auto [entry, is_new] = file_of_reference.emplace(std::filesystem::weakly_canonical(store.folder(id)), file);
    if (is_new) {
      meant.push_back({file, store});
    } else if (!std::filesystem::equivalent(entry->second, file)) {
      throw UsageError(entry->second + " and " + file + " would share the reference \"" + id +
                       "\": rename one, or put both below a folder called `scenarios`.");
    }
  }
  return meant;
}

}  // namespace proofreel
