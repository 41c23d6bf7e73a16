#include "lab/callgrind.h"

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <filesystem>
#include <fstream>

#include "scenarios/environment_error.h"

namespace proofreel {
namespace {

/// A file of this process, gone with this object.
class CountsFile {
 public:
  CountsFile() : path_(std::filesystem::temp_directory_path() / ("proofreel-counts-" + std::to_string(::getpid()))) {}
  ~CountsFile() {
    std::error_code ignored;
    std::filesystem::remove(path_, ignored);
  }
  CountsFile(const CountsFile&) = delete;
  CountsFile& operator=(const CountsFile&) = delete;
  std::string path() const { return path_.string(); }

 private:
  std::filesystem::path path_;
};

/// Runs the words without a word on the terminal; their exit status, 127 where there is no such program.
int run_silently(std::vector<std::string> words) {
  std::vector<char*> argv;
  for (std::string& word : words) argv.push_back(word.data());
  argv.push_back(nullptr);
  posix_spawn_file_actions_t silence;
  posix_spawn_file_actions_init(&silence);
  for (const int stream : {STDOUT_FILENO, STDERR_FILENO})
    posix_spawn_file_actions_addopen(&silence, stream, "/dev/null", O_WRONLY, 0);
  pid_t child = 0;
  const int failure = posix_spawnp(&child, argv[0], &silence, nullptr, argv.data(), environ);
  posix_spawn_file_actions_destroy(&silence);
  if (failure != 0) return 127;
  int status = 0;
  while (::waitpid(child, &status, 0) < 0 && errno == EINTR) {
  }
  return WIFEXITED(status) ? WEXITSTATUS(status) : 126;
}

std::int64_t total_of(const std::string& path) {
  std::ifstream counts(path);
  std::string word;
  std::int64_t total = 0;
  while (counts >> word) {
    if (word == "totals:") counts >> total;
  }
  return total;
}

}  // namespace

std::int64_t instructions(const std::vector<std::string>& command, const std::string& inside) {
  const CountsFile counts;
  std::vector<std::string> words{"valgrind", "--tool=callgrind", "--callgrind-out-file=" + counts.path(),
                                 "--toggle-collect=" + inside};
  words.insert(words.end(), command.begin(), command.end());
  const int status = run_silently(words);
  if (status == 127)
    throw EnvironmentError(
        "valgrind, which counts instructions, is not installed; install the Debian package valgrind.");
  // 1 is the program's word for a scenario that does not hold what it expects: its steps count all the same.
  if (status != 0 && status != 1) throw EnvironmentError("Under valgrind this failed: " + command.front() + ".");
  return total_of(counts.path());
}

}  // namespace proofreel
