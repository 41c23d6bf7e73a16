#pragma once

/// How much a step has to do, counted: the same number on every machine, unlike time. Off unless somebody asks
/// (Simulation::count_work); then solvers add to the account of the simulation that this thread is stepping.

#include <cstddef>
#include <cstdint>

namespace proofreel {

struct WorkDone {
  std::int64_t row_updates = 0;  ///< how often a row of a constraint (a contact's normal or friction, one direction of
                                 ///< a joint) was given a new impulse; several times in a sweep or round that repeats
  std::int64_t evaluations = 0;  ///< how often it was asked what moves a body
};

/// Of the simulation that counts; null while none does.
inline constinit thread_local WorkDone* counted_work = nullptr;

inline void count_row_updates(std::size_t rows) {
  if (counted_work != nullptr) counted_work->row_updates += static_cast<std::int64_t>(rows);
}

/// The account is open as long as this lives.
class CountingWork {
 public:
  explicit CountingWork(WorkDone* account) { counted_work = account; }
  ~CountingWork() { counted_work = nullptr; }
  CountingWork(const CountingWork&) = delete;
  CountingWork& operator=(const CountingWork&) = delete;
};

}  // namespace proofreel
