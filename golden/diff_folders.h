#pragma once

#include <string>
#include <vector>

namespace proofreel {

/// The pictures and films below two folders, matched by their path in it. All sorted, numbers in names by value.
struct FolderMatch {
  std::vector<std::string> both;
  std::vector<std::string> removed;  ///< only in the expected folder
  std::vector<std::string> added;    ///< only in the actual folder
};

/// Looks at .png files and at films (render/video_reader.h), in folders of folders too; links to folders are not
/// followed. Throws ImageError when a folder cannot be read or there is nothing to compare in either.
FolderMatch match_folders(const std::string& expected, const std::string& actual);

}  // namespace proofreel
