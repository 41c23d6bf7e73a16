#include "lab/child.h"

#include <fcntl.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cmath>
#include <csignal>
#include <cstring>
#include <stdexcept>
#include <utility>

#include "scenarios/environment_error.h"

namespace proofreel {
namespace {

enum ExitStatus { done = 0, threw = 1, threw_of_environment = 3 };

void write_all(int file, const std::string& bytes) {
  std::size_t written = 0;
  while (written < bytes.size()) {
    const ssize_t count = ::write(file, bytes.data() + written, bytes.size() - written);
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) return;
    written += static_cast<std::size_t>(count);
  }
}

ExitStatus answer_with(const std::function<std::string()>& work, int file) {
  try {
    write_all(file, work());
    return done;
  } catch (const EnvironmentError& error) {
    write_all(file, error.what());
    return threw_of_environment;
  } catch (const std::exception& error) {
    write_all(file, error.what());
    return threw;
  }
}

/// Its CPU time ends with SIGXCPU, and with its parent it ends too. What the parent does on signals is its business.
void obey(pid_t parent, double cpu_limit_s) {
  for (int signal = 1; signal < SIGRTMIN; ++signal) ::signal(signal, SIG_DFL);
  ::prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (::getppid() != parent) ::_exit(threw);
  const auto seconds = static_cast<rlim_t>(std::ceil(cpu_limit_s));
  const rlimit cpu{seconds, seconds + 1};
  ::setrlimit(RLIMIT_CPU, &cpu);
  const rlimit no_core{0, 0};
  ::setrlimit(RLIMIT_CORE, &no_core);
}

/// The last line of what was said, without the spaces around it.
std::string last_words(int file) {
  std::array<char, 4096> text{};
  const off_t size = ::lseek(file, 0, SEEK_END);
  const off_t from = std::max<off_t>(0, size - static_cast<off_t>(text.size()));
  const ssize_t count = ::pread(file, text.data(), text.size(), from);
  std::string words(text.data(), static_cast<std::size_t>(std::max<ssize_t>(count, 0)));
  words.erase(words.find_last_not_of(" \t\r\n") + 1);
  words.erase(0, words.find_last_of('\n') + 1);
  return words.erase(0, std::min(words.find_first_not_of(" \t"), words.size()));
}

}  // namespace

Child::Child(const std::function<std::string()>& work, double cpu_limit_s) {
  std::array<int, 2> pipe{};
  if (::pipe2(pipe.data(), O_CLOEXEC) != 0) throw EnvironmentError("This machine has no pipe to spare.");
  answer_file_ = pipe[0];
  words_file_ = ::memfd_create("words", MFD_CLOEXEC);
  const pid_t parent = ::getpid();
  pid_ = ::fork();
  if (pid_ == 0) {
    obey(parent, cpu_limit_s);
    ::dup2(words_file_, STDERR_FILENO);
    ::_exit(answer_with(work, pipe[1]));  // nothing of the parent's is ended twice
  }
  ::close(pipe[1]);
  if (pid_ > 0) return;
  close_files();
  throw EnvironmentError("This machine has no process to spare.");
}

Child::Child(Child&& other) noexcept
    : pid_(std::exchange(other.pid_, -1)),
      answer_file_(std::exchange(other.answer_file_, -1)),
      words_file_(std::exchange(other.words_file_, -1)),
      answer_(std::move(other.answer_)) {}

Child& Child::operator=(Child&& other) noexcept {
  std::swap(pid_, other.pid_);
  std::swap(answer_file_, other.answer_file_);
  std::swap(words_file_, other.words_file_);
  std::swap(answer_, other.answer_);
  return *this;
}

Child::~Child() {
  if (pid_ > 0) {
    ::kill(pid_, SIGKILL);
    ::waitpid(pid_, nullptr, 0);
  }
  close_files();
}

void Child::close_files() {
  for (int* file : {&answer_file_, &words_file_}) {
    if (*file >= 0) ::close(std::exchange(*file, -1));
  }
}

bool Child::take() {
  std::array<char, 65536> bytes{};
  const ssize_t count = ::read(answer_file_, bytes.data(), bytes.size());
  if (count > 0) answer_.append(bytes.data(), static_cast<std::size_t>(count));
  return count > 0 || (count < 0 && errno == EINTR);
}

ChildEnd Child::end() {
  while (take()) {
  }
  int status = 0;
  while (::waitpid(pid_, &status, 0) < 0 && errno == EINTR) {
  }
  pid_ = -1;
  if (WIFEXITED(status) && WEXITSTATUS(status) == done) return {std::move(answer_), false, {}};
  if (WIFEXITED(status) && WEXITSTATUS(status) == threw_of_environment) throw EnvironmentError(answer_);
  if (WIFEXITED(status)) throw std::runtime_error(answer_);
  const int signal = WTERMSIG(status);
  if (signal == SIGXCPU || signal == SIGKILL) return {{}, true, {}};
  const std::string words = last_words(words_file_);
  return {{}, false, std::string(::strsignal(signal)).append(words.empty() ? "" : ": ").append(words)};
}

}  // namespace proofreel
