#pragma once

#include <string>
#include <vector>

namespace proofreel {

/// The folder of the collection: the nearest `scenarios` beside or above the current folder, else the one the program
/// was built with.
std::string scenarios_folder();

/// The file a user means by a path (ends in .lua) or an id (path below the collection, without .lua). Throws UsageError
/// when there is none.
std::string scenario_file(const std::string& path_or_id);

/// All scenario files in a folder and its folders, sorted; what lies in folders called `include` are parts of others.
/// Throws UsageError when it is no folder or holds none.
std::vector<std::string> scenario_files_in(const std::string& folder);

/// The files that paths, ids and folders mean, each once, in this order; all in `folder` when nothing is named. Throws
/// UsageError.
std::vector<std::string> scenario_files_meant(const std::vector<std::string>& named, const std::string& folder);

}  // namespace proofreel
