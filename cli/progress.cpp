#include "cli/progress.h"

#include <unistd.h>

#include <cstdio>

#include "scenarios/formatted.h"

namespace proofreel {
namespace {

constexpr auto pause_between_updates = std::chrono::milliseconds(100);
constexpr const char* wipe_line = "\r\033[K";

/// In the unit that needs no more than three digits.
std::string duration_text(double seconds) {
  if (seconds < 100) return formatted("%.0f s", seconds);
  return seconds < 6000 ? formatted("%.0f min", seconds / 60) : formatted("%.1f h", seconds / 3600);
}

/// ", 120 per second, 3 s left"; what takes longer than a second is told by its duration.
std::string pace_text(double each_s, std::int64_t left) {
  const std::string pace = each_s < 1 ? formatted("%.0f per second", 1 / each_s) : formatted("%.1f s each", each_s);
  return ", " + pace + ", " + duration_text(each_s * static_cast<double>(left)) + " left";
}

}  // namespace

ProgressLine::ProgressLine(std::string unit, bool quiet)
    : unit_(std::move(unit)), shown_(!quiet && ::isatty(STDERR_FILENO) != 0) {}

ProgressLine::~ProgressLine() {
  if (shown_) std::fputs(wipe_line, stderr);
}

void ProgressLine::update(std::int64_t done, std::int64_t total) {
  const Clock::time_point now = Clock::now();
  if (!shown_ || now - last_ < pause_between_updates) return;
  last_ = now;
  const double seconds = std::chrono::duration<double>(now - start_).count();
  const std::string pace = done > 0 ? pace_text(seconds / static_cast<double>(done), total - done) : std::string();
  std::fprintf(stderr, "%s%lld of %lld %s%s", wipe_line, static_cast<long long>(done), static_cast<long long>(total),
               unit_.c_str(), pace.c_str());
  std::fflush(stderr);
}

}  // namespace proofreel
