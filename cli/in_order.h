#pragma once

#include <algorithm>
#include <condition_variable>
#include <cstddef>
#include <exception>
#include <functional>
#include <mutex>
#include <optional>
#include <thread>
#include <vector>

namespace proofreel {

/// How many things to do side by side: as many as asked for, or one for every core.
inline int jobs_or_cores(int jobs) {
  return jobs > 0 ? jobs : std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
}

/// Does things on several threads and hands over what came of each in order, on the calling thread: what is told looks
/// the same whatever the number of threads.
template <typename Result>
class InOrder {
 public:
  using Worker = std::function<Result(std::size_t)>;  ///< does thing number i

  /// `make_worker` is called on every thread that has something to do, so that each can have things of its own.
  explicit InOrder(std::function<Worker()> make_worker) : make_worker_(std::move(make_worker)) {}

  /// Does `count` things on up to `jobs` threads. When one fails, those before it are still handed over, no further
  /// ones are begun, and its exception is thrown.
  void run(std::size_t count, int jobs, const std::function<void(Result)>& take) {
    outcomes_ = std::vector<Outcome>(count);
    std::vector<std::jthread> threads;
    const std::size_t workers = std::min(count, static_cast<std::size_t>(std::max(1, jobs)));
    for (std::size_t i = 0; i < workers; ++i) threads.emplace_back([this] { work(); });
    try {
      for (std::size_t i = 0; i < count; ++i) take(wait_for(i));
    } catch (...) {
      begin_no_more();
      throw;
    }
  }

 private:
  struct Outcome {
    std::optional<Result> result;
    std::exception_ptr error;
  };

  std::optional<std::size_t> begin_next() {
    const std::lock_guard lock(mutex_);
    return next_ < outcomes_.size() ? std::optional(next_++) : std::nullopt;
  }

  void begin_no_more() {
    const std::lock_guard lock(mutex_);
    next_ = outcomes_.size();
  }

  void finish(std::size_t i, Outcome outcome) {
    if (outcome.error) begin_no_more();
    const std::lock_guard lock(mutex_);
    outcomes_[i] = std::move(outcome);
    done_.notify_one();
  }

  Result wait_for(std::size_t i) {
    std::unique_lock lock(mutex_);
    done_.wait(lock, [&] { return outcomes_[i].result || outcomes_[i].error; });
    if (outcomes_[i].error) std::rethrow_exception(outcomes_[i].error);
    Result result = std::move(*outcomes_[i].result);
    outcomes_[i].result.reset();
    return result;
  }

  void work() {
    Worker worker;
    while (const std::optional<std::size_t> i = begin_next()) {
      try {
        if (!worker) worker = make_worker_();
        finish(*i, {worker(*i), nullptr});
      } catch (...) {
        finish(*i, {std::nullopt, std::current_exception()});
      }
    }
  }

  std::function<Worker()> make_worker_;
  std::mutex mutex_;
  std::condition_variable done_;
  std::vector<Outcome> outcomes_;
  std::size_t next_ = 0;
};

}  // namespace proofreel
