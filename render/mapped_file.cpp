#include "render/mapped_file.h"

#include <fcntl.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>

namespace proofreel {
namespace {

std::string problem_with(int file, const struct stat& info) {
  if (file < 0) return std::strerror(errno);
  if (S_ISDIR(info.st_mode)) return "it is a folder";
  if (!S_ISREG(info.st_mode)) return "it is not a regular file";
  return {};
}

}  // namespace

MappedFile::MappedFile(const std::string& path) {
  // Without O_NONBLOCK a named pipe would wait for somebody to write.
  const int file = ::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK);
  struct stat info {};
  if (file >= 0) ::fstat(file, &info);
  problem_ = problem_with(file, info);
  if (problem_.empty() && info.st_size > 0) {
    const auto size = static_cast<std::size_t>(info.st_size);
    void* place = ::mmap(nullptr, size, PROT_READ, MAP_PRIVATE, file, 0);
    if (place == MAP_FAILED) {
      problem_ = std::strerror(errno);
    } else {
      data_ = static_cast<const std::uint8_t*>(place);
      size_ = size;
    }
  }
  if (file >= 0) ::close(file);
}

MappedFile::~MappedFile() {
  if (data_ != nullptr) ::munmap(const_cast<std::uint8_t*>(data_), size_);
}

}  // namespace proofreel
