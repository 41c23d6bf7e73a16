#include "golden/diff_folders.h"

#include <algorithm>
#include <filesystem>
#include <iterator>

#include "golden/frame_source.h"
#include "render/png.h"

namespace proofreel {
namespace {

namespace fs = std::filesystem;

std::vector<std::string> names_in(const std::string& folder) {
  std::vector<std::string> names;
  std::error_code error;
  fs::recursive_directory_iterator entry(folder, error);
  for (; !error && entry != fs::recursive_directory_iterator(); entry.increment(error)) {
    const fs::path& path = entry->path();
    const bool meant = path.extension() == ".png" || is_film_name(path.string());
    std::error_code ignored;  // reading it will say what is wrong
    if (meant && !entry->is_directory(ignored)) names.push_back(path.lexically_relative(folder).generic_string());
  }
  if (error) throw ImageError("Cannot read " + folder + ": " + error.message() + ".");
  std::sort(names.begin(), names.end(), comes_before);
  return names;
}

}  // namespace

FolderMatch match_folders(const std::string& expected, const std::string& actual) {
  const std::vector<std::string> then = names_in(expected), now = names_in(actual);
  if (then.empty() && now.empty()) {
    throw ImageError("There are no pictures or films in " + expected + " nor in " + actual + ".");
  }
  FolderMatch match;
  std::set_intersection(then.begin(), then.end(), now.begin(), now.end(), std::back_inserter(match.both), comes_before);
  std::set_difference(then.begin(), then.end(), now.begin(), now.end(), std::back_inserter(match.removed),
                      comes_before);
  std::set_difference(now.begin(), now.end(), then.begin(), then.end(), std::back_inserter(match.added), comes_before);
  return match;
}

}  // namespace proofreel
