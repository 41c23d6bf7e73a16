#include "tests/cli/program.h"

#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <atomic>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <stdexcept>

#include "tests/render/scratch_folder.h"

namespace proofreel {
namespace {

std::string capture_path(const char* stream) {
  static std::atomic<int> counter{0};
  const std::string name = "proofreel-" + std::to_string(::getpid()) + "-" + std::to_string(counter++) + stream;
  return (std::filesystem::temp_directory_path() / name).string();
}

void redirect(int stream, const std::string& path) {
  const int file = ::open(path.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
  ::dup2(file, stream);
  ::close(file);
}

std::string take(const std::string& path) {
  std::string text = read_text(path);
  std::filesystem::remove(path);
  return text;
}

}  // namespace

Program::Program(const std::vector<std::string>& arguments, const std::string& folder, const Environment& environment)
    : out_path_(capture_path(".out")), err_path_(capture_path(".err")) {
  std::vector<std::string> words{PROOFREEL_PROGRAM};
  words.insert(words.end(), arguments.begin(), arguments.end());
  std::vector<char*> argv;
  for (std::string& word : words) argv.push_back(word.data());
  argv.push_back(nullptr);
  pid_ = ::fork();
  if (pid_ < 0) throw std::runtime_error("fork failed");
  if (pid_ > 0) return;
  redirect(STDOUT_FILENO, out_path_);
  redirect(STDERR_FILENO, err_path_);
  for (const char* name : {"CI", "GITHUB_ACTIONS", "GITHUB_WORKSPACE"}) ::unsetenv(name);
  for (const auto& [name, value] : environment) ::setenv(name.c_str(), value.c_str(), 1);
  if (::chdir(folder.c_str()) == 0) ::execv(argv[0], argv.data());
  ::_exit(127);
}

void Program::send(int signal) const { ::kill(pid_, signal); }

Outcome Program::wait() {
  int status = 0;
  ::waitpid(pid_, &status, 0);
  Outcome outcome;
  if (WIFEXITED(status)) outcome.status = WEXITSTATUS(status);
  if (WIFSIGNALED(status)) outcome.signal = WTERMSIG(status);
  outcome.out = take(out_path_);
  outcome.err = take(err_path_);
  return outcome;
}

Outcome proofreel_program(const std::vector<std::string>& arguments, const std::string& folder,
                          const Program::Environment& environment) {
  return Program(arguments, folder, environment).wait();
}

}  // namespace proofreel
