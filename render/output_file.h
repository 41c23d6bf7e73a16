#pragma once

/// Files that appear under their name only when they are whole: written under a temporary name in the same folder,
/// renamed at the end. Whoever finds the final name finds a finished file.

#include <cstdint>
#include <span>
#include <string>

namespace proofreel {

/// The name for a file in the making. A device or a pipe (/dev/stdout) has no name to keep back and is written
/// directly.
class OutputFile {
 public:
  /// Creates the empty temporary. Throws EnvironmentError when the folder is missing or cannot be written.
  explicit OutputFile(const std::string& path);
  /// Removes the temporary unless `publish` has been called.
  ~OutputFile();
  OutputFile(const OutputFile&) = delete;
  OutputFile& operator=(const OutputFile&) = delete;

  /// The final name, as asked for.
  const std::string& path() const { return path_; }
  /// What to open and write; exists already, and is empty.
  const std::string& temporary_path() const { return temporary_; }
  /// Gives the file its final name, replacing what was there. Throws EnvironmentError.
  void publish();

 private:
  std::string path_;
  std::string target_;  ///< the final name with links followed
  std::string temporary_;
  bool pending_ = false;
};

/// Makes the folder, and those it lies in; nothing happens where it is there. Throws EnvironmentError.
void make_folder(const std::string& path);

/// Writes a whole file that way. Throws EnvironmentError: no folder, no permission, no space.
void write_file(const std::string& path, std::span<const std::uint8_t> bytes);
void write_file(const std::string& path, const std::string& text);

}  // namespace proofreel
