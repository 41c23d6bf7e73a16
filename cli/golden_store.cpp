#include "cli/golden_store.h"

#include <algorithm>
#include <filesystem>
#include <map>

#include "cli/scenario_files.h"
#include "golden/check.h"
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

std::optional<GoldenStore> collection_store(const std::vector<std::string>& named, const std::string& given) {
  const std::string folder = named.empty() ? scenarios_folder() : named.front();
  const std::filesystem::path path = std::filesystem::weakly_canonical(folder);
  if (named.size() > 1 || path.filename() != "scenarios") return std::nullopt;
  return store_for((path / "any").string(), given);
}

std::vector<std::string> orphans_of(const std::vector<std::string>& named, const std::string& given,
                                    std::vector<std::string> ids) {
  std::sort(ids.begin(), ids.end());
  const std::optional<GoldenStore> store = collection_store(named, given);
  return store ? orphan_ids(*store, ids) : std::vector<std::string>{};
}

}  // namespace proofreel
