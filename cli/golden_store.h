#pragma once

#include <string>

#include "golden/store.h"

namespace proofreel {

/// The store a scenario file is held against: `given` (from --golden), or when empty the nearest `golden` above the
/// file. Throws UsageError when there is none.
GoldenStore store_for(const std::string& scenario_file, const std::string& given);

/// The files `check` and `bless` are asked for: files, ids and folders; the whole collection when nothing is named.
std::vector<std::string> files_meant(const std::vector<std::string>& named);

}  // namespace proofreel
