#pragma once

#include <optional>
#include <string>
#include <vector>

#include "golden/store.h"

namespace proofreel {

/// The store a scenario file is held against: `given` (from --golden), or when empty the nearest `golden` above the
/// file. Throws UsageError when there is none.
GoldenStore store_for(const std::string& scenario_file, const std::string& given);

/// A scenario file and the store it is held against.
struct StoredScenario {
  std::string file;
  GoldenStore store;
};

/// What `check` and `bless` are asked for: files, ids and folders; the whole collection when nothing is named. A file
/// named twice counts once. Throws UsageError when two files would share one reference.
std::vector<StoredScenario> scenarios_meant(const std::vector<std::string>& named, const std::string& given);

/// The store of the whole collection, when that is what `named` means (nothing, or a folder called scenarios).
std::optional<GoldenStore> collection_store(const std::vector<std::string>& named, const std::string& given);

/// References without a scenario, looked for when the whole collection is meant, whose scenarios have these ids.
std::vector<std::string> orphans_of(const std::vector<std::string>& named, const std::string& given,
                                    std::vector<std::string> ids);

}  // namespace proofreel
