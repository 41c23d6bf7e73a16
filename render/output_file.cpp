#include "render/output_file.h"

#include <fcntl.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <cstring>
#include <filesystem>

#include "scenarios/environment_error.h"

namespace proofreel {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void fail(const std::string& path, int error) {
  throw EnvironmentError("Cannot write " + path + ": " + std::strerror(error) + ".");
}

/// Follows links, so that a rename replaces the file meant and never the link (/dev/stdout is one).
std::string with_links_followed(const std::string& path) {
  std::error_code error;
  const fs::path target = fs::canonical(path, error);
  return error ? path : target.string();
}

/// "out/film.mp4" -> "out/film.partial-4711-0.mp4": unique, and still with the ending players go by, so that what a
/// killed run leaves can be looked at.
std::string temporary_name(const fs::path& target) {
  static std::atomic<int> counter{0};
  std::string name = target.stem().string();
  name.append(".partial-").append(std::to_string(::getpid())).append("-").append(std::to_string(counter++));
  return (target.parent_path() / name.append(target.extension().string())).string();
}

void check_folder(const std::string& path, const fs::path& target) {
  const fs::path folder = target.has_parent_path() ? target.parent_path() : fs::path(".");
  std::error_code error;
  if (fs::is_directory(target, error)) throw EnvironmentError("Cannot write " + path + ": it is a folder.");
  if (!fs::is_directory(folder, error)) {
    throw EnvironmentError("Cannot write " + path + ": the folder " + folder.string() + " does not exist.");
  }
}

bool is_special(const std::string& target) {
  std::error_code error;
  return fs::exists(target, error) && !fs::is_regular_file(target, error);
}

int write_all(int file, std::span<const std::uint8_t> bytes) {
  while (!bytes.empty()) {
    const ssize_t written = ::write(file, bytes.data(), bytes.size());
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) return errno;
    bytes = bytes.subspan(static_cast<std::size_t>(written));
  }
  return 0;
}

}  // namespace

OutputFile::OutputFile(const std::string& path) : path_(path), target_(with_links_followed(path)) {
  check_folder(path_, target_);
  if (is_special(target_)) {
    temporary_ = target_;
    return;
  }
  temporary_ = temporary_name(target_);
  const int file = ::open(temporary_.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666);
  if (file < 0) fail(path_, errno);
  ::close(file);
  pending_ = true;
}

OutputFile::~OutputFile() {
  if (pending_) ::unlink(temporary_.c_str());
}

void OutputFile::publish() {
  if (!pending_) return;
  if (::rename(temporary_.c_str(), target_.c_str()) != 0) fail(path_, errno);
  pending_ = false;
}

void make_folder(const std::string& path) {
  std::error_code error;
  std::filesystem::create_directories(path, error);
  if (error) throw EnvironmentError("Cannot make the folder " + path + ": " + error.message() + ".");
}

void write_file(const std::string& path, std::span<const std::uint8_t> bytes) {
  OutputFile output(path);
  const int file = ::open(output.temporary_path().c_str(), O_WRONLY | O_CLOEXEC);
  if (file < 0) fail(path, errno);
  const int write_error = write_all(file, bytes);
  const int close_error = ::close(file) == 0 ? 0 : errno;
  if (write_error != 0) fail(path, write_error);
  if (close_error != 0) fail(path, close_error);
  output.publish();
}

void write_file(const std::string& path, const std::string& text) {
  write_file(path, {reinterpret_cast<const std::uint8_t*>(text.data()), text.size()});
}

}  // namespace proofreel
