#include "lab/children.h"

#include <poll.h>

#include <vector>

namespace proofreel {
namespace {

constexpr int pause_ms = 200;

struct Running {
  std::size_t index;
  Child child;
};

/// Waits for a while, and hands over what has ended; how many that were. `look_up` may stop it all before anything that
/// died of the same signal is taken for a result.
std::int64_t finish_some(std::vector<Running>& running, const std::function<void(std::size_t, const ChildEnd&)>& keep,
                         const std::function<void()>& look_up) {
  std::vector<pollfd> files;
  for (const Running& each : running) files.push_back({each.child.file(), POLLIN, 0});
  ::poll(files.data(), files.size(), pause_ms);
  look_up();
  std::int64_t ended = 0;
  for (std::size_t i = files.size(); i-- > 0;) {
    if (files[i].revents == 0 || running[i].child.take()) continue;
    keep(running[i].index, running[i].child.end());
    running.erase(running.begin() + static_cast<std::ptrdiff_t>(i));
    ++ended;
  }
  return ended;
}

}  // namespace

void work_off_children(std::size_t count, int at_once, const std::function<ChildWork(std::size_t)>& work_of,
                       const std::function<void(std::size_t, const ChildEnd&)>& keep, const WorkProgress& progress) {
  const auto total = static_cast<std::int64_t>(count);
  std::vector<Running> running;
  std::size_t next = 0;
  std::int64_t done = 0;
  const auto look_up = [&] { progress(done, total); };
  while (done < total) {
    for (; next < count && running.size() < static_cast<std::size_t>(at_once); ++next) {
      const ChildWork work = work_of(next);
      running.push_back({next, Child(work.work, work.cpu_limit_s)});
    }
    look_up();
    done += finish_some(running, keep, look_up);
  }
  progress(total, total);
}

}  // namespace proofreel
