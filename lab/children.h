#pragma once

/// Many pieces of work, each in a process of its own, some of them at a time.

#include <cstdint>
#include <functional>
#include <string>

#include "lab/child.h"

namespace proofreel {

/// Called after every finished piece, and now and then while they go on; may throw to stop.
using WorkProgress = std::function<void(std::int64_t done, std::int64_t total)>;

struct ChildWork {
  std::function<std::string()> work;  ///< see Child
  double cpu_limit_s = 0;
};

/// Does the work of the indices 0 to `count` - 1, `at_once` at a time, and hands every end to `keep` as soon as it is
/// there, in whatever order. What is thrown by `keep` and `progress` ends all of it.
void work_off_children(std::size_t count, int at_once, const std::function<ChildWork(std::size_t)>& work_of,
                       const std::function<void(std::size_t, const ChildEnd&)>& keep, const WorkProgress& progress);

}  // namespace proofreel
