#include "lab/bench_process.h"

#include <spawn.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cassert>
#include <chrono>
#include <ctime>
#include <fstream>
#include <stdexcept>
#include <thread>

namespace proofreel {
namespace {

double seconds_of(clockid_t clock) {
  timespec now{};
  clock_gettime(clock, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

double seconds_of(const timeval& time) {
  return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
}

Cost now() { return {seconds_of(CLOCK_MONOTONIC), seconds_of(CLOCK_PROCESS_CPUTIME_ID)}; }

pid_t start_program(const std::vector<std::string>& arguments) {
  std::vector<std::string> words{PROOFREEL_PROGRAM};
  words.insert(words.end(), arguments.begin(), arguments.end());
  std::vector<char*> argv;
  for (std::string& word : words) argv.push_back(word.data());
  argv.push_back(nullptr);
  pid_t child = 0;
  // Unlike fork, this costs the same however much memory the benchmark itself holds.
  if (posix_spawn(&child, argv[0], nullptr, nullptr, argv.data(), environ) != 0)
    throw std::runtime_error(std::string("Cannot start ") + PROOFREEL_PROGRAM + ".");
  return child;
}

void must_have_succeeded(int status, const std::vector<std::string>& arguments) {
  if (WIFEXITED(status) && WEXITSTATUS(status) == 0) return;
  std::string command = "proofreel";
  for (const std::string& argument : arguments) command.append(" ").append(argument);
  throw std::runtime_error("This failed: " + command);
}

/// The largest resident set so far; 0 once the process has ended. What wait4 says instead counts this process's own
/// memory too, as the child starts out in it.
std::int64_t peak_memory(pid_t process) {
  std::ifstream status("/proc/" + std::to_string(process) + "/status");
  std::string word;
  while (status >> word) {
    std::int64_t kilobytes = 0;
    if (word == "VmHWM:" && status >> kilobytes) return kilobytes * 1024;
  }
  return 0;
}

}  // namespace

Stopwatch::Stopwatch() : start_(now()) {}

Cost Stopwatch::elapsed() const {
  const Cost end = now();
  return {end.wall_s - start_.wall_s, end.cpu_s - start_.cpu_s};
}

double median(std::vector<double> values) {
  assert(!values.empty());
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

Cost median(const std::vector<Cost>& costs) {
  std::vector<double> wall;
  std::vector<double> cpu;
  for (const Cost& cost : costs) {
    wall.push_back(cost.wall_s);
    cpu.push_back(cost.cpu_s);
  }
  return {median(wall), median(cpu)};
}

Cost cost_of_program(const std::vector<std::string>& arguments) {
  const Stopwatch watch;
  const pid_t child = start_program(arguments);
  int status = 0;
  rusage used{};
  wait4(child, &status, 0, &used);
  const double wall_s = watch.elapsed().wall_s;
  must_have_succeeded(status, arguments);
  return {wall_s, seconds_of(used.ru_utime) + seconds_of(used.ru_stime)};
}

std::int64_t peak_memory_of_program(const std::vector<std::string>& arguments) {
  const pid_t child = start_program(arguments);
  std::int64_t peak = 0;
  int status = 0;
  while (waitpid(child, &status, WNOHANG) == 0) {
    peak = std::max(peak, peak_memory(child));
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  }
  must_have_succeeded(status, arguments);
  return peak;
}

TemporaryFolder::TemporaryFolder()
    : path_(std::filesystem::temp_directory_path() / ("proofreel-bench-" + std::to_string(::getpid()))) {
  std::filesystem::create_directories(path_);
}

TemporaryFolder::~TemporaryFolder() {
  std::error_code ignored;
  std::filesystem::remove_all(path_, ignored);
}

}  // namespace proofreel
