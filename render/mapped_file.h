#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>

namespace proofreel {

/// A file's bytes, read by the machine when they are looked at, without a copy. Whoever shortens the file meanwhile
/// ends the program: only for files that nobody writes.
class MappedFile {
 public:
  /// Empty files have no bytes. Check `problem` first.
  explicit MappedFile(const std::string& path);
  ~MappedFile();
  MappedFile(const MappedFile&) = delete;
  MappedFile& operator=(const MappedFile&) = delete;

  /// Why the file cannot be read, as "it is a folder"; empty when it can.
  const std::string& problem() const { return problem_; }
  std::span<const std::uint8_t> bytes() const { return {data_, size_}; }

 private:
  std::string problem_;
  const std::uint8_t* data_ = nullptr;
  std::size_t size_ = 0;
};

}  // namespace proofreel
