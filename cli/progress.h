#pragma once

#include <chrono>
#include <cstdint>
#include <string>

namespace proofreel {

/// One line on the terminal that says how far long work has come, how fast, and how long it will still take. Off a
/// terminal, or when `quiet`, it says nothing.
class ProgressLine {
 public:
  /// `unit` is what is counted: "frames".
  ProgressLine(std::string unit, bool quiet);
  /// Wipes the line away.
  ~ProgressLine();
  ProgressLine(const ProgressLine&) = delete;
  ProgressLine& operator=(const ProgressLine&) = delete;

  void update(std::int64_t done, std::int64_t total);

 private:
  using Clock = std::chrono::steady_clock;

  std::string unit_;
  bool shown_;
  Clock::time_point start_ = Clock::now();
  Clock::time_point last_ = start_;
};

}  // namespace proofreel
