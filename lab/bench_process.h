#pragma once

/// Clocks, and the program itself run as a child process and measured from outside.

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace proofreel {

/// Seconds on the clock, and of all cores together.
struct Cost {
  double wall_s = 0;
  double cpu_s = 0;
};

/// Time since it was made, in this process.
class Stopwatch {
 public:
  Stopwatch();
  Cost elapsed() const;

 private:
  Cost start_;
};

double median(std::vector<double> values);
/// Each on its own.
Cost median(const std::vector<Cost>& costs);

/// Runs proofreel to its end, from the start of the process to its last byte. Throws std::runtime_error when it fails.
Cost cost_of_program(const std::vector<std::string>& arguments);

/// The most memory proofreel held at once while it ran, bytes. Throws std::runtime_error when it fails.
std::int64_t peak_memory_of_program(const std::vector<std::string>& arguments);

/// An empty folder that goes away with all in it.
class TemporaryFolder {
 public:
  TemporaryFolder();
  ~TemporaryFolder();
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;
  std::string operator/(const std::string& name) const { return (path_ / name).string(); }

 private:
  std::filesystem::path path_;
};

}  // namespace proofreel
