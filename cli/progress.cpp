#include "cli/progress.h"

#include <unistd.h>

#include <cstdio>

namespace proofreel {
namespace {

constexpr auto pause_between_updates = std::chrono::milliseconds(100);
constexpr const char* wipe_line = "\r\033[K";

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
  const double rate = static_cast<double>(done) / seconds;
  std::fprintf(stderr, "%s%lld of %lld %s, %.0f per second, %.0f s left", wipe_line, static_cast<long long>(done),
               static_cast<long long>(total), unit_.c_str(), rate, static_cast<double>(total - done) / rate);
  std::fflush(stderr);
}

}  // namespace proofreel
